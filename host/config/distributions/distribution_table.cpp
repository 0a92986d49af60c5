#include "host/config/distributions/distribution_table.hpp"

#include "host/config/config_values.hpp"
#include "host/config/distributions/icon_table.hpp"
#include "host/config/distributions/instance_table.hpp"
#include "host/config/distributions/object_table.hpp"
#include "host/config/distributions/rank_table.hpp"
#include "host/config/distributions/stipple_table.hpp"
#include "host/config/distributions/warp_table.hpp"
#include "host/config/schemes/scheme_table.hpp"

#include <algorithm>
#include <utility>

namespace poissonlab {
namespace {

using ReadDistribution = void (*)(const ConfigTable& table, DistributionConfig& config);

const std::vector<std::pair<std::string, ReadDistribution>>& readers()
{
    static const std::vector<std::pair<std::string, ReadDistribution>> all{
        {"warp", read_warp},   {"objects", read_objects},     {"self-similar-tile", read_self_similar_tile},
        {"ranks", read_ranks}, {"stippling", read_stippling}, {"hatching", read_hatching},
        {"icons", read_icons}, {"instances", read_instances}};
    return all;
}

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

/// The keys that tables of either name have.
DistributionConfig begun_config(const ConfigNode& node, const std::vector<std::string>& kinds, std::uint64_t seed)
{
    const ConfigTable& table = *node.get_if<ConfigTable>();
    DistributionConfig config;
    config.kind = kinds[read_word(table, "kind", kinds)];
    config.label = find(table, "label") ? read_text(table, "label", "") : "";
    config.where = node.location;
    config.seed = seed;
    config.text = text_of(table);
    return config;
}

}

std::string text_of(const ConfigTable& table)
{
    std::string text;
    for (const ConfigEntry& entry : table) text += entry.key + " = " + text_of_node(entry.node) + ", ";
    return text;
}

const std::vector<std::string>& distribution_kinds()
{
    static const std::vector<std::string> kinds = [] {
        std::vector<std::string> words;
        for (const auto& [word, read] : readers()) words.push_back(word);
        return words;
    }();
    return kinds;
}

std::vector<DistributionConfig> read_distributions(const std::vector<ConfigNode>& tables, std::uint64_t seed)
{
    std::vector<DistributionConfig> distributions;
    for (const ConfigNode& node : tables) {
        DistributionConfig config = begun_config(node, distribution_kinds(), seed);
        const auto reader = std::ranges::find(readers(), config.kind, [](const auto& known) { return known.first; });
        reader->second(*node.get_if<ConfigTable>(), config);
        distributions.push_back(std::move(config));
    }
    return distributions;
}

std::vector<DistributionConfig> read_schemes(const std::vector<ConfigNode>& tables, std::uint64_t seed)
{
    std::vector<DistributionConfig> schemes;
    for (const ConfigNode& node : tables) {
        DistributionConfig config = begun_config(node, scheme_kinds(), seed);
        try {
            SchemeChoice choice = read_scheme(*node.get_if<ConfigTable>(), config.kind, seed);
            if (config.label.empty()) config.label = choice.label;
            config.settings = std::move(choice.settings);
        } catch (const InputError& error) {
            throw error.place().file.empty() ? error.moved_to(node.location) : error;
        }
        schemes.push_back(std::move(config));
    }
    return schemes;
}

}
