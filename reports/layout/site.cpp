#include "reports/layout/site.hpp"

#include "base/files/whole_file.hpp"
#include "reports/layout/page_template.hpp"
#include "reports/layout/series_pictures.hpp"

#include <tbb/parallel_for_each.h>

#include <algorithm>
#include <array>

namespace poissonlab {

namespace {

constexpr std::array assets = {"report.css", "report.js", "ranking.js", "matrix.js", "compare.js"};

std::string title_of(const std::vector<Run>& runs)
{
    std::string title = runs.size() > 1 ? "Comparison: " : "";
    for (std::size_t i = 0; i < runs.size(); ++i) title += (i > 0 ? "; " : "") + runs[i].title;
    return title;
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
    Site site{out, title.empty() ? title_of(runs) : title, lay_out(runs, out), {{overview_page, "Overview"}}};
    for (auto& run : site.runs) tbb::parallel_for_each(run.series, [](ReportSeries& series) { read_curves(series); });
    if (site.has_curves_to_compare()) site.pages.push_back({compare_page, "Compare"});
    return site;
}

std::vector<ReportSeries> all_series_with_full_labels(const Site& site)
{
    std::vector<ReportSeries> result;
    for (const ReportSeries* series : site.series()) {
        result.push_back(*series);
        result.back().label = result.back().curve.label = series->full_label;
    }
    return result;
}

void write_assets(const Site& site)
{
    for (const char* name : assets)
        write_whole_file(site.out / asset_folder / name,
                         std::string(page_template_file(std::string("templates/") + name)));
}

}
