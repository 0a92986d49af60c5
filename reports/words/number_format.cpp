#include "reports/words/number_format.hpp"

#include "analysis/statistics/jackknife.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace poissonlab {
namespace {

constexpr auto minus_sign = "\u2212";

std::string with_minus_sign(const std::string& text)
{
    return text.starts_with('-') ? minus_sign + text.substr(1) : text;
}

/// 5 -> "⁵", -12 -> "⁻¹²".
std::string superscript(int exponent)
{
    constexpr std::array digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = exponent < 0 ? "⁻" : "";
    for (const char c : std::to_string(std::abs(exponent))) text += digits[static_cast<std::size_t>(c - '0')];
    return text;
}

}

std::string format_count(std::uint64_t value)
{
    const auto digits = std::to_string(value);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

std::string with_formatted_points(const std::string& label)
{
    std::string text = label;
    const auto begins_word = [&](std::size_t at) {
        return at == 0 || !std::isalnum(static_cast<unsigned char>(text[at - 1]));
    };
    constexpr std::string_view points = "N = ", digits = "0123456789", number = "0123456789.,";
    for (std::size_t at = text.find(points); at != std::string::npos; at = text.find(points, at + 1)) {
        const std::size_t begin = at + points.size();
        const std::size_t end = std::min(text.find_first_not_of(digits, begin), text.size());
        const bool is_whole = text.find_first_of(digits, end) >= text.find_first_not_of(number, end);
        if (begins_word(at) && is_whole && end - begin >= 4 && end - begin <= 19)
            text.replace(begin, end - begin, format_count(std::stoull(text.substr(begin, end - begin))));
    }
    constexpr std::string_view spelt = "rho = "; // of results that older versions wrote
    for (std::size_t at = text.find(spelt); at != std::string::npos; at = text.find(spelt, at))
        if (begins_word(at))
            text.replace(at, spelt.size(), "ρ = ");
        else
            at += spelt.size();
    return text;
}

std::string format_significant(double value, int digits)
{
    // The rounded number's exponent decides on the notation, as for printf's %g.
    const auto text = fmt::format("{:.{}e}", value, digits - 1);
    const auto mark = text.find('e');
    if (mark == std::string::npos) return text; // not finite
    const int exponent = std::stoi(text.substr(mark + 1));
    if (exponent >= -4 && exponent < digits)
        return with_minus_sign(fmt::format("{:.{}f}", value, digits - 1 - exponent));
    return with_minus_sign(text.substr(0, mark)) + " × 10" + superscript(exponent);
}

namespace {

/// The exponent of a number's first digit, of one that is not 0.
int exponent_of(double value) { return static_cast<int>(std::floor(std::log10(std::abs(value)))); }

/// The place of the last digit that an error allows, 10^place.
int last_place(double error)
{
    const int exponent = exponent_of(error);
    const double three = std::round(error * std::pow(10.0, 2 - exponent)); // its first digits, 100 to 1000
    return three <= 354 || three >= 950 ? exponent - (three >= 950 ? 0 : 1) : exponent;
}

/// A number that ends at a place: 1,230 or 0.0123, or as a power of ten.
std::string ending_at(double value, int place, bool is_plain)
{
    const double unit = std::pow(10.0, place);
    const double rounded = std::round(value / unit) * unit;
    if (rounded == 0 && (place >= 0 || !is_plain)) return "0";
    if (!is_plain) return format_significant(value, std::max(1, exponent_of(rounded) - place + 1));
    if (place < 0) return format_fixed(value, -place);
    const std::string digits = format_count(static_cast<std::uint64_t>(std::llround(std::abs(rounded))));
    return rounded < 0 ? minus_sign + digits : digits;
}

}

std::string RoundedEstimate::text() const { return error.empty() ? value : value + " ± " + error; }

RoundedEstimate format_estimate(double value, std::optional<double> standard_error, int digits)
{
    constexpr double negligible = 1e-6;
    const bool has_error = standard_error && std::isfinite(*standard_error) && std::isfinite(value) &&
                           *standard_error > negligible * std::abs(value) && *standard_error > 1e-300;
    if (!has_error) return {value == 0 ? "0" : format_significant(value, digits), {}};
    constexpr int least_plain = -4, most_plain = 7;
    const int place = last_place(*standard_error);
    const int first = std::max(value == 0 ? place : exponent_of(value), exponent_of(*standard_error));
    const bool is_plain = first >= least_plain && first < most_plain;
    return {ending_at(value, place, is_plain), ending_at(*standard_error, place, is_plain)};
}

std::string format_fixed(double value, int decimals)
{
    const double unit = std::pow(10.0, -decimals);
    if (std::fabs(value) < 0.5 * unit) value = 0;
    return with_minus_sign(fmt::format("{:.{}f}", value, decimals));
}

std::string format_seconds(double seconds)
{
    const auto [scale, unit] = seconds < 1e-3  ? std::pair{1e6, "µs"}
                               : seconds < 1.0 ? std::pair{1e3, "ms"}
                                               : std::pair{1.0, "s"};
    const double value = seconds * scale;
    return fmt::format("{:.{}f} {}", value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0, unit);
}

std::string format_exact(double value) { return fmt::format("{}", value); }

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
