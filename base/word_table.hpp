// The words by which users name the values of an enumeration: one table each.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace poissonlab {

template <typename Enum, std::size_t N>
struct WordTable
{
    std::array<std::pair<Enum, const char*>, N> entries;

    /// The word of a value; "unknown" where it has none.
    constexpr const char* operator[](Enum value) const
    {
        for (const auto& [each, word] : entries)
            if (each == value) return word;
        return "unknown";
    }

    constexpr std::optional<Enum> find(std::string_view text) const
    {
        for (const auto& [value, word] : entries)
            if (word == text) return value;
        return {};
    }

    /// All words in the order of the table, but for one that comes first: the default.
    std::vector<std::string> all(std::optional<Enum> first = {}) const
    {
        std::vector<std::string> words;
        for (const auto& [value, word] : entries) words.insert(value == first ? words.begin() : words.end(), word);
        return words;
    }
};

}
