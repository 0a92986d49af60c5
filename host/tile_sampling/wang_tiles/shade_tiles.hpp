// Wang tiles by dart throwing against every tile that may lie beside.
//
// Shade, Cohen and Mitchell, Tiling layered depth images, 2000; Lagae, Tile-Based Methods in Computer Graphics, 2007,
// section 6.6: near an edge a dart meets the points of four tiles, near a corner those of all, so that few fit there.
#pragma once

#include "host/tile_sampling/wang_tiles/wang_points.hpp"

namespace poissonlab {

/// Darts into random tiles until so many in a row have failed. `squared_distance` in units; shorter than half a tile.
WangPoints throw_shade_tiles(std::uint64_t squared_distance, std::uint32_t attempts, std::uint64_t seed);

}
