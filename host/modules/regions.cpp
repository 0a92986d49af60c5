// Sets in regions of the plane, as series of an experiment.
#include "host/distribution/region_samplers/region_method_samplers.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_regions(Laboratory& laboratory)
{
    for (SamplerSpec (*const sampler)() :
         {region_random_sampler, region_bridson_sampler, region_dart_sampler, region_relaxation_sampler,
          region_lloyd_sampler, region_elimination_sampler, region_gaussian_sampler})
        laboratory.region_samplers.push_back(sampler());
}

}
