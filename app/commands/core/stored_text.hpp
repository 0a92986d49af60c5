// The stored texts are what a program with all modules prints about itself. A program that lacks some prints them.
#pragma once

#include <string>
#include <string_view>

namespace poissonlab {

/// The stored text of "samplers.txt", "kinds.txt", "completion.bash" or "completion.zsh".
std::string_view stored_text(std::string_view name);

// These describe all samplers and kinds. A program that lacks modules has the texts as they are stored; JSON and
// Markdown throw MissingModule there.
std::string all_samplers_json();
std::string all_samplers_markdown();
std::string all_samplers_text();
std::string all_kinds_json();
std::string all_kinds_markdown();
std::string all_kinds_text();

}
