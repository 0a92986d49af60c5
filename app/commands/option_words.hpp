// Help calls options by these words.
#pragma once

#include "app/commands/command.hpp"

#include <string>

namespace poissonlab {

/// The word for the option's value: its name, or one for its type; empty: a flag, or an argument that is known by its
/// place.
std::string value_word(const Option& option);

}
