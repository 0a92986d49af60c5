// Points on the boundary of a region, before any inside: corners first, then evenly along edges.
//
// The order of Ebeida et al., Efficient maximal Poisson-disk sampling, SIGGRAPH 2011, section 3, where features of
// lower dimension are sampled first. Nothing here is random: an edge between two corners that are points is divided
// into equal parts, as many as its length has room for; then whatever room is left on an edge is filled from its begin
// on.
#pragma once

#include "base/regions/fixed_region.hpp"

#include <vector>

namespace poissonlab {

/// Positions on the boundary, to within a position of the grid, no two of them nearer than `min_distance` (in unit
/// lengths of the torus, up to 1/2), and so many that no place on an edge is that far from all of them, but for two
/// positions. Those that margins of the region forbid are left out.
std::vector<TorusPoint<2>> boundary_points(const FixedRegion& region, double min_distance);

}
