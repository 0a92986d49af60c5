// Points in a region of space by dart throwing, relaxation dart throwing, sample elimination and Bridson's method, in
// the region's own units.
//
// The region lies in an eighth of the unit torus (see base/regions/fixed_space.hpp), as regions of the plane lie in a
// quarter, and what holds there holds here.
#pragma once

#include "analysis/measures/distance_statistics.hpp"
#include "host/distribution/regions/region_darts.hpp"

#include <memory>

namespace poissonlab {

/// The request for points, in units of the torus and in those of the region.
struct SpaceDartRequest
{
    std::shared_ptr<const FixedSpace> space; ///< with what the boundary takes from it
    double min_distance = 0;                 ///< in the region's units
    DartThrowingRequest darts;
};

/// The region by itself, unless the settings have it. Throws InputError.
std::shared_ptr<const FixedSpace> whole_space(const DartSettings& settings);

/// Checks that the distance suits the region, from which the boundary takes nothing yet. Throws InputError.
SpaceDartRequest space_distance_request(const DartSettings& settings, std::uint64_t seed);

/// The request for points in what the boundary leaves of the region, which takes some time for a solid.
SpaceDartRequest space_dart_request(const DartSettings& settings, std::uint64_t seed);

/// Makes the points: RegionDarts::space is theirs. Throws InputError where there is no room, or no memory.
RegionDarts make_space_points(const RegionPointSettings& settings, std::uint64_t seed, const DistributionPlace& place);

/// The least and the mean distance of nearest points, in the region's units. There are two points or more.
NearestDistances nearest_in_space(const FixedSpace& space, const PointSet& points);

}
