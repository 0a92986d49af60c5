// Single values of a config table, checked.
#pragma once

#include "base/word_table.hpp"
#include "host/settings/config_tree.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace poissonlab {

/// The largest integer of a config: a range up to it is none.
inline constexpr std::int64_t any_integer = std::numeric_limits<std::int64_t>::max();

/// Each returns `otherwise` where the table lacks the key, and throws InputError with the value's own line
/// for values of another kind or beyond the ends, which are allowed.
std::int64_t read_integer(const ConfigTable& table, const std::string& key, std::int64_t minimum, std::int64_t maximum,
                          std::int64_t otherwise);
double read_number(const ConfigTable& table, const std::string& key, double minimum, double maximum, double otherwise);
bool read_flag(const ConfigTable& table, const std::string& key, bool otherwise);

/// A line of text that is not empty.
std::string read_text(const ConfigTable& table, const std::string& key, const std::string& otherwise);

/// Whole numbers of at least `minimum` in a list, `fewest` to `most` of them; none where the table lacks the key.
/// `allowed` is how messages describe the list.
std::vector<std::int64_t> read_integers(const ConfigTable& table, const std::string& key, std::size_t fewest,
                                        std::size_t most, std::int64_t minimum, const char* allowed);

/// The tables written [[key]]; none where the table lacks the key. An empty list is an error, as is any other value.
std::vector<const ConfigNode*> read_tables(const ConfigTable& table, const std::string& key);

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
