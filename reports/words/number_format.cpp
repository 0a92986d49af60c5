#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <regex>
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
    static const std::regex points("\\bN = ([0-9]{4,19})(?![0-9.,]*[0-9])");
    std::string text;
    auto rest = label.cbegin();
    for (std::sregex_iterator match(label.begin(), label.end(), points), end; match != end; ++match) {
        text.append(rest, (*match)[1].first);
        text += format_count(std::stoull((*match)[1]));
        rest = (*match)[1].second;
    }
    return text.append(rest, label.cend());
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

}
