// Examples of kinds of work that the manual shows: the files of docs/kinds come with the program.
#pragma once

#include <string_view>

namespace poissonlab {

/// The text of one. Throws std::out_of_range where there is none.
std::string_view example_file(std::string_view name);

}
