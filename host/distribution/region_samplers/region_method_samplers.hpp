// The samplers in regions that host/modules/regions.cpp lists.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// Independent uniform points.
SamplerSpec region_random_sampler();

// These samplers use the methods of host/distribution/regions/region_points.hpp.
SamplerSpec region_dart_sampler();
SamplerSpec region_relaxation_sampler();
SamplerSpec region_bridson_sampler();
SamplerSpec region_lloyd_sampler();
SamplerSpec region_elimination_sampler();
SamplerSpec region_gaussian_sampler();

}
