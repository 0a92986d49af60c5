#include "experiment/config/method_registry.hpp"

#include <algorithm>

namespace poissonlab {

const std::vector<std::string>& method_keys()
{
    static const std::vector<std::string> keys{"sampler", "label", "points",  "order", "region",
                                               "planar",  "crs",   "overlap", "buffer"};
    return keys;
}

bool analysis_has_region(const ConfigTable& config)
{
    const ConfigNode* node = find(config, "analysis");
    const auto* analysis = node ? node->get_if<ConfigTable>() : nullptr;
    return analysis && find(*analysis, "region");
}

bool some_method_has_region(const ConfigTable& config)
{
    const ConfigNode* node = find(config, "method");
    const auto* methods = node ? node->get_if<ConfigList>() : nullptr;
    return methods && std::ranges::any_of(*methods, [](const ConfigNode& method) {
               const auto* table = method.get_if<ConfigTable>();
               return table && find(*table, "region");
           });
}

const SamplerRegistry& registry_of(const ConfigTable& method, bool analysis_has_region, const SamplerRegistry& torus)
{
    return analysis_has_region || find(method, "region") ? region_sampler_registry() : torus;
}

}
