// A config as a tree of values that know where they were written. No key has a meaning here yet.
//
// The tree of toml++ would not do: its values lose their place when they are copied, as --set copies them to methods,
// they do not keep how a number was typed, which names of series show, and its tables sort their keys.
#pragma once

#include "base/errors/errors.hpp"
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace poissonlab {

struct ConfigNode;
struct ConfigEntry;

/// Keys and values in the order of the file, so that the first mistake is reported first.
using ConfigTable = std::vector<ConfigEntry>;
using ConfigList = std::vector<ConfigNode>;

/// Kinds of values that no key takes, such as dates; only their text matters, for messages.
struct OtherValue
{
};

struct ConfigNode
{
    std::variant<OtherValue, bool, std::int64_t, double, std::string, ConfigList, ConfigTable> value;
    SourceLocation location;
    std::string text; ///< single values: as typed (strings in quotes)

    template <typename T>
    const T* get_if() const
    {
        return std::get_if<T>(&value);
    }
    template <typename T>
    T* get_if()
    {
        return std::get_if<T>(&value);
    }
};

/// A key of a table with its value.
struct ConfigEntry
{
    std::string key;
    ConfigNode node;
};

/// The value of a key, or null.
const ConfigNode* find(const ConfigTable& table, const std::string& key);
ConfigNode* find(ConfigTable& table, const std::string& key);

/// The value in a message: as typed, lists in brackets, tables as {...}; long ones are cut.
std::string shown(const ConfigNode& node);

/// A table with everything in it, in one line.
std::string text_of(const ConfigTable& table);

/// The InputError for a key whose value is not allowed, at the value's own line.
InputError invalid_node(const std::string& key, const ConfigNode& node, const std::string& allowed);

/// The InputError for a key that means nothing, with the nearest known key and the list of known keys.
InputError unknown_key(const std::string& key, const ConfigNode& node, const std::vector<std::string>& known);

/// The value of a key that must be there. Throws InputError at `where`, which says that the key of `title` is missing.
const ConfigNode& required_node(const ConfigTable& table, const SourceLocation& where, const std::string& title,
                                const std::string& key);

/// The tables written [[key]]; none where the table lacks the key. An empty list is an error, as is any other value.
std::vector<const ConfigNode*> read_tables(const ConfigTable& table, const std::string& key);

/// Refuses keys that mean nothing. Throws unknown_key for the first one.
void check_keys(const ConfigTable& table, const std::vector<std::string>& known);

// Words for values that are numbers with decimal commas.

/// The end of a message about a value that is such a number, see decimal_comma_words(); empty for any other, where
/// an integer is `allowed` (in "1,000" points the comma is none of decimals), and where `allowed` has these words
/// already.
std::string comma_words(const ConfigNode& node, const std::string& allowed);

}
