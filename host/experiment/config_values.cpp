#include "experiment/config_values.hpp"

#include "experiment/nearest_key.hpp"

#include <fmt/format.h>

namespace poissonlab {

std::int64_t read_integer(const ConfigTable& table, const std::string& key, std::int64_t minimum,
                          std::int64_t maximum, std::int64_t otherwise)
{
    const ConfigNode* node = find(table, key);
    if (!node) return otherwise;
    const auto* value = node->get_if<std::int64_t>();
    if (!value || *value < minimum || *value > maximum)
        throw invalid_node(key, *node, fmt::format("must be an integer from {} to {}", minimum, maximum));
    return *value;
}

double read_number(const ConfigTable& table, const std::string& key, double minimum, double maximum,
                   double otherwise)
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
    if (!value || value->empty() || value->find('\n') != std::string::npos)
        throw invalid_node(key, *node, "must be a line of text in quotes");
    return *value;
}

bool is_second_word(const ConfigTable& table, const std::string& key, const std::vector<std::string>& words)
{
    const ConfigNode* node = find(table, key);
    if (!node) return false;
    const auto* value = node->get_if<std::string>();
    if (value && *value == words[0]) return false;
    if (value && *value == words[1]) return true;
    throw invalid_node(key, *node,
                       "must be \"" + words[0] + "\" or \"" + words[1] + "\"" +
                           (value ? did_you_mean(*value, words) : ""));
}

}
