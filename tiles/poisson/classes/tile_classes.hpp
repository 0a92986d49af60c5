// The classes of the points of a tile set: trees, bushes, stones.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010 (the matrix of distances); here for every tiling of a set. A
// class has as many points in each tile. A tile's points come class after class, so that the place of a point says its
// class.
#pragma once

#include "base/geometry/class_distances.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

struct TileClasses
{
    std::vector<std::uint32_t> points; ///< of each class in a tile
    ClassDistances distances;          ///< that any two classes keep, in tiles

    bool is_empty() const { return points.empty(); }
    std::size_t count() const { return points.size(); }
    std::uint32_t all_points() const;

    /// The number of a class' first point in its tile.
    std::uint32_t first_point(std::uint32_t of) const;

    /// The class of a point, by its number in its tile.
    std::uint32_t class_of(std::uint32_t point) const;

    double least_distance() const;
    double largest_distance() const;

    bool operator==(const TileClasses&) const = default;
};

/// Classes with so many points each. The distance within a class is `relative_radius` times the largest that its points
/// could have alone; distances between classes follow by Wei's rule.
TileClasses classes_of_radius(std::vector<std::uint32_t> points, double relative_radius, int dimension);

/// The place of a pair in lists of all pairs: (0, 0), (0, 1), (1, 1), (0, 2), ...
constexpr std::size_t class_pair(std::size_t i, std::size_t j)
{
    const std::size_t low = i < j ? i : j, high = i < j ? j : i;
    return high * (high + 1) / 2 + low;
}

constexpr std::size_t class_pair_count(std::size_t classes) { return classes * (classes + 1) / 2; }

/// Throws InputError with the key as it is called in configs, and no place: numbers out of range, or points that are
/// not as many as a tile has.
void check(const TileClasses& classes, std::uint32_t points_per_tile);

}
