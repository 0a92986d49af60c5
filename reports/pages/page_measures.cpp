// The measures of one series, each with its unit and what it means.
#include "reports/pages/page_parts.hpp"
#include "reports/words/measure_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

/// The minimum distance of sets that lie in a region or a box, in its units, as people know them.
void change_to_own_unit(Measure& measure, MeasuredValue& value, const OwnUnit& own)
{
    measure.unit = own.name;
    value.value *= own.lengths;
    if (value.standard_error) *value.standard_error *= own.lengths;
    for (double& each : value.each) each *= own.lengths;
    if (value.range)
        for (double& end : *value.range) end *= own.lengths;
}

}

PageData measures_list(const ReportSeries& series)
{
    PageData list{PageData::type::list};
    for (Measure measure : measures()) {
        auto value = measure.meaning.empty() ? std::nullopt : measure.get(*series.stored);
        if (!value) continue;
        if (const auto own = own_unit(*series.stored); own && measure.key == "min_distance")
            change_to_own_unit(measure, *value, *own);
        const MeasureWords words = words_of(measure, *value);
        PageData data;
        data.set("key", measure.key);
        const auto in_words = [&](const std::string& text) { return in_dimension(text, series.run->dimension); };
        data.set("name", in_words(measure.title() + (measure.unit.empty() ? "" : " (" + measure.unit + ")")));
        data.set("value", words.shown);
        data.set("exact", format_exact(value->value));
        std::string error = words.spread;
        if (!words.range.empty()) error += fmt::format("{}sets from {}", error.empty() ? "" : "; ", words.range);
        data.set("error", optional_text(error));
        data.set("meaning", in_words(measure.meaning));
        list << data;
    }
    return list;
}

}
