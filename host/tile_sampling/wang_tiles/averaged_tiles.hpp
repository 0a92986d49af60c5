// Wang tiles by relaxation in the mean of all surroundings.
//
// Hiller, Deussen and Keller, Tiled blue noise samples, 2001; Cohen, Shade, Hiller and Deussen, Wang tiles for image
// and texture generation, 2003, section 3.3; Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.7. A point
// moves by what Lloyd relaxation would do to it, on average over all 4,096 ways to surround its tile; or, as in 2003,
// in one random surrounding. These functions are plain; averaged_tile_kernel.cpp does the same on a device.
//
// Eight Wang tiles with points, of which stochastic tilings are made: the tiles of the methods before Poisson disk
// tiles.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 3.2.1 and 3.3.2.2: all tiles over two colours the sum
// of whose edges is even, laid by one hash function at corners. Beside an edge lies any of four tiles, at a corner any.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/device_method.hpp"
#include "tiles/tilings/even_wang_tiles.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

inline constexpr std::size_t wang_point_tiles = even_wang_tiles;

/// A place in a tile, in units of 1/65,536 of its side: coordinates are from 0 to 65,535.
using WangPoint = std::array<std::int32_t, 2>;

struct WangPoints
{
    std::array<std::vector<WangPoint>, wang_point_tiles> tiles;

    bool operator==(const WangPoints&) const = default;
};

/// The squared distances, in units, of the two nearest points in one tile, and in two tiles that may lie beside each
/// other; INT64_MAX without any.
std::int64_t squared_distance_within(const WangPoints& points);
std::int64_t squared_distance_across(const WangPoints& points);

/// The points of a toroidal tiling of `side` tiles along each axis, tile by tile.
PointSet wang_torus(const WangPoints& points, std::uint64_t seed, std::uint32_t side);

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

// Averaged tiles on a device, by kernels/averaged_tiles.cl: those of average_once(), bit for bit.

// Wang tiles by dart throwing against every tile that may lie beside.
//
// Shade, Cohen and Mitchell, Tiling layered depth images, 2000; Lagae, Tile-Based Methods in Computer Graphics, 2007,
// section 6.6: near an edge a dart meets the points of four tiles, near a corner those of all, so that few fit there.

/// Darts into random tiles until so many in a row have failed. `squared_distance` in units; shorter than half a tile.
WangPoints throw_shade_tiles(std::uint64_t squared_distance, std::uint32_t attempts, std::uint64_t seed);

class AveragedTiles : DeviceMethod<struct AveragedTileBuffers>
{
public:
    /// `work_group_size` 0: the default.
    explicit AveragedTiles(Device device, std::size_t work_group_size = 0);

    /// One iteration, as average_once(). All tiles have equally many points.
    WangPoints average_once(const WangPoints& points, AveragedVariant variant, std::uint32_t iteration,
                            std::uint64_t seed);

    /// The memory that tiles of so many points take.
    static DeviceMemory memory(std::size_t points_per_tile);

private:
    WangPoints average_over_all(const WangPoints& points);
    WangPoints average_in_one(const WangPoints& points, std::uint32_t iteration, std::uint64_t seed);
};

}
