#include "host/config/sampler_registry.hpp"

#include "host/sampling/command_sampler.hpp"
#include "host/sampling/file_sampler.hpp"
#include "host/tile_sampling/tile_samplers.hpp"

namespace poissonlab {

const SamplerRegistry& sampler_registry()
{
    static const SamplerRegistry registry = [] {
        SamplerRegistry all = basic_samplers();
        for (SamplerSpec& spec : tile_samplers()) all.push_back(std::move(spec));
        all.push_back(file_sampler());
        all.push_back(command_sampler());
        return all;
    }();
    return registry;
}

}
