// Points in a region of the plane by methods other than dart throwing, in the region's own units.
//
// Obstacles and the boundary keep points away as they do with darts. Methods that are told a number of points take
// distances that follow from the minimum distance (half of it with disks, all of it around obstacles that are points)
// from that of darts of the default relative radius.
#pragma once

#include "host/distribution/regions/region_darts.hpp"

namespace poissonlab {

/// Makes the points. What methods promise: see RegionDarts::sure_distance. Realizations of one seed are independent
/// sets; regions of space, and distances that vary, have the first alone. Throws InputError where there is no room, or
/// no memory.
RegionDarts make_region_points(const RegionPointSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                               std::uint32_t realization = 0);

/// The device memory that this takes in a region of the plane, with one distance. Throws InputError where the distance
/// does not suit the region, or this has no room for Gaussians.
DeviceMemory region_point_memory(const RegionPointSettings& settings, const DeviceInfo& device);

}
