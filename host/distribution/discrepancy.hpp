// The discrepancy of sets in the unit square: by how much the part of the points in boxes [0, x) x [0, y) differs from
// their area.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/kinds/kind.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// Returns the L2 star discrepancy of the first points of a set, for each of `counts`, which ascend and are at most the
/// set's size: the root of the mean square over all boxes. By the closed form of Warnock (1972); O(N^2) for all
/// together.
std::vector<double> l2_star_discrepancies(const PointSet& points, const std::vector<std::size_t>& counts);

/// Returns the star discrepancy of the first `count` points, at least 1: the largest difference of all boxes. Exact but
/// for rounding, O(N^2); see Niederreiter, Discrepancy and convex programming, 1972.
double star_discrepancy(const PointSet& points, std::size_t count);

Kind discrepancy_kind();

}
