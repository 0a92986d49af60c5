// Sample elimination in a region of the plane or of space.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/kinds/distribution_place.hpp"

#include <cstddef>

namespace poissonlab {

/// The `kept` points of `all` that sample elimination leaves, in progressive order, by kernel or reference; weights are
/// divided by what the boundary takes of them. `Region` is FixedRegion or FixedSpace, which the points lie in; `area`
/// is its own on the torus. Throws InputError where a device has no memory for it.
template <typename Region>
PointSet eliminate_in_region(const Region& region, const PointSet& all, std::size_t kept, double area,
                             const DistributionPlace& place);

}
