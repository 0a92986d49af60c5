// Sets in regions, as series of an experiment and alone.
#include "host/distribution/region_samplers/region_method_samplers.hpp"
#include "host/distribution/regions/line_set.hpp"
#include "host/kinds/kinds.hpp"
#include "host/modules/laboratory.hpp"

namespace poissonlab {

void add_regions(Laboratory& laboratory)
{
    for (SamplerSpec (*const sampler)() :
         {region_random_sampler, region_bridson_sampler, region_dart_sampler, region_relaxation_sampler,
          region_lloyd_sampler, region_elimination_sampler, region_gaussian_sampler})
        laboratory.region_samplers.push_back(sampler());
    for (Kind (*const kind)() : {dart_kind, region_point_kind, line_set_kind}) laboratory.kinds.push_back(kind());
}

}
