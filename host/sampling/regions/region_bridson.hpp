// Bridson's dart throwing in a region of the plane or of space.
//
// Bridson, Fast Poisson disk sampling in arbitrary dimensions, 2007. Darts fall around the points that are there, until
// none of them finds room. What they do not reach from there, other polygons and places behind narrows, is begun anew
// by darts anywhere in the region, until very many of these fail in a row: nearly saturated.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/random/random.hpp"
#include "base/regions/fixed_region.hpp"
#include "base/regions/fixed_space.hpp"
#include "host/sampling/regions/region_candidates.hpp"

#include <cstdint>

namespace poissonlab {

struct RegionBridsonRequest
{
    double min_distance = 0;     ///< in (0, 1/2], unit lengths of the torus
    std::uint32_t attempts = 30; ///< darts around a point before it is given up
    std::uint32_t starts = 1000; ///< darts anywhere that fail in a row before the set is taken for finished
    StreamKey stream{};
    CandidateArea area = CandidateArea::box; ///< for darts anywhere
};

/// Points in the order in which they were found, in the region's fixed-point coordinates; none where there is no room.
PointSet throw_bridson_darts(const FixedRegion& region, const RegionBridsonRequest& request);
PointSet throw_bridson_darts(const FixedSpace& space, const RegionBridsonRequest& request);

}
