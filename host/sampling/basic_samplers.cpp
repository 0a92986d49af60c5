// The samplers that use no tiles. To add one, describe it and put it here.
#include "host/sampling/baselines.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "host/sampling/sampler.hpp"

#include <algorithm>

namespace poissonlab {

const SamplerRegistry& basic_samplers()
{
    static const SamplerRegistry registry = {
        random_sampler(),
        regular_sampler(),
        jittered_sampler(),
        dart_throwing_sampler(),
        relaxation_dart_throwing_sampler(),
        lloyd_sampler(),
    };
    return registry;
}

const SamplerSpec* find_sampler(const std::string& name, const SamplerRegistry& registry)
{
    const auto found =
        std::find_if(registry.begin(), registry.end(), [&](const SamplerSpec& s) { return s.name == name; });
    return found == registry.end() ? nullptr : &*found;
}

}
