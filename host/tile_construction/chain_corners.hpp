// The corner points of tiles with chains: one a colour, spread so that their lattice shows as little as it can.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <vector>

namespace poissonlab {

/// Offsets from the lattice point, by colour: of many random choices in a disk of 0.7 spacings, that whose mean
/// transform has the least fourth power at the frequencies that points of this density should not have. Even units.
std::vector<UnitPosition> spread_corners(const PoissonTileParameters& parameters);

}
