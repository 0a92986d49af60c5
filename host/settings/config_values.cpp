#include "host/settings/config_values.hpp"

#include "host/settings/nearest_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {

std::int64_t read_integer(const ConfigTable& table, const std::string& key, std::int64_t minimum, std::int64_t maximum,
                          std::int64_t otherwise)
{
    const ConfigNode* node = find(table, key);
    if (!node) return otherwise;
    const auto* value = node->get_if<std::int64_t>();
    if (!value || *value < minimum || *value > maximum)
        throw invalid_node(key, *node, fmt::format("must be an integer from {} to {}", minimum, maximum));
    return *value;
}

double read_number(const ConfigTable& table, const std::string& key, double minimum, double maximum, double otherwise)
{
    const ConfigNode* node = find(table, key);
    if (!node) return otherwise;
    const auto* real = node->get_if<double>();
    const auto* integer = node->get_if<std::int64_t>();
    const double value = real ? *real : integer ? static_cast<double>(*integer) : minimum - 1;
    if (!(value >= minimum && value <= maximum)) // also NaN
        throw invalid_node(key, *node, fmt::format("must be a number from {} to {}", minimum, maximum));
    return value;
}

bool read_flag(const ConfigTable& table, const std::string& key, bool otherwise)
{
    const ConfigNode* node = find(table, key);
    if (!node) return otherwise;
    const auto* value = node->get_if<bool>();
    if (!value) throw invalid_node(key, *node, "must be true or false");
    return *value;
}

std::string read_text(const ConfigTable& table, const std::string& key, const std::string& otherwise)
{
    const ConfigNode* node = find(table, key);
    if (!node) return otherwise;
    const auto* value = node->get_if<std::string>();
    if (!value || value->empty() || printable(*value) != *value) // labels go to terminals
        throw invalid_node(key, *node, "must be a line of text in quotes");
    return *value;
}

std::size_t read_word(const ConfigTable& table, const std::string& key, const std::vector<std::string>& words)
{
    const ConfigNode* node = find(table, key);
    if (!node) return 0;
    const auto* value = node->get_if<std::string>();
    const auto found = value ? std::ranges::find(words, *value) : words.end();
    if (found == words.end())
        throw invalid_node(key, *node,
                           fmt::format("must be one of \"{}\"{}", fmt::join(words, "\", \""),
                                       value ? did_you_mean(*value, words) : ""));
    return static_cast<std::size_t>(found - words.begin());
}

std::vector<std::int64_t> read_integers(const ConfigTable& table, const std::string& key, std::size_t fewest,
                                        std::size_t most, std::int64_t minimum, const char* allowed)
{
    const ConfigNode* node = find(table, key);
    if (!node) return {};
    const auto* list = node->get_if<ConfigList>();
    std::vector<std::int64_t> values;
    if (list)
        for (const ConfigNode& item : *list)
            if (const auto* value = item.get_if<std::int64_t>(); value && *value >= minimum) values.push_back(*value);
    if (!list || values.size() != list->size() || values.size() < fewest || values.size() > most)
        throw invalid_node(key, *node, std::string("must be ") + allowed);
    return values;
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

}
