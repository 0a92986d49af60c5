// The sampler "recursive-wang-tiles".
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006; Lagae,
// Tile-Based Methods in Computer Graphics, 2007, section 6.14. Runs on the host: what a processor does to a point is
// less than what it takes to move it.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

SamplerSpec recursive_wang_tile_sampler();

}
