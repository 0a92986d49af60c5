// The samplers of sets in regions of the plane: what a [[method]] can name where it, or [analysis], has a region.
//
// They have the names and titles of their methods on the torus, and as far as these mean something in a region their
// parameters; distances are in the region's units, and so are the points. Of methods that `distribute points` knows,
// realization 0 of a seed is the set that it makes.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// All samplers in regions, in the order of sampler_registry(). Their requests have regions.
const SamplerRegistry& region_sampler_registry();

}
