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

    /// All words in the order of the table.
    std::vector<std::string> all() const
    {
        std::vector<std::string> words;
        for (const auto& [value, word] : entries) words.emplace_back(word);
        return words;
    }

    /// The same with one of them in front: the default, where words are listed.
    std::vector<std::string> all_after(Enum first) const
    {
        std::vector<std::string> words = {(*this)[first]};
        for (const auto& [value, word] : entries)
            if (value != first) words.emplace_back(word);
        return words;
    }
};

}
