// The sampler "penrose": points of a Penrose tiling that is divided as a density asks for.
//
// Ostromoukhov, Donohue and Jodoin, Fast hierarchical importance sampling with blue noise properties, SIGGRAPH 2004;
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.8. A set is a window of the plane, not a torus. Every
// realization is the same.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

SamplerSpec penrose_sampler();

}
