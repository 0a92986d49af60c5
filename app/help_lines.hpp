// Lines of help that fit a terminal.
#pragma once

#include <cstddef>
#include <string>

namespace poissonlab {

/// The columns that lines of help have at most.
inline constexpr std::size_t help_columns = 100;

/// The text with lines of at most so many columns (bytes), but for longer words. A line that is too long is broken
/// between words; its rest goes before the next line if that has the same indent and belongs to the paragraph: the line
/// before it had no room for its first word. In lists, the second column keeps its place: it begins after two blanks or
/// more. Lines of the shell, "  poissonlab ...", are broken before an option
/// by a backslash. Other lines stay as they are.
std::string within_columns(const std::string& text, std::size_t columns = help_columns);

}
