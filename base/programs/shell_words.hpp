// Words of a command line as a POSIX shell writes them.
//
// wordexp(3) would expand variables and globs; GLib, which has the right function, is too much for these lines.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Splits at blanks; quotes and backslashes keep blanks together as in a shell: '...' verbatim; in "..." a backslash
/// escapes " \ $ and `; elsewhere it escapes any character. Nothing else has a meaning: no variables, no globs, no
/// comments. Nothing for text that ends within quotes or after a backslash.
std::optional<std::vector<std::string>> split_shell_words(const std::string& text);

/// The name of the program that a command runs, without folder and extension; empty: there is none.
std::string program_name(const std::string& command);

/// A word in quotes, where a shell needs them.
std::string shell_word(const std::string& word);

}
