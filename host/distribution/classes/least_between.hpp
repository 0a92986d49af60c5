// The least distance of points of one set from those of another, on the unit torus.
#pragma once

#include "base/geometry/point_set.hpp"

namespace poissonlab {

/// In unit lengths; infinity where a set is empty. Coordinates lie in [0, 1); where they are multiples of 2^-32,
/// squares are exact, and one rounding follows. Time is O(N log N) for well-spread points.
double least_distance_between(const PointSet& a, const PointSet& b);

}
