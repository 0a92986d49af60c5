// The measures of one series, each with its unit and what it means.
#include "reports/pages/page_parts.hpp"
#include "reports/words/measure_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

namespace poissonlab {

PageData measures_list(const ReportSeries& series)
{
    PageData list{PageData::type::list};
    for (const Measure& measure : measures()) {
        const auto value = measure.meaning.empty() ? std::nullopt : measure.get(*series.stored);
        if (!value) continue;
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
