// The tiles that chance puts around a tile: what a tile meets in tilings.
#pragma once

#include "base/random/random.hpp"
#include "tiles/poisson/poisson_tile_set.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// A tile and those around it: the one at x, y and z (each -1, 0 or 1; in 2D z is 0) has the number neighbour_number().
/// 2D: only the middle nine numbers are set.
using NeighbourTiles = std::array<std::uint32_t, 27>;

constexpr std::size_t neighbour_number(int x, int y, int z)
{
    return static_cast<std::size_t>(9 * (z + 1) + 3 * (y + 1) + (x + 1));
}

/// The neighbours of a tile when all colours that it has no part in are random: of each stream and each counter
/// another choice.
NeighbourTiles random_neighbours(const PoissonTileParameters& parameters, std::uint32_t tile, const StreamKey& stream,
                                 std::uint32_t counter);

}
