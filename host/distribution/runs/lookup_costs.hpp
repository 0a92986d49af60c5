// The cost of looking objects up, in time and in calls of Perlin's noise.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 7.6.2.1 and 7.6.3, says about 5 calls in the plane and
// 20 in space, and not in which order. Noise is several times as fast along rows of pixels, where its permutations are
// in the cache: both orders are measured.
#pragma once

#include "host/distribution/objects.hpp"

namespace poissonlab {

/// Calls a second, at random places and at those of pixels, row by row: medians of several times. They differ from run
/// to run.
struct LookupCosts
{
    double lookups_anywhere = 0;
    double lookups_in_rows = 0;
    double noise_anywhere = 0;
    double noise_in_rows = 0;
};

/// Measures the look-up on the host, of the runtime's header. Throws Interrupted.
LookupCosts lookup_costs(const ObjectTileSet& tiles);

}
