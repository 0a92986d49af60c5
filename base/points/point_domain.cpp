#include "base/points/point_domain.hpp"

#include "base/files/text_lines.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace poissonlab {
namespace {

/// The words between blanks.
std::vector<std::string_view> words_between_blanks(std::string_view text)
{
    std::vector<std::string_view> words;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

/// The range between two numbers.
std::optional<CoordinateRange> range_between(std::string_view low, std::string_view high)
{
    CoordinateRange range;
    if (!parse_number(low, range.low) || !parse_number(high, range.high)) return {};
    // Their difference must be a number, too.
    if (!(range.low < range.high) || !std::isfinite(range.high - range.low)) return {};
    return range;
}

}

std::vector<double> PointDomain::sides() const
{
    std::vector<double> sides;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis)
        sides.push_back(ranges_[axis].high - ranges_[axis].low);
    return sides;
}

bool PointDomain::is_square() const
{
    const std::vector<double> lengths = sides();
    return std::ranges::adjacent_find(lengths, std::not_equal_to{}) == lengths.end();
}

std::optional<CoordinateRange> parse_range(std::string_view text)
{
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos) return range_between("0", text);
    return range_between(text.substr(0, colon), text.substr(colon + 1));
}

std::optional<PointDomain> parse_domain(std::string_view text)
{
    const std::vector<std::string_view> words = words_between_blanks(text);
    const std::size_t count = words.size();
    const bool are_corners = count == 4 || count == 6;
    if (!are_corners && (count == 0 || count > 3)) return {};
    std::vector<CoordinateRange> ranges;
    for (std::size_t i = 0; i < (are_corners ? count / 2 : count); ++i) {
        const auto range = are_corners ? range_between(words[i], words[i + count / 2]) : parse_range(words[i]);
        if (!range) return {};
        ranges.push_back(*range);
    }
    return count == 1 ? PointDomain(ranges.front()) : PointDomain(ranges);
}

}
