// The stored texts are what a program with all modules prints about itself. A program that lacks some prints them.
#pragma once

#include <string_view>

namespace poissonlab {

/// The stored text of "samplers.txt", "kinds.txt", "completion.bash" or "completion.zsh".
std::string_view stored_text(std::string_view name);

}
