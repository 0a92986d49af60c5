#include "host/config/distributions/distribution_table.hpp"

#include "host/config/config_values.hpp"
#include "host/config/distributions/object_table.hpp"
#include "host/config/distributions/rank_table.hpp"
#include "host/config/distributions/warp_table.hpp"

#include <utility>

namespace poissonlab {
namespace {

using ReadDistribution = void (*)(const ConfigTable& table, DistributionConfig& config);

const std::vector<std::pair<std::string, ReadDistribution>>& readers()
{
    static const std::vector<std::pair<std::string, ReadDistribution>> all{
        {"warp", read_warp},
        {"objects", read_objects},
        {"self-similar-tile", read_self_similar_tile},
        {"ranks", read_ranks}};
    return all;
}

/// A value with everything in it, in one line.
std::string text_of(const ConfigNode& node);

std::string text_of(const ConfigTable& table)
{
    std::string text;
    for (const ConfigEntry& entry : table) text += entry.key + " = " + text_of(entry.node) + ", ";
    return text;
}

std::string text_of(const ConfigNode& node)
{
    if (const auto* table = node.get_if<ConfigTable>()) return "{ " + text_of(*table) + "}";
    const auto* list = node.get_if<ConfigList>();
    if (!list) return node.text;
    std::string text;
    for (const ConfigNode& item : *list) text += text_of(item) + ", ";
    return "[ " + text + "]";
}

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
        const ConfigTable& table = *node.get_if<ConfigTable>();
        const std::size_t kind = read_word(table, "kind", distribution_kinds());
        DistributionConfig config;
        config.kind = distribution_kinds()[kind];
        config.label = find(table, "label") ? read_text(table, "label", "") : "";
        config.where = node.location;
        config.seed = seed;
        config.text = text_of(table);
        readers()[kind].second(table, config);
        distributions.push_back(std::move(config));
    }
    return distributions;
}

}
