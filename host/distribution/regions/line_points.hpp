// Points on lines of the plane by dart throwing: along roads, shores and fences, and on outlines.
//
// Distances are straight through the plane, so that points keep them where lines cross, bend or run side by side, and
// along a line all the more. What a point takes of a straight piece is an interval, and darts fall into what is left of
// all pieces, uniformly by length: the law is that of darts of which those that are too near are dropped, and no dart
// fails. Lines have 2^52 positions, of which the last free one is found: then no further point fits. On one straight
// line that is Rényi's parking problem (1958).
#pragma once

#include "host/distribution/regions/region_darts.hpp"

namespace poissonlab {

/// The distance in units of the region: the given one or, of so many points, `relative_radius` of the lines' length for
/// each. Throws InputError where it is more than their extent, or so small that the work needs too much memory.
double distance_along(const DartSettings& settings, const std::vector<RegionRing>& lines);

/// Throws darts onto the lines of the region of the settings, whose reading is along. Distances that are computed from
/// coordinates are never below the minimum distance. Throws InputError as throw_region_darts() does.
RegionDarts throw_line_darts(const DartSettings& settings, std::uint64_t seed, std::uint32_t realization = 0);

}
