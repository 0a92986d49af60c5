#include "reports/words/measure_words.hpp"

#include "reports/words/number_format.hpp"

namespace poissonlab {
namespace {

std::string rounded(double value, const Digits& digits)
{
    switch (digits.form) {
    case Digits::Form::count:
        return format_count(static_cast<std::uint64_t>(value));
    case Digits::Form::decimals:
        return format_fixed(value, digits.digits);
    case Digits::Form::seconds:
        return format_seconds(value);
    case Digits::Form::significant:
        break;
    }
    return format_significant(value, digits.digits);
}

}

MeasureWords words_of(const Measure& measure, const MeasuredValue& value)
{
    MeasureWords words{rounded(value.value, measure.digits), value.remark};
    if (value.standard_error) words.spread = "± " + format_significant(*value.standard_error, 2);
    if (!value.range) return words;
    const auto low = rounded((*value.range)[0], measure.digits), high = rounded((*value.range)[1], measure.digits);
    if (low != high) words.spread = low + " to " + high;
    return words;
}

}
