// The rules that chains must keep so that tiles on both sides of them need not know of each other: docs/chain-tiles.md.
//
// All of it is decided in whole numbers. D is the minimum distance 2 r of points, given as its square.
#pragma once

#include "tiles/poisson/chain_pieces.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace poissonlab {

/// The squared distance in the plane.
std::int64_t squared_length(const UnitPosition& a, const UnitPosition& b);

/// A link, the line between two neighbours on a border, is as short as it must be: at most 2 sqrt 3 r, so that a point
/// that is 2 r from both ends is r or more from all of it.
inline bool is_short_link(std::int64_t squared_link, std::int64_t squared_distance)
{
    return squared_link <= 3 * squared_distance;
}

/// A point lies in the cone of an arm: at least r from both of the lines at 45 degrees to the chain's direction that
/// go through the corner point at its end, and between them. `outward`: 1 from the lower end, -1 from the upper.
bool is_in_cone(const UnitPosition& point, const UnitPosition& corner, std::size_t direction, int outward,
                std::int64_t squared_distance);

/// A point is at most half a tile less r away from the edge that its chain goes along; relative to the chain's base.
bool is_near_edge(const UnitPosition& point, std::size_t direction, std::int64_t squared_distance);

/// The fault of a chain by itself, if anything, as the end of a sentence: links, cones, distance from its edge.
std::optional<std::string> fault_of_chain(const ChainPieces& pieces, std::size_t direction, std::uint32_t lower,
                                          std::uint32_t upper, std::int64_t squared_distance);

/// The largest squared distance for which a chain keeps to its cones and near its edge; 0: for none.
std::int64_t squared_clearance(const ChainPieces& pieces, std::size_t direction, std::uint32_t lower,
                               std::uint32_t upper);

/// True if a point lies strictly inside of a simple polygon.
bool is_strictly_inside(std::span<const UnitPosition> polygon, const UnitPosition& point);

/// True if a closed polygon neither touches nor crosses itself.
bool is_simple(std::span<const UnitPosition> polygon);

/// Twice the area of a polygon, positive when it goes counter-clockwise.
std::int64_t twice_area(std::span<const UnitPosition> polygon);

}
