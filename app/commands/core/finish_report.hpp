// The last step of every command that makes a report.
#pragma once

#include "experiment/run/progress.hpp"
#include "reports/gallery/gallery_use.hpp"
#include "reports/plots/print_pictures.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

/// Writes the report and prints the path of its page.
void finish_report(const std::vector<std::filesystem::path>& folders, const std::filesystem::path& out,
                   Progress& progress, PrintPictures print = PrintPictures::none, Gallery gallery = Gallery::offered);

}
