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

/// A JSON text that may stand in HTML, with its quotes.
std::string script_text(const std::string& text);

/// "OpenCL" for "opencl".
std::string engine_words(const std::string& engine);

/// The data that every mention of a series needs: label, color, sampler, parameters, points, realizations.
PageData series_identity(const ReportSeries& series, std::size_t index);

/// The mean of a quantity with so many significant digits, and its exact value; false where there is none.
PageData shown_mean(const std::optional<Statistic>& value, int digits);

/// "mean ρ = 0.752", or "ρ = 0.752" of one set; empty where there is none.
std::string radius_words(const Series& series, int digits);

/// Name, value with error, and meaning of each measure.
PageData measures_list(const ReportSeries& series);

/// A picture of a series' page, and links to its files.
PageData panel_data(const ReportSeries& series, const Panel& panel);
PageData panel_files(const ReportSeries& series, const Panel& panel);

/// The folder of plots of several series, and the page that shows them.
struct PlotPlace
{
    std::filesystem::path plots;
    std::filesystem::path page_folder;
};

/// Plots of several curves with legends, which lead to the series' pages where `series` is not empty.
PageData overlays(const std::vector<Panel>& panels, const SeriesList& series, const PlotPlace& place);

/// One tile set or tiling: facts, pictures, how random its colours are.
PageData tiling_section(const ReportTiling& tiling, std::size_t index, const std::filesystem::path& page_folder);

/// The subject of a construction, and the meaning of the colours of its points.
PageData construction_facts(const ConstructionResult& stored);
std::string construction_legend(const ReportConstruction& construction);

/// One picture of a construction: facts, the picture, what its panels show.
PageData construction_section(const ReportConstruction& construction, std::size_t index,
                              const std::filesystem::path& page_folder);

enum class PageNumbers
{
    shown,
    elsewhere ///< another table of the page has them
};

/// One distribution or scheme: facts, numbers, pictures, tables. `anchor` is its place on the page. Numbers that one of
/// its own tables has are not shown again.
PageData distribution_section(const ReportDistribution& distribution, const std::string& anchor,
                              const std::filesystem::path& page_folder, PageNumbers numbers = PageNumbers::shown);

/// Sets `packings`, `distributions` and `schemes` of a run, and if there are any. Several of them that have one picture
/// each share a figure and a table; others have a section each.
void set_distributions(PageData& page, const ReportRun& run, const std::filesystem::path& page_folder);

/// The textures of a run by their exemplars, each with a table of the measures of its textures where there are several.
/// Sets `texture_groups` and, where there is such a table, `texture_notes`, which say what measures mean.
void set_textures(PageData& page, const ReportRun& run, const std::filesystem::path& page_folder);

/// The methods of a run whose parameters have lists of values, as tables of pictures.
PageData matrices(const ReportRun& run, const std::filesystem::path& page_folder);

/// True if a series is in one of these tables.
bool is_in_matrix(const ReportSeries& series);

/// True if the series of a run, in large runs those that are in no matrix, are few enough to be shown large.
bool has_glance(const ReportRun& run);

/// These series: points, spectrum, radial power and anisotropy beside each other, and a sentence on strengths and
/// weaknesses.
PageData glance(const ReportRun& run, const std::filesystem::path& page_folder);

/// Matrices, series as cards, overlays, integration errors, tilings, constructions and distributions of a run:
/// rendered, and with flags for what there is (has_cards, compared, ...) set in `page`.
std::string render_run(const Site& site, const ReportRun& run, const std::filesystem::path& page_folder,
                       PageData& page);

/// Sets the table of methods, a row each, where many series are of several methods; says whether it did.
bool set_methods(PageData& page, const Site& site);

/// Sets columns, rows, notices and notes of the ranking of all series.
void set_ranking(PageData& page, const Site& site);

/// The measures of a run's series beside those of the gallery; false where that is not laid behind them.
PageData gallery_table(const Site& site, const ReportRun& run);

/// Sets where one run comes from: version, command, seed, device, config.
void set_provenance(PageData& data, const Run& run);

/// The scale bar of the report's tone mapping: its powers and where they stand.
PageData tone_scale();

/// "12 series of 16,384 points ...": what runs hold, in a sentence or two.
std::string summary_of(const std::vector<const ReportRun*>& runs);

/// A sentence on each result that was asked for in runs and is not there.
PageData missing_in(const std::vector<const ReportRun*>& runs);

bool has_dimension(const std::vector<const ReportRun*>& runs, int dimension);

/// Sets what things are called in the dimensions that runs have: disk, ring, lattice.
void set_dimension_words(PageData& page, const std::vector<const ReportRun*>& runs);

}
