#include "host/settings/sampler_registry.hpp"

#include "base/errors/missing_module.hpp"

#include <algorithm>

namespace poissonlab {

const SamplerSpec* find_sampler(const std::string& name, const SamplerRegistry& registry)
{
    const auto found = std::ranges::find(registry, name, &SamplerSpec::name);
    if (found == registry.end()) return nullptr;
    if (!found->absent_module.empty()) throw MissingModule(found->absent_module);
    return &*found;
}

}
