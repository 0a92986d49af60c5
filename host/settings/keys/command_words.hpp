// Keys in words of commands.
#pragma once

#include <functional>
#include <string>

namespace poissonlab {

/// The text with keys as commands name them: "method = lloyd" becomes "--method lloyd", and a name of several words,
/// such as min_distance, --min-distance. What is in braces is a table of TOML and stays. `name_of` says what a key is
/// called; an empty name: it is no key.
std::string in_words_of_commands(const std::string& text,
                                 const std::function<std::string(const std::string& key)>& name_of);

}
