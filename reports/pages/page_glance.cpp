// The series of a small run at a glance: the four pictures of the field's papers beside each other, and a sentence that
// says what each series is good for and what it is not.
#include "reports/pages/page_parts.hpp"
#include "reports/pages/relative_link.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

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
