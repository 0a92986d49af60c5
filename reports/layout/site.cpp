#include "reports/layout/site.hpp"

#include "base/files/whole_file.hpp"
#include "reports/layout/overlay_panels.hpp"
#include "reports/layout/page_template.hpp"
#include "reports/layout/series_panels.hpp"
#include "results/curve_tables.hpp"

#include <tbb/parallel_for.h>
#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <array>

namespace poissonlab {

namespace {

constexpr auto style_sheet = "report.css";
constexpr std::array assets = {style_sheet, "report.js", "ranking.js", "matrix.js", "compare.js", "steps.js"};

std::string title_of(const std::vector<Run>& runs)
{
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
    if (stored.zone_plate) series.zone_plate = read_zone_plate_table(folder / stored.zone_plate->error_file);
}

/// Everything that a run's pages show, as values.
void lay_out_panels(ReportRun& run)
{
    tbb::parallel_for_each(run.series, read_curves);
    const auto plots = run_plots(run);
    std::vector<std::vector<Panel>> panels(run.series.size());
    tbb::parallel_for(std::size_t{0}, panels.size(), [&](std::size_t i) { panels[i] = series_panels(run, i, plots); });
    for (std::size_t i = 0; i < panels.size(); ++i) run.series[i].panels = std::move(panels[i]);
    const auto series = series_of(run);
    run.overlays = overlay_panels(series);
    run.integration = integration_panels(series);
    run.regions = region_panels(series);
}

}

std::vector<const ReportSeries*> Site::series() const
{
    std::vector<const ReportSeries*> result;
    for (const auto& run : runs)
        for (const auto& entry : run.series) result.push_back(&entry);
    return result;
}

bool Site::has_curves_to_compare() const
{
    const auto all = series();
    return std::ranges::count_if(all, [](const ReportSeries* entry) {
               return entry->stored->has_spectrum() || !entry->pair_correlation.empty();
           }) > 1;
}

std::filesystem::path page_of(const ReportSeries& series) { return series.pictures / "index.html"; }

std::filesystem::path page_of(const ReportRun& run) { return run.root / "index.html"; }

Site make_site(const std::vector<Run>& runs, const std::filesystem::path& out, const std::string& title)
{
    Site site{out, title.empty() ? title_of(runs) : title, lay_out(runs, out), {}, {{overview_page, "Overview"}}};
    tbb::parallel_for_each(site.runs, lay_out_panels);
    site.overlays = site.has_several_runs() ? overlay_panels(series_of(site)) : site.runs.front().overlays;
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
    for (const std::string name : assets) {
        const std::string text(page_template_file("templates/" + name));
        write_whole_file(site.out / asset_folder / name, name == style_sheet ? palette_css() + text : text);
    }
}

}
