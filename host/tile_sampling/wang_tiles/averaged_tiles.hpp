// Wang tiles by relaxation in the mean of all surroundings.
//
// Hiller, Deussen and Keller, Tiled blue noise samples, 2001; Cohen, Shade, Hiller and Deussen, Wang tiles for image
// and texture generation, 2003, section 3.3; Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.7. A point
// moves by what Lloyd relaxation would do to it, on average over all 4,096 ways to surround its tile; or, as in 2003,
// in one random surrounding. What is here is plain; averaged_tile_kernel.hpp does the same on a device.
#pragma once

#include "host/tile_sampling/wang_tiles/wang_points.hpp"

#include <array>
#include <functional>
#include <span>
#include <vector>

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

/// The mean of centroid_displacement() over all surroundings of a tile.
WangPoint mean_displacement(const WangPoints& points, std::size_t tile, std::size_t number);

/// A point where it is moved to, which is in its tile.
WangPoint moved_in_tile(const WangPoint& point, const WangPoint& by);

/// All points where `displacement` of their tile and number moves them, at once and on all threads.
WangPoints moved_tiles(const WangPoints& points,
                       const std::function<WangPoint(std::size_t tile, std::size_t number)>& displacement);

/// The tiles that fit beside one along the x axis (or the y axis), at the side `sign`: four.
std::vector<std::size_t> tiles_beside(std::size_t tile, bool along_x, int sign);

/// The two tiles that fit between those at two sides, towards x and y of -1 or 1.
std::vector<std::size_t> tiles_between(std::size_t at_x, std::size_t at_y, int x, int y);

/// A surrounding by chance, each as likely: 3 x 3 tiles as for centroid_displacement().
std::array<std::size_t, 9> random_surrounding(std::size_t tile, std::uint32_t iteration, std::uint64_t seed);

}
