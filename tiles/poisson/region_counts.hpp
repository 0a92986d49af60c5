// The numbers of a tile set's points in the regions of corners, edges, faces and interiors.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figure 6.24: points that tiles share are in the regions of
// corners and edges, so that the numbers say how much the tiles of a set have in common.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <array>
#include <cstdint>

namespace poissonlab {

/// The points of a tile in the regions of its cells of one dimension, on the tile's own side of them.
struct RegionCounts
{
    std::uint32_t min = 0; ///< over all tiles
    std::uint32_t max = 0;
    double mean = 0;
    double expected = 0; ///< of as many points spread evenly: by area (volume)
    double density = 0;  ///< mean over expected: 1 where points are as dense as elsewhere

    bool operator==(const RegionCounts&) const = default;
};

/// The counts by the dimension of the cell: corners first, the interior last, the rest 0.
std::array<RegionCounts, 4> region_counts(const PoissonTileSet& set);

}
