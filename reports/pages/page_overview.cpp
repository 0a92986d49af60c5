// The overview: the ranking of all series, and the runs.
// The series of a small run at a glance: the four pictures of the field's papers beside each other, and a sentence that
// says what each series is good for and what it is not.
#include "reports/layout/thumbnails.hpp"
#include "reports/pages/page.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// "63 series, 2 tilings".
std::string contents_of(const ReportRun& run)
{
    std::string text;
    const auto add = [&](std::size_t count, const char* one, const char* many) {
        if (count > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", format_count(count), count == 1 ? one : many);
    };
    add(run.series.size(), "series", "series");
    add(run.tilings.size(), "tiling", "tilings");
    add(run.constructions.size(), "construction", "constructions");
    const auto add_kind = [&](bool (*is_counted)(const ReportDistribution&), const char* one, const char* many) {
        add(static_cast<std::size_t>(std::ranges::count_if(run.distributions, is_counted)), one, many);
    };
    add_kind(is_of_textures, "texture", "textures");
    add_kind(is_of_packings, "packing", "packings");
    add_kind(is_of_densities, "distribution", "distributions");
    add(run.schemes.size(), "scheme", "schemes");
    return text;
}

PageData figure(const Site& site, const ReportRun& run)
{
    PageData data;
    data.set("title", run.stored->title);
    data.set("what", contents_of(run));
    data.set("link", relative_link(site.out, page_of(run)));
    data.set("source", relative_link(site.out, run.root / run_thumbnail));
    data.set("image_class", "framed");
    data.set("alt", "A picture of " + run.stored->title);
    return data;
}

PageData figures(const Site& site)
{
    PageData list{PageData::type::list};
    for (const auto& run : site.runs) list << figure(site, run);
    return list;
}

/// Empties the parts that a page over several runs has not got of its own.
void clear_run_parts(PageData& page)
{
    for (const char* part :
         {"compared", "integrated", "has_cards", "has_matrices", "has_tilings", "has_constructions", "has_textures",
          "has_packings", "has_distributions", "has_schemes", "gallery", "has_glance"})
        page.set(part, false);
    page.set("content", "");
}

}

std::string render_overview_page(const Site& site)
{
    PageData page;
    std::vector<const ReportRun*> runs;
    for (const auto& run : site.runs) runs.push_back(&run);
    page.set("title", site.title);
    page.set("summary", summary_of(runs));
    page.set("missing", missing_in(runs));
    page.set("has_figures", site.has_several_runs());
    if (site.has_several_runs()) {
        clear_run_parts(page);
        page.set("figures", figures(site));
    } else {
        auto content = render_run(site, site.runs.front(), site.out, page);
        page.set("content", content);
    }
    set_methods(page, site);
    set_ranking(page, site);
    PageData provenances{PageData::type::list};
    for (const auto& run : site.runs) {
        PageData from;
        set_provenance(from, *run.stored);
        provenances << from;
    }
    page.set("provenances", provenances);
    return render_in_frame(site, {site.out / overview_page, site.title, {"ranking.js", "matrix.js"}}, "overview", page);
}

namespace {

/// More series would push everything else off the page: they are cards.
constexpr std::size_t most_at_a_glance = 12;

/// The series of smaller runs are all shown large, those of tables of pictures as well.
constexpr std::size_t most_in_small_run = 6;

PageData glance_pictures(const ReportSeries& series, const std::filesystem::path& page_folder)
{
    PageData list{PageData::type::list};
    for (const char* stem : {"points", "spectrum", "radial", "anisotropy"})
        for (const Panel& panel : series.panels) {
            if (panel.stem != stem) continue;
            PageData data;
            data.set("source", relative_link(page_folder, series.pictures / shown_file(panel)));
            data.set("image_class", panel.image_class);
            data.set("title", panel.title);
            data.set("alt", fmt::format("{}: {}", series.label, panel.title));
            list << data;
        }
    return list;
}

bool is_at_a_glance(const ReportRun& run, const ReportSeries& series)
{
    return run.series.size() <= most_in_small_run || !is_in_matrix(series);
}

}

bool has_glance(const ReportRun& run)
{
    const auto shown = std::ranges::count_if(run.series, [&](const auto& s) { return is_at_a_glance(run, s); });
    return shown > 0 && static_cast<std::size_t>(shown) <= most_at_a_glance;
}

PageData glance(const ReportRun& run, const std::filesystem::path& page_folder)
{
    PageData list{PageData::type::list};
    for (std::size_t i = 0; i < run.series.size(); ++i) {
        const ReportSeries& series = run.series[i];
        if (!is_at_a_glance(run, series)) continue;
        PageData row = series_identity(series, i);
        row.set("link", relative_link(page_folder, page_of(series)));
        row.set("pictures", glance_pictures(series, page_folder));
        row.set("sentence", optional_text(sentence_about(series)));
        row.set("size", fmt::format("N = {}, K = {}", format_count(series.stored->points),
                                    format_count(static_cast<std::uint64_t>(series.stored->realizations))));
        list << row;
    }
    return list;
}

}
