// The sampler "hexagonal": the densest packing that fits on the torus, to which relative radii are relative.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// `hexagonal`: rows of a lattice, every other one half a step to the side; of all numbers of rows the one that has the
/// largest relative radius, of as many points as come nearest. 3D: the face-centred cubic lattice, 4 k^3 points. Every
/// realization is the same set.
SamplerSpec hexagonal_sampler();

}
