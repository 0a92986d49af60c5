// The sampler "sector-darts": Poisson disk sets that grow from their first point, dart beside dart.
//
// Dunbar and Humphreys, A spatial data structure for fast Poisson-disk sample generation, 2006; Lagae, Tile-Based
// Methods in Computer Graphics, 2007, section 6.13. Three ways to choose the next dart, all of them sequential by
// definition: which point is next depends on all points so far. Realizations are what runs side by side. A set ends
// when no point fits any more; before that, a part of the torus has none, so that no number of points can be asked for.
// The law is not that of dart throwing in any of them.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// Variants: "logarithmic", a uniform place in all that is left around points; "linear", one point's neighbourhood
/// after the other is filled; "boundary", at the least distance of a point.
SamplerSpec sector_dart_sampler();

}
