// The torus of tiles on which a set is relaxed together: which tile is where.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// The side of the torus, in tiles: it shows each tile four times on average, and has 144 tiles or more; in space 125.
std::uint32_t joint_side(const PoissonTileParameters& parameters);

/// The tiles of a random torus, row after row from below (and layer after layer), that shows every tile of the set at
/// least once, if chance allows. Every iteration has its own.
std::vector<std::uint32_t> joint_tiling(const PoissonTileParameters& parameters, std::uint32_t iteration);

}
