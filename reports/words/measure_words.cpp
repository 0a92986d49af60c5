#include "reports/words/measure_words.hpp"

#include "analysis/statistics/jackknife.hpp"
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

std::optional<double> standard_error_of(const Measure& measure, const MeasuredValue& value)
{
    if (value.standard_error || measure.kind != MeasureKind::per_set || value.each.size() < 2)
        return value.standard_error;
    return standard_error_of_mean(value.each);
}

MeasureWords words_of(const Measure& measure, const MeasuredValue& value)
{
    MeasureWords words{rounded(value.value, measure.digits), value.remark, {}};
    const auto error = standard_error_of(measure, value);
    if (error) {
        const RoundedEstimate estimate = format_estimate(value.value, error, measure.digits.digits);
        if (!estimate.error.empty()) words = {estimate.value, "± " + estimate.error, {}};
    }
    if (!value.range) return words;
    const auto low = rounded((*value.range)[0], measure.digits), high = rounded((*value.range)[1], measure.digits);
    if (low != high) (error ? words.range : words.spread) = low + " to " + high;
    return words;
}

std::optional<OwnUnit> own_unit(const Series& series)
{
    if (series.region)
        return OwnUnit{series.region->unit_length, series.region->is_in_metres ? "m" : "units of the region"};
    if (series.box) return OwnUnit{series.box->unit_length(), "units of the box"};
    return std::nullopt;
}

}
