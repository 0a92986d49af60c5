// Wang tiles by relaxation in the mean of all surroundings.
//
// Hiller, Deussen and Keller, Tiled blue noise samples, 2001; Cohen, Shade, Hiller and Deussen, Wang tiles for image
// and texture generation, 2003, section 3.3; Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.7. A point
// moves by what Lloyd relaxation would do to it, on average over all 4,096 ways to surround its tile; or, as in 2003,
// in one random surrounding.
#pragma once

#include "host/tile_sampling/wang_tiles/wang_points.hpp"

#include <functional>
#include <span>

namespace poissonlab {

enum class AveragedVariant
{
    exact,           ///< mean over all surroundings, all tiles at once
    one_surrounding, ///< one random surrounding a tile and iteration, tile after tile
};

/// Random points in the middle of each tile, a square half as wide.
WangPoints start_averaged_tiles(std::uint32_t points_per_tile, std::uint64_t seed);

/// One iteration. Points stay in their tiles. On all threads; the result is the same for any number of them.
WangPoints average_once(const WangPoints& points, AveragedVariant variant, std::uint32_t iteration, std::uint64_t seed);

/// The displacement, in units and rounded, of a point of the middle one of 3 x 3 tiles to the centroid of its Voronoi
/// cell among their points. `tiles` row by row from the lower left.
WangPoint centroid_displacement(const WangPoints& points, std::span<const std::size_t, 9> tiles, std::size_t point);

}
