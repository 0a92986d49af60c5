// Points in a region whose minimum distance varies from place to place: what settings ask for, and what is proven.
//
// Two points keep the smaller of the distances at their places, or the mean of both. What the slope of distances may be
// follows from that. A point p has a neighbour q at a distance of t: where the smaller distance is kept and r changes
// by s along a unit of length, r(q) is r(p) - s t at least, so that t is r(p) / (1 + s) at least; and where no further
// point fits, the largest circle without points that touches p has a radius R below the distance at its middle, which
// is r(p) + s R at most: R < r(p) / (1 - s). So a point's distance says how far its neighbours are, from below and from
// above, while s is below 1. With the mean, half of s takes the place of s, and 2 the place of 1: disks of half the
// distance must not grow faster than one moves away. Mitchell et al., Variable radii Poisson-disk sampling, CCCG 2012,
// table 1, has the same bounds for the smaller distance.
#pragma once

#include "base/regions/distance_field.hpp"
#include "host/distribution/regions/region_darts.hpp"
#include "host/sampling/varied/varied_darts.hpp"

#include <cstdint>
#include <memory>

namespace poissonlab {

/// The slope that distances must stay below.
double slope_limit(KeptDistance between);

/// A request for points, but for its random numbers. The distances of the field are those of the table times `scale`.
struct VariedRequest
{
    RegionDartRequest place; ///< min_distance is the least one
    DistanceAt distance;     ///< in units of the region
    DistanceTable table;
    double scale = 1;
    VariedDartRequest darts;
};

/// The set that was made, and how near its pairs are.
struct VariedSet
{
    VariedRequest request;
    double scale = 1;                ///< of the distances that the set keeps, as it came to be
    std::vector<double> distances{}; ///< at each point, times scale, in units of the region
    std::vector<double> nearest{};   ///< of each point: the least distance of another one over what the two keep
    double least = 0;                ///< of all pairs
    bool is_proven = false;          ///< all pairs keep the table's distances: looked at by whole numbers
    double least_as_typed = 0;       ///< of all pairs, with the distances of the formula or picture themselves
};

/// Reads the distances and checks them. Throws InputError, a line about them, or about other settings that do not go
/// with distances that vary.
VariedRequest varied_request(const RegionPointSettings& settings, const std::shared_ptr<const RegionLand>& land);

/// Makes points by darts, relaxation dart throwing or elimination. Throws InputError where there is no room, or no
/// memory.
RegionDarts make_varied_points(const RegionPointSettings& settings, std::uint64_t seed, const DistributionPlace& place);

}
