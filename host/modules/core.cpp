// The core: sets of the unit torus, on which everything else stands.
#include "host/modules/laboratory.hpp"
#include "host/sampling/baselines.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/file_sampler.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"

namespace poissonlab {
namespace {

SamplerSpec in_plane(SamplerSpec spec)
{
    spec.dimensions = {2};
    return spec;
}

}

void add_core(Laboratory& laboratory)
{
    for (SamplerSpec (*const sampler)() : {random_sampler, regular_sampler, jittered_sampler, dart_throwing_sampler,
                                           relaxation_dart_throwing_sampler, lloyd_sampler, file_sampler})
        laboratory.samplers.push_back(sampler());
    laboratory.region_samplers = {in_plane(file_sampler())};
}

}
