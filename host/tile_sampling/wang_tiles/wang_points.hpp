// Eight Wang tiles with points, of which stochastic tilings are made: the tiles of the methods before Poisson disk
// tiles.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 3.2.1 and 3.3.2.2: all tiles over two colours the sum
// of whose edges is even, laid by one hash function at corners. Beside an edge lies any of four tiles, at a corner any.
#pragma once

#include "base/geometry/point_set.hpp"
#include "tiles/tilings/even_wang_tiles.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
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

}
