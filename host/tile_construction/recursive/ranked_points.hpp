// Orders of points in which every part is spread: the two that recursive Wang tiles need.
#pragma once

#include "host/tile_construction/recursive/edge_merging.hpp"
#include "tiles/recursive/recursive_tile_set.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// The first `count` of merged points: by rank, but a point waits until it is no nearer to those before it than 0.6
/// times what as many points could be apart.
std::vector<RecursivePlace> mended_order(std::vector<RankedPlace> points, std::uint32_t count);

/// For each tile the numbers of its other points, one after the other the one that is farthest from those that are
/// there: the taken ones, and those before it, of the tile and of all tiles that may lie beside it. All tiles together,
/// rank by rank; of equals the first. Every tile has as many places, of which as many are taken.
std::array<std::vector<std::uint32_t>, even_wang_tiles>
farthest_orders(const RecursivePlaces& places, const std::array<std::vector<bool>, even_wang_tiles>& taken);

}
