// The ranking of a run's textures: a table of the measures that they have.
#include "reports/pages/page_parts.hpp"
#include "reports/words/measure_words.hpp"
#include "reports/words/number_format.hpp"
#include "results/texture_measures.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

const char* arrow_of(const Measure& measure)
{
    return measure.better == Better::higher  ? "↑ higher is better"
           : measure.better == Better::lower ? "↓ lower is better"
                                             : "";
}

PageData texture_column(const Measure& measure)
{
    PageData data;
    data.set("title", measure.title());
    data.set("unit", measure.unit);
    data.set("arrow", arrow_of(measure));
    return data;
}

PageData texture_cell(const Measure& measure, const DistributionResult& texture)
{
    const auto value = texture_value(measure, texture);
    const MeasureWords words = value ? words_of(measure, *value) : MeasureWords{};
    PageData data;
    data.set("shown", optional_text(words.shown));
    data.set("exact", value ? format_exact(value->value) : "");
    data.set("error", optional_text(words.spread));
    return data;
}

PageData texture_note(const Measure& measure)
{
    PageData data;
    data.set("name", measure.title());
    data.set("text", measure.meaning);
    return data;
}

}

PageData texture_ranking(const ReportRun& run)
{
    PageData columns{PageData::type::list}, rows{PageData::type::list}, notes{PageData::type::list};
    std::size_t count = 0;
    for (std::size_t i = 0; i < run.distributions.size(); ++i) {
        const DistributionResult& texture = *run.distributions[i].stored;
        if (!texture.is_texture()) continue;
        ++count;
        PageData row, cells{PageData::type::list};
        for (const Measure& measure : texture_measures()) cells << texture_cell(measure, texture);
        row.set("label", texture.label);
        row.set("anchor", fmt::format("distribution-{}", i + 1));
        row.set("cells", cells);
        rows << row;
    }
    if (count < 2) return false;
    for (const Measure& measure : texture_measures()) {
        columns << texture_column(measure);
        notes << texture_note(measure);
    }
    PageData data;
    data.set("columns", columns);
    data.set("rows", rows);
    data.set("notes", notes);
    return data;
}

}
