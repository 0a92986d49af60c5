// The pages of a report, from the templates in reports/templates/.
#pragma once

#include "reports/claims/paper_claims.hpp"
#include "reports/layout/site.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// The overview: what there is, and all series in a table that sorts. Of a report over one run all that the page of
/// a run has as well; else links to these.
std::string render_overview_page(const Site& site);

/// Curves of all series, chosen and laid over each other by the reader.
std::string render_compare_page(const Site& site);

/// The page of the paper's claims, the measured values, and whether they agree.
std::string render_claims_page(const Site& site, const std::vector<JudgedClaim>& claims);

/// A run of several.
std::string render_run_page(const Site& site, std::size_t index);

/// The steps of a construction that has_steps(), one at a time.
std::string render_steps_page(const Site& site, const ReportRun& run, const ReportConstruction& construction);

/// All about one series: number `index` of the run.
std::string render_series_page(const Site& site, const ReportRun& run, std::size_t index);

}
