// Poisson disk tiles in a region of the plane, as sets of a series: see host/tile_points/tiled_region.hpp.
//
// Realizations are tilings of the plane with different seeds. Tiles are as wide as a minimum distance, or a number of
// points, asks for.
#pragma once

#include "host/sampling/sampler.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

namespace poissonlab {

/// The sampler in regions of the tiles of a family of the plane, whose sampler on the torus is given.
SamplerSpec region_tile_sampler(const PoissonTileFamily& family, SamplerSpec on_torus);

}
