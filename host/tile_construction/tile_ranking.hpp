// Ranks of a tile set's points: an order by which every tiling gets sparser, or denser, and stays even.
//
// All tiles are ranked together. Rank by rank each tile takes the point that is in the largest gap: the one where a sum
// of Gaussians around the points taken so far is least, its own and those of eight random neighbourhoods. Ulichney, The
// void-and-cluster method for dither array generation, 1993, with the void half of it, for points that are given;
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 4.7 ranks the points of one tile.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

/// The ranks of all points: see PoissonTileSet::ranks. `progress` is told how many ranks are done; what it throws ends
/// the work. On all threads; the result is the same for any number of them. Points of classes are ranked class by
/// class; then those of all classes together, the same for all tiles, such that each part of them has all classes
/// nearly in their proportions.
std::vector<std::uint16_t> rank_points(const PoissonTileSet& set,
                                       const std::function<void(std::size_t done, std::size_t total)>& progress = {});

}
