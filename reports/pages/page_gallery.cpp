// The table of a run's series beside the methods of the gallery.
#include "reports/pages/gallery_words.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/pages/ranking_order.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <array>

namespace poissonlab {

namespace {

constexpr std::array gallery_columns = {
    "relative_radius",    "mean_nearest_distance",    "effective_nyquist",       "oscillation",
    "low_frequency_mean", "hyperuniformity_exponent", "hyperuniformity_p_value", "anisotropy_above_chance"};

PageData gallery_cell(const Measure& measure, const std::optional<MeasuredValue>& value)
{
    PageData data;
    const MeasureWords words = value ? words_of(measure, *value) : MeasureWords{"–", {}, {}};
    data.set("value", words.shown);
    data.set("spread", optional_text(words.spread));
    return data;
}

template <class Value>
PageData gallery_row(const std::string& label, bool is_own, std::size_t sets, const Value& value)
{
    PageData cells{PageData::type::list};
    PageData count;
    count.set("value", format_count(sets));
    count.set("spread", false);
    cells << count;
    for (const char* key : gallery_columns) cells << gallery_cell(measure(key), value(measure(key)));
    PageData row;
    row.set("label", label);
    row.set("own", is_own);
    row.set("cells", cells);
    return row;
}

/// Runs of more series have a ranking, where readers look first.
constexpr std::size_t most_judged = 3;

/// These measures depend on the number of sets as well: only methods with as many can be compared by them.
bool depends_on_sets(std::string_view key) { return key == "oscillation" || key == "low_frequency_mean"; }

/// Tells which methods are better than each series that can be compared with them. Lattices would be the best by most
/// measures: methods with preferred directions are left out.
PageData judged_series(const ReportRun& run, std::vector<const GalleryMethod*> gallery)
{
    PageData judged{PageData::type::list};
    if (run.series.size() > most_judged) return judged;
    std::erase_if(gallery, [](const GalleryMethod* method) {
        const auto directions = value_in_gallery(*method, measure("anisotropy_above_chance"));
        return directions && directions->value > 0;
    });
    for (const ReportSeries& series : run.series) {
        if (!is_ranked(series)) continue;
        const int sets = static_cast<int>(series.stored->realizations);
        std::vector<const GalleryMethod*> as_many = gallery;
        std::erase_if(as_many, [&](const GalleryMethod* method) { return method->curve.periodograms != sets; });
        PageData lines{PageData::type::list};
        for (const char* key : gallery_columns) {
            const auto& methods = depends_on_sets(key) ? as_many : gallery;
            if (const auto words = better_in_gallery(measure(key), *series.stored, run.stored->dimension, methods);
                !words.empty())
                lines << words;
        }
        PageData entry;
        entry.set("label", series.label);
        entry.set("lines", lines);
        judged << entry;
    }
    return judged;
}

}

PageData gallery_table(const Site& site, const ReportRun& run)
{
    const auto gallery = reference_gallery(run.stored->dimension);
    if (site.gallery_use == Gallery::offered || gallery.empty()) return false;
    PageData columns{PageData::type::list};
    PageData sets;
    sets.set("title", "Sets K");
    sets.set("unit", false);
    columns << sets;
    for (const char* key : gallery_columns) {
        PageData column;
        column.set("title", in_dimension(measure(key).title(), run.stored->dimension));
        column.set("unit", optional_text(in_dimension(measure(key).unit, run.stored->dimension)));
        columns << column;
    }
    PageData rows{PageData::type::list};
    for (const ReportSeries& series : run.series)
        rows << gallery_row(series.label, true, static_cast<std::size_t>(series.stored->realizations),
                            [&](const Measure& measure) { return measure.get(*series.stored); });
    for (const GalleryMethod* method : gallery)
        rows << gallery_row(fmt::format("{}, N = {}", method->label, format_count(method->curve.points)), false,
                            static_cast<std::size_t>(method->curve.periodograms),
                            [&](const Measure& measure) { return value_in_gallery(*method, measure); });
    PageData table;
    table.set("columns", columns);
    table.set("rows", rows);
    table.set("judged", judged_series(run, gallery));
    return table;
}

}
