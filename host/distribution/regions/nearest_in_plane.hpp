// The distance of the nearest points of a set in the plane, without a torus.
#pragma once

#include "analysis/measures/distance_statistics.hpp"
#include "base/geometry/point_set.hpp"

namespace poissonlab {

/// The least and the mean distance of nearest points. There are two points or more, in any units.
NearestDistances nearest_distances(const PointSet& points);

}
