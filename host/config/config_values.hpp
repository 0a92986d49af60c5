// Single values of a config table, checked.
#pragma once

#include "base/word_table.hpp"
#include "host/config/config_tree.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// Each returns `otherwise` where the table lacks the key, and throws InputError with the value's own line
/// for values of another kind or beyond the ends, which are allowed.
std::int64_t read_integer(const ConfigTable& table, const std::string& key, std::int64_t minimum, std::int64_t maximum,
                          std::int64_t otherwise);
double read_number(const ConfigTable& table, const std::string& key, double minimum, double maximum, double otherwise);
bool read_flag(const ConfigTable& table, const std::string& key, bool otherwise);

/// A line of text that is not empty.
std::string read_text(const ConfigTable& table, const std::string& key, const std::string& otherwise);

/// The number of a word in a list of them; the first is the default.
std::size_t read_word(const ConfigTable& table, const std::string& key, const std::vector<std::string>& words);

/// The value that a word names.
template <typename Enum, std::size_t N>
Enum read_word(const ConfigTable& table, const std::string& key, const WordTable<Enum, N>& words, Enum otherwise)
{
    const std::vector<std::string> listed = words.all(otherwise);
    return *words.find(listed[read_word(table, key, listed)]);
}

}
