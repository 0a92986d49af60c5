// The parts of pages as data for the templates; names are those in templates/*.mustache.
#pragma once

#include "reports/layout/site.hpp"

#include <kainjow/mustache.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

using PageData = kainjow::mustache::data;

/// A text, or false (the section is left out) where it is empty.
PageData optional_text(const std::string& text);

/// "OpenCL" for "opencl".
std::string engine_words(const std::string& engine);

/// What every mention of a series needs: label, color, sampler, parameters, points, realizations.
PageData series_identity(const ReportSeries& series, std::size_t index);

/// The mean of a quantity with so many significant digits, and its exact value; false where there is none.
PageData shown_mean(const std::optional<Statistic>& value, int digits);

/// "1,708 to 1,754" from the smallest to the largest value, or nothing where both look the same.
std::string shown_range(const Statistic& value, int digits);

/// Name, value with error, and meaning of each measure.
PageData measures_list(const ReportSeries& series);

/// What the guide tells about: one of the names in templates/guide.mustache. False for nothing.
PageData guide_kind(const std::string& kind);

/// The files of a series' panel, and how it looks.
struct PanelPicture
{
    std::string shown;  ///< on the page
    std::string linked; ///< at full size
    std::string guide;  ///< guide_kind()
    std::string image_class = "ink";
    std::string figure_class = {};
};

/// Title, caption, alternative text, the picture, and a link to it at full size.
PageData picture_panel(const ReportSeries& series, const PanelPicture& picture, const std::string& title,
                       const std::string& caption);

/// The panel of Voronoi cells; false in 3D.
PageData cells_panel(const ReportSeries& series);

/// The panels of relative radius and energy over iterations; false for methods without any.
PageData relative_radius_panel(const ReportSeries& series);
PageData energy_panel(const ReportSeries& series);

/// The panels of the sampling test; false for series without.
PageData zone_plate_panel(const ReportSeries& series);
PageData zone_plate_error_panel(const ReportSeries& series);

/// The picture that those of all series of a run are compared with; false where there is none.
PageData zone_plate_reference_panel(const ReportRun& run, const std::filesystem::path& page_folder);

/// Where plots of several series lie, and the page that shows them.
struct OverlayPlace
{
    std::filesystem::path plots;
    std::filesystem::path page_folder;
};

/// The plots of all series, without those that fewer than two series are in.
PageData overlays(const std::vector<ReportSeries>& series, const OverlayPlace& place);

/// The plots of integration errors against the number of points, one an integrand; an empty list where there
/// are none.
PageData integration_panels(const std::vector<ReportSeries>& series, const OverlayPlace& place);

/// The plot of points in regions of tiles; false where there is none.
PageData region_panel(const std::vector<ReportSeries>& series, const OverlayPlace& place);

/// One tile set or tiling: facts, pictures, how random its colours are.
PageData tiling_section(const ReportTiling& tiling, std::size_t index, const std::filesystem::path& page_folder);

/// One picture of a construction: facts, the picture, what its panels show.
PageData construction_section(const ReportConstruction& construction, std::size_t index,
                              const std::filesystem::path& page_folder);

/// The methods of a run whose parameters have lists of values, as tables of pictures.
PageData matrices(const ReportRun& run, const std::filesystem::path& page_folder);

/// Whether a series is in one of these tables.
bool is_in_matrix(const ReportSeries& series);

/// Matrices, series as cards, overlays, integration errors, tilings and constructions of a run: rendered, and with
/// flags for what there is (has_cards, compared, ...) set in `page`.
std::string render_run(const Site& site, const ReportRun& run, const std::filesystem::path& page_folder,
                       PageData& page);

/// Sets columns, rows, notices and notes of the ranking of all series.
void set_ranking(PageData& page, const Site& site);

/// Sets where one run comes from: version, command, seed, device, config.
void set_provenance(PageData& data, const Run& run);

/// The scale bar of the report's tone mapping: its powers and where they stand.
PageData tone_scale();

/// "12 series of 16,384 points ...": what runs hold, in a sentence or two.
std::string summary_of(const std::vector<const ReportRun*>& runs);

bool has_dimension(const std::vector<const ReportRun*>& runs, int dimension);

/// Sets what things are called in the dimensions that runs have: disk, ring, lattice.
void set_dimension_words(PageData& page, const std::vector<const ReportRun*>& runs);

}
