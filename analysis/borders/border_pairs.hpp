// Do the closest pairs of a set meet across its border? Of a set that is periodic, they do as seldom as any pairs.
//
// A set on the torus does not know where its border is. So a pair of points with the displacement v has the border
// between its points with the probability 1 - (1 - |v_x|)(1 - |v_y|), at most |v_x| + |v_y|. No N points are all
// further apart than the largest possible minimum distance, which bounds this by D N^(-1/D) for the closest pairs in D
// dimensions; that is also the share of a grid's borders of cells that are the set's own border, where points know
// their cells (jittered grids). A set of the plane that is treated as periodic, such as scipy's Poisson disks, keeps
// its distance inside but not across the border: all of its closest pairs are there.
//
// In a box a pair is across the border more often by the inverse of the shortest side, at most.
//
// The test: the pairs that are closer than the closest pair inside are all across the border. Were the set periodic,
// each of the closest pairs would be so with that probability, and the number of those that come before the first pair
// inside would have a geometric distribution.
#pragma once

#include "base/geometry/periodic_box.hpp"
#include "base/geometry/point_set.hpp"
#include "base/points/point_strips.hpp"

#include <cstddef>
#include <cstdint>

namespace poissonlab {

/// The number of pairs, no point in two of them, that are closer than the closest pair of the window, distance
/// `least_in_window`, by more than what rounding in files may do, two per cent: all of them are across the border.
std::size_t closer_pairs_across(const PointSet& points, double least_in_window, const PeriodicBox& box = {});
std::size_t closer_pairs_across(const PointStrips& points, double least_in_window);

/// The probability that so many pairs or more come before the first ones inside, of `sets` periodic sets together of N
/// points each. `tiles` along an axis that sets are made of, whose borders are the set's more often; 0: none.
double chance_of_pairs_across(std::uint64_t pairs, std::size_t sets, std::size_t points, int dimension, int tiles = 0,
                              const PeriodicBox& box = {});

/// Less than this is said to be no chance: a false alarm in 100,000 series.
inline constexpr double least_chance_across = 1e-5;

}
