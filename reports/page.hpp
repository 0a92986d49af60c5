// The HTML page of a report, from the template in reports/templates/.
#pragma once

#include "reports/report_layout.hpp"
#include "reports/stored_results.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// The whole page, with every picture inside; the pictures of all series and tilings must have been drawn.
/// `out` is the folder that the page will lie in: links to stored files are relative to it.
std::string render_page(const std::vector<StoredRun>& runs, const std::vector<ReportSeries>& series,
                        const std::vector<ReportTiling>& tilings,
                        const std::vector<ReportConstruction>& constructions, const std::filesystem::path& out);

}
