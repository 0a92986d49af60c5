// The parts of the page as data for the template; names are those in templates/report.mustache.
#pragma once

#include "reports/report_layout.hpp"

#include <kainjow/mustache.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

using PageData = kainjow::mustache::data;

/// A text, or false (the section is left out) where it is empty.
PageData optional_text(const std::string& text);

/// What every mention of a series needs: label, anchor, color, sampler, parameters, points, realizations.
PageData series_identity(const ReportSeries& series, std::size_t index);

/// One row of the overview table: identity, radius, distance, covered fraction, time.
PageData overview_row(const ReportSeries& series, std::size_t index);

/// Name, value and meaning of each measure.
PageData measures_list(const StoredMeasures& measures);

/// One section: identity, the panels with captions, measures, links to the stored files.
PageData series_section(const ReportSeries& series, std::size_t index, const std::filesystem::path& out);

/// Title, caption, alternative text, the picture itself, and a link to it at full size. `shown` and `linked`
/// are files of the series' pictures.
PageData picture_panel(const ReportSeries& series, const std::filesystem::path& out, const std::string& shown,
                       const std::string& linked, const std::string& title, const std::string& caption);

/// The panels of relative radius and energy over iterations; false for methods without any.
PageData relative_radius_panel(const ReportSeries& series, const std::filesystem::path& out);
PageData energy_panel(const ReportSeries& series, const std::filesystem::path& out);

/// The panels of the sampling test; false for series without.
PageData zone_plate_panel(const ReportSeries& series, const std::filesystem::path& out);
PageData zone_plate_error_panel(const ReportSeries& series, const std::filesystem::path& out);

/// The picture that those of all series are compared with; false where there is none.
PageData zone_plate_reference_panel(const std::vector<ReportSeries>& series,
                                    const std::filesystem::path& out);

/// The plots of integration errors against the number of points, one an integrand; an empty list where there
/// are none.
PageData integration_panels(const std::vector<ReportSeries>& series, const std::filesystem::path& out);

/// One tile set or tiling: facts, pictures, how random its colours are.
PageData tiling_section(const ReportTiling& tiling, std::size_t index, const std::filesystem::path& out);

/// One picture of a construction: facts, the picture, what its panels show.
PageData construction_section(const ReportConstruction& construction, std::size_t index,
                              const std::filesystem::path& out);

/// Where one run comes from: version, command, seed, device, config.
PageData provenance(const StoredRun& run);

/// The scale bar of the report's tone mapping: its powers and where they stand.
PageData tone_scale();

}
