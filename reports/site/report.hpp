// The report: a small static site with the field's classic figure for every series, made from stored results only.
#pragma once

#include "reports/gallery/gallery_use.hpp"
#include "reports/plots/print_pictures.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// Reads the result folders (results.json and what it names), draws every picture, and writes out/index.html and the
/// pages that it leads to. A folder with a collection.json stands for the runs of that collection.
///
/// With one folder that is also `out`, pictures and pages go beside the results; with several, below out/<folder
/// name>/, which of a collection in `out` is beside its results, too. `progress` is called with a word on each step.
/// Pages show curves as SVG; the PNG of curves, for print, take longer than all else and are drawn where asked for.
/// Throws InputError for folders without readable results.
void write_report(const std::vector<std::filesystem::path>& result_folders, const std::filesystem::path& out,
                  const std::function<void(const std::string&)>& progress = {},
                  PrintPictures print = PrintPictures::none, Gallery gallery = Gallery::offered);

}
