#include "base/text/decimal_commas.hpp"

#include "base/files/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace poissonlab {

std::string_view decimal_comma_in(std::string_view text)
{
    const auto is_digit = [&](std::size_t at) {
        return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
    };
    const auto goes_on = [&](std::size_t at) { // as a number with a point, or as a name
        return at < text.size() &&
               (std::isalpha(static_cast<unsigned char>(text[at])) != 0 || text[at] == '.' || text[at] == '_');
    };
    for (std::size_t comma = text.find(','); comma != text.npos; comma = text.find(',', comma + 1)) {
        std::size_t begin = comma, end = comma + 1;
        while (begin > 0 && is_digit(begin - 1)) --begin;
        while (is_digit(end)) ++end;
        const bool is_number = begin < comma && end > comma + 1;
        if (is_number && !goes_on(end) && (begin == 0 || !goes_on(begin - 1))) return text.substr(begin, end - begin);
    }
    return {};
}

bool mixes_separators(std::string_view text, std::size_t count, std::size_t group)
{
    bool has_comma = false, has_blank = false;
    WordReader words(text);
    for (std::size_t i = 0; i < count && words.next(); ++i) {
        const auto end = static_cast<std::size_t>(words.word().data() - text.data()) + words.word().size();
        const bool is_comma = trimmed(text.substr(end)).starts_with(',');
        const bool is_between_groups = (i + 1) % group == 0;
        has_comma |= is_comma && (!is_between_groups || i + 1 == count);
        has_blank |= !is_comma && !is_between_groups;
    }
    return has_comma && has_blank;
}

std::string decimal_comma_words(std::string_view text)
{
    const std::string_view found = decimal_comma_in(text);
    if (found.empty()) return unit_words(text);
    std::string number(found);
    std::ranges::replace(number, ',', '.');
    return fmt::format("; the comma of \"{}\" is no decimal point: must be {}", found, number);
}

std::string unit_words(std::string_view text, const std::function<bool(double)>& is_allowed)
{
    constexpr std::array<std::string_view, 14> units{"mm", "cm", "km",     "m",      "in",     "ft",  "yd",
                                                     "mi", "px", "pixels", "metres", "meters", "deg", "%"};
    const std::string_view all = trimmed(text);
    const std::size_t end = all.find_last_of("0123456789.");
    double value = 0;
    if (end == all.npos || !parse_number(all.substr(0, end + 1), value)) return {};
    const std::string_view unit = trimmed(all.substr(end + 1));
    if (std::ranges::find(units, unit) == units.end()) return {};
    const bool is_part = unit == "%";
    if (is_part) value /= 100;
    if (!is_allowed(value)) return "; this number takes no unit";
    return fmt::format("; this number takes no unit: write {:.15g}{}", value, is_part ? "" : ", in the manual's unit");
}

}
