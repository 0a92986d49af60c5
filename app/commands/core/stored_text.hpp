// What a program with all modules prints about itself, for one that lacks some.
#pragma once

#include <string_view>

namespace poissonlab {

/// The stored text of "samplers.txt", "kinds.txt", "completion.bash" or "completion.zsh".
std::string_view stored_text(std::string_view name);

}
