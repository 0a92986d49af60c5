// Sets that other programs have made: from files, and from commands that write them.
#include "host/modules/laboratory.hpp"
#include "host/sampling/classics/command_sampler.hpp"
#include "host/sampling/file_sampler.hpp"

namespace poissonlab {

void add_own_methods(Laboratory& laboratory)
{
    for (SamplerSpec sampler : {file_sampler(), command_sampler()}) {
        laboratory.samplers.push_back(sampler);
        sampler.dimensions = {2};
        laboratory.region_samplers.push_back(std::move(sampler));
    }
}

}
