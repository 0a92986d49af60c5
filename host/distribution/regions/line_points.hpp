// This throws darts onto lines of the plane: along roads, shores and fences, and onto outlines.
//
// Distances are straight through the plane, so that points keep them where lines cross, bend or run side by side, and
// along a line all the more. A point takes an interval of each straight piece that is near, and darts fall into what is
// left of all pieces, uniformly by length: their law is that of darts that are dropped where they are too near, but no
// dart fails. All lines together have 2^52 positions, and darts fall until none of these is free: then no further point
// fits. On one straight line that is Rényi's parking problem (1958).
#pragma once

#include "host/distribution/regions/region_darts.hpp"

namespace poissonlab {

/// Returns the length of lines; an edge that comes twice, as where two parcels meet, counts once.
double length_along(const std::vector<RegionRing>& lines);

/// Returns the distance in units of the region: the given one or, for so many points, `relative_radius` of the length
/// that each of them has. Throws InputError where it is more than their extent, or so small that the work needs too
/// much memory.
double distance_along(const DartSettings& settings, const std::vector<RegionRing>& lines);

/// Throws darts onto the lines of the region of the settings, whose reading is along. Distances that are computed from
/// coordinates are never below the minimum distance. Throws InputError as throw_region_darts() does.
RegionDarts throw_line_darts(const DartSettings& settings, std::uint64_t seed, std::uint32_t realization = 0);

}
