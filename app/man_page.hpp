// The manual page of the program, made of the same data as its help.
//
// Help calls options by these words.
#pragma once

#include "app/commands/command.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// A manual page in man(7) format: each command with its options and notes, then `notes`, which are about all of them.
std::string man_page(const std::vector<Command>& commands, const std::string& summary, const std::string& notes);

/// The word for the option's value: its name, or one for its type; empty: a flag, or an argument that is known by its
/// place.
std::string value_word(const Option& option);

}
