#include "analysis/measures/packing_fraction.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "base/geometry/relative_radius.hpp"

#include <algorithm>

namespace poissonlab {

double packing_fraction(const PointSet& points)
{
    // No two points are farther apart than a point is from its own images, but for a single one.
    const double distance = std::min(min_toroidal_distance(points), 1.0);
    return covered_fraction(distance, points.size(), points.dimension);
}

}
