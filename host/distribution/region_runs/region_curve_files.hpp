// The curves of points in a region as a file of results.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/regions/plane_region.hpp"
#include "results/pictures/distribution_files.hpp"

namespace poissonlab {

/// Adds region.csv, as analyses have it, and the numbers that say how it was made: of two points or more, up to
/// 300,000; up to 5,000, with the bands of random sets. Points are in the region's units.
void add_region_curves(const PlaneRegion& region, const PointSet& points, DistributionFiles& files,
                       DistributionResult& result);

}
