// All methods of making point sets that a config can name.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

// The samplers of sets in regions of the plane: what a [[method]] can name where it, or [analysis], has a region.
//
// They have the names and titles of their methods on the torus, and as far as these mean something in a region their
// parameters; distances are in the region's units, and so are the points. Of methods that `distribute points` knows,
// realization 0 of a seed is the set that it makes.

/// All samplers in regions, in the order of sampler_registry(). Their requests have regions.
const SamplerRegistry& region_sampler_registry();

/// All samplers, in the order in which help and errors list them; host/modules has what modules bring.
const SamplerRegistry& sampler_registry();

/// The sampler of that name, or null. Throws MissingModule where only a module has it that this program lacks.
const SamplerSpec* find_sampler(const std::string& name, const SamplerRegistry& registry = sampler_registry());

}
