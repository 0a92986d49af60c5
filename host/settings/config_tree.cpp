#include "host/settings/config_tree.hpp"

#include "base/text/decimal_commas.hpp"
#include "host/settings/nearest_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace poissonlab {

const ConfigNode* find(const ConfigTable& table, const std::string& key)
{
    const auto entry = std::ranges::find(table, key, &ConfigEntry::key);
    return entry == table.end() ? nullptr : &entry->node;
}

ConfigNode* find(ConfigTable& table, const std::string& key)
{
    return const_cast<ConfigNode*>(find(std::as_const(table), key));
}

namespace {

/// A value with everything in it, in one line.
std::string text_of_node(const ConfigNode& node)
{
    if (const auto* table = node.get_if<ConfigTable>()) return "{ " + text_of(*table) + "}";
    const auto* list = node.get_if<ConfigList>();
    if (!list) return node.text;
    std::string text;
    for (const ConfigNode& item : *list) text += text_of_node(item) + ", ";
    return "[ " + text + "]";
}

std::string whole_text(const ConfigNode& node)
{
    if (node.get_if<ConfigTable>()) return "{...}";
    const auto* list = node.get_if<ConfigList>();
    if (!list) return node.text;
    std::vector<std::string> items;
    for (const ConfigNode& item : *list) items.push_back(whole_text(item));
    return fmt::format("[{}]", fmt::join(items, ", "));
}

}

std::string text_of(const ConfigTable& table)
{
    std::string text;
    for (const ConfigEntry& entry : table) text += entry.key + " = " + text_of_node(entry.node) + ", ";
    return text;
}

std::string shown(const ConfigNode& node)
{
    std::string text = whole_text(node);
    std::ranges::replace(text, '\n', ' '); // a message is one line
    return shortened(text);
}

std::string comma_words(const ConfigNode& node, const std::string& allowed)
{
    const auto* text = node.get_if<std::string>();
    if (!text) return "";
    const bool is_decimal = !text->empty() && decimal_comma_in(*text) == *text;
    if (!is_decimal || allowed.starts_with("must be an integer")) return "";
    const std::string words = decimal_comma_words(*text);
    return allowed.ends_with(words) ? "" : words;
}

InputError invalid_node(const std::string& key, const ConfigNode& node, const std::string& allowed)
{
    return invalid_value(node.location, key, shown(node), allowed + comma_words(node, allowed));
}

InputError unknown_key(const std::string& key, const ConfigNode& node, const std::vector<std::string>& known)
{
    return invalid_node(key, node,
                        fmt::format("unknown key{}{} known keys: {}", did_you_mean(key, known),
                                    nearest_key(key, known).empty() ? ";" : "", fmt::join(known, ", ")));
}

const ConfigNode& required_node(const ConfigTable& table, const SourceLocation& where, const std::string& title,
                                const std::string& key)
{
    const ConfigNode* node = find(table, key);
    if (!node) throw InputError::at(where, fmt::format("{}: {} is missing", title, key));
    return *node;
}

std::vector<const ConfigNode*> read_tables(const ConfigTable& table, const std::string& key)
{
    const ConfigNode* node = find(table, key);
    if (!node) return {};
    const auto* list = node->get_if<ConfigList>();
    if (!list || list->empty())
        throw invalid_node(key, *node, "must be a list of tables, each written [[" + key + "]]");
    std::vector<const ConfigNode*> tables;
    for (const ConfigNode& item : *list) {
        if (!item.get_if<ConfigTable>()) throw invalid_node(key, item, "must be a table, written [[" + key + "]]");
        tables.push_back(&item);
    }
    return tables;
}

void check_keys(const ConfigTable& table, const std::vector<std::string>& known)
{
    for (const auto& [key, node] : table)
        if (std::ranges::find(known, key) == known.end()) throw unknown_key(key, node, known);
}

}
