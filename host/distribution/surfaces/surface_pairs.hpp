// Nearest-neighbour distances of points of several classes on a surface: straight through space, and how results show
// them.
#pragma once

#include "host/sampling/surfaces/fixed_surface.hpp"
#include "results/pictures/distribution_result.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// The distances of points of one class from their nearest ones of another, or of the same.
struct SurfaceNearest
{
    double least = 0; ///< in the mesh's units; infinite where no point sees another
    double mean = 0;  ///< of points that see one; NaN where none does
};

/// Measures the points of `from` against those of `to`, or against each other where both are one object. Two points see
/// each other where the product of their normals is no less than `least_cosine`. Points that see none within some
/// sixteen mean distances of `to` count as seeing none where they have more than 10^9 pairs with `to`. Squares are
/// exact. Any number of threads gives the same bytes. Time is O(N log N) for well-spread points that see each other.
SurfaceNearest surface_nearest(const FixedSurface& surface, const std::vector<SurfacePoint>& from,
                               const std::vector<SurfacePoint>& to, std::int32_t least_cosine);

/// A pair of classes, or one class twice.
struct SurfacePair
{
    std::size_t first = 0, second = 0;
    SurfaceNearest from_first, from_second;
};

/// Measures all pairs of classes: (0, 0), (0, 1), (1, 1), (0, 2), ... `by_class` has the points of each.
std::vector<SurfacePair> surface_pairs(const FixedSurface& surface,
                                       const std::vector<std::vector<SurfacePoint>>& by_class,
                                       std::int32_t least_cosine);

/// Adds the least and the mean nearest distances of pairs, those that there are. Titles call classes by their names.
/// `are_along`: distances were measured along the surface.
void append_pair_numbers(const std::vector<SurfacePair>& pairs, const std::vector<std::string>& names, bool are_along,
                         std::vector<DistributionNumber>& numbers);

/// A row for each pair of classes: the least distance and the mean nearest ones in both directions.
DistributionTable pair_table(const std::vector<SurfacePair>& pairs, const std::vector<std::string>& names,
                             bool are_along);

}
