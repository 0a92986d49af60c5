#include "reports/layout/site.hpp"

#include "base/files/whole_file.hpp"
#include "base/programs/side_by_side.hpp"
#include "reports/layout/overlay_panels.hpp"
#include "reports/layout/page_template.hpp"
#include "reports/layout/series_panels.hpp"
#include "results/curve_tables.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace poissonlab {

namespace {

constexpr auto style_sheet = "report.css";
constexpr std::array assets = {
    "templates/report.css",       "templates/report.js",          "templates/ranking.js",
    "templates/matrix.js",        "templates/compare_chart.js",   "templates/compare.js",
    "templates/compare_hands.js", "templates/steps.js",           "templates/webgl.js",
    "templates/endless_parts.js", "templates/endless_density.js", "templates/endless_canvas.js",
    "templates/endless_gl.js",    "templates/endless.js",         "templates/endless_hands.js",
    "templates/plane_hands.js",   "../runtime/poisson_tiles.js"};

std::string title_of(const std::vector<Run>& runs)
{
    constexpr std::size_t most_named = 3;
    if (runs.size() > most_named) return fmt::format("Comparison of {} runs", runs.size());
    std::string title = runs.size() > 1 ? "Comparison: " : "";
    for (std::size_t i = 0; i < runs.size(); ++i) title += (i > 0 ? "; " : "") + runs[i].title;
    return title;
}

void read_curves(ReportSeries& series)
{
    const auto& folder = series.run->folder;
    const auto& stored = *series.stored;
    series.curve = read_curve(*series.run, stored);
    if (!stored.pair_correlation_file.empty())
        series.pair_correlation = read_pair_correlation_table(folder / stored.pair_correlation_file);
    if (!stored.number_variance_file.empty())
        series.number_variance = read_number_variance_table(folder / stored.number_variance_file);
    if (stored.region && !stored.region->file.empty())
        series.region_curves = read_region_curves(folder / stored.region->file);
    if (stored.iterations && !stored.iterations->file.empty())
        series.iterations = read_iterations_table(folder / stored.iterations->file);
    if (stored.zone_plate) series.zone_plate = read_zone_plate_table(folder / stored.zone_plate->error_file);
}

/// The methods of the gallery whose curves can lie behind those of the series.
std::vector<const GalleryMethod*> gallery_for(const Site& site)
{
    std::vector<const GalleryMethod*> methods;
    for (const int dimension : {2, 3})
        if (std::ranges::any_of(site.series(), [&](const ReportSeries* series) {
                return series->stored->has_spectrum() && series->run->dimension == dimension;
            }))
            std::ranges::move(reference_gallery(dimension), std::back_inserter(methods));
    return methods;
}

/// Everything that a run's pages show, as values.
void lay_out_panels(ReportRun& run)
{
    for_each_side_by_side(run.series, read_curves);
    const auto plots = run_plots(run);
    std::vector<std::vector<Panel>> panels(run.series.size());
    for_all_side_by_side(panels.size(), [&](std::size_t i) { panels[i] = series_panels(run, i, plots); });
    for (std::size_t i = 0; i < panels.size(); ++i) run.series[i].panels = std::move(panels[i]);
    const auto series = series_of(run);
    run.overlays = overlay_panels(series);
    run.integration = integration_panels(series);
    run.regions = region_panels(series);
    run.tile_radii = tile_radius_panels(series);
    for_each_side_by_side(run.distributions, lay_out_curves);
}

}

std::vector<const ReportSeries*> Site::series() const
{
    std::vector<const ReportSeries*> result;
    for (const auto& run : runs)
        for (const auto& entry : run.series) result.push_back(&entry);
    return result;
}

std::vector<const DistributionResult*> Site::distributions() const
{
    std::vector<const DistributionResult*> result;
    for (const auto& run : runs) {
        for (const auto& distribution : run.distributions) result.push_back(distribution.stored);
        for (const auto& scheme : run.schemes) result.push_back(scheme.stored);
    }
    return result;
}

bool Site::has_curves_to_compare() const
{
    const auto all = series();
    return !gallery.empty() || std::ranges::count_if(all, [](const ReportSeries* entry) {
                                   return entry->stored->has_spectrum() || !entry->pair_correlation.empty();
                               }) > 1;
}

std::filesystem::path page_of(const ReportSeries& series) { return series.pictures / "index.html"; }

std::filesystem::path page_of(const ReportRun& run) { return run.root / "index.html"; }

std::filesystem::path tile_set_of(const ReportSeries& series)
{
    return series.run->folder / series.stored->name / file_names::tile_set;
}

bool has_endless_page(const ReportSeries& series)
{
    std::error_code error;
    return series.run->dimension == 2 && std::filesystem::exists(tile_set_of(series), error);
}

std::filesystem::path endless_page_of(const ReportSeries& series) { return series.pictures / "endless.html"; }

Site make_site(const std::vector<Run>& runs, const std::filesystem::path& out, const std::string& title,
               Gallery gallery)
{
    Site site{out,    title.empty() ? title_of(runs) : title, lay_out(runs, out), {}, {{overview_page, "Overview"}}, {},
              gallery};
    for_each_side_by_side(site.runs, lay_out_panels);
    if (gallery == Gallery::laid_behind)
        for (ReportRun& run : site.runs)
            std::ranges::move(gallery_panels(series_of(run), gallery_choice(run.stored->dimension)),
                              std::back_inserter(run.overlays));
    site.overlays = site.has_several_runs() ? overlay_panels(series_of(site)) : site.runs.front().overlays;
    site.gallery = gallery_for(site);
    if (site.has_curves_to_compare()) site.pages.push_back({compare_page, "Compare"});
    return site;
}

SeriesList series_of(const Site& site)
{
    SeriesList list;
    for (const ReportSeries* series : site.series()) list.push_back({series, series->full_label});
    return list;
}

void write_assets(const Site& site)
{
    for (const std::filesystem::path file : assets) {
        const std::string text(page_template_file(file.string()));
        const auto name = file.filename();
        write_whole_file(site.out / asset_folder / name, name == style_sheet ? palette_css() + text : text);
    }
}

}
