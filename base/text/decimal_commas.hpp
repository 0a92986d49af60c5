// Commas that may stand for decimal points, as many languages write them, where commas separate.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace poissonlab {

/// A whole number, a comma and a whole number without blanks, as in "0,5": many languages write decimals so. Empty: the
/// text has none. "0.1,0.2" has none either.
std::string_view decimal_comma_in(std::string_view text);

/// Do commas separate some of the first `count` words, and blanks others? Those between groups of `group` words may
/// differ, as in "0,0 1,5". Otherwise such a comma may stand for a decimal point, as in "0 0 1,5 2".
bool mixes_separators(std::string_view text, std::size_t count, std::size_t group);

/// The end of a message about a text with such a comma, `; the comma of "0,5" is no decimal point: must be 0.5`, or
/// unit_words(); empty where it has neither.
std::string decimal_comma_words(std::string_view text);

/// The end of a message about a text that is a number with a unit: `; this number takes no unit: write 4, in the
/// manual's unit` for "4m", and `write 0.04` for "4%". It leaves out the number if `is_allowed` is false for it, and is
/// empty for other texts.
std::string unit_words(
    std::string_view text, const std::function<bool(double)>& is_allowed = [](double) { return true; });

}
