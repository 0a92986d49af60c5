#include "host/distribution/tables/distribution_table.hpp"

#include "host/config/config_values.hpp"
#include "host/config/schemes/scheme_table.hpp"
#include "host/distribution/kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace poissonlab {
namespace {

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

/// A new label makes nothing anew: what decides the result are the values, defaults too.
void read_described(const Kind& kind, const ConfigTable& table, DistributionConfig& config)
{
    KindSettings settings = read_kind(kind, table, config.where, "[[" + kind.table + "]]", {"kind", "label"});
    config.text = fmt::format("kind = {}, {}", kind.word, settings.resolved);
    config.inputs = settings.inputs;
    if (config.label.empty()) config.label = settings.label;
    config.settings = std::move(settings);
}

}

const std::vector<std::string>& distribution_kinds()
{
    static const std::vector<std::string> kinds = [] {
        std::vector<std::string> words;
        for (const Kind& kind : all_kinds())
            if (kind.table == "distribution") words.push_back(kind.word);
        return words;
    }();
    return kinds;
}

std::vector<DistributionConfig> read_distributions(const std::vector<ConfigNode>& tables, std::uint64_t seed)
{
    std::vector<DistributionConfig> distributions;
    for (const ConfigNode& node : tables) {
        DistributionConfig config = begun_config(node, distribution_kinds(), seed);
        read_described(*find_kind("distribution", config.kind), *node.get_if<ConfigTable>(), config);
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
