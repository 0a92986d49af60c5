// Recursive Wang tiles, their borders: a strip of one set of points is laid over another one along a line that runs
// between points that are far from each other.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, SIGGRAPH 2006: the shortest
// path along the borders of the Voronoi cells of both sets, within the triangle of an edge and the middle of the tile.
// Departure: outside of the corners the path keeps half a spacing away from all edges, so that a strip beside every
// edge has the points of that edge's set alone.
#pragma once

#include "tiles/recursive/recursive_tile_set.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

enum class TileSide
{
    north,
    east,
    south,
    west
};

/// A point that comes from a set in its order.
struct RankedPlace
{
    std::uint32_t rank = 0;
    RecursivePlace place{};

    auto operator<=>(const RankedPlace&) const = default;
};

/// The points of a tile with those of a set, whose periodic copies continue it, along one side. Both have the same
/// points within two spacings of corners. `spacing` is that of as many points in the densest packing, tile sides.
std::vector<RankedPlace> with_edge(const std::vector<RankedPlace>& tile, const std::vector<RankedPlace>& edge,
                                   TileSide side, double spacing);

/// The radius around corners, in spacings, in which all sets have the same points.
inline constexpr double shared_corner = 2;

/// The width of the strips, in spacings.
inline constexpr double own_strip = 0.5;

}
