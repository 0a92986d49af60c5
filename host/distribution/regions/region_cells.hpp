// The cells in which darts look for room in a region: a cube of them around it or, where that would be nearly empty,
// bricks; and what regions are too large, or too long, for both.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "base/regions/fixed_space.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/regions/region_candidates.hpp"

namespace poissonlab {

/// Sets the block or the bricks of a request, which has its distance and its region. `side` is that of the torus in
/// units of the region, for messages. Throws InputError where the distance is too short.
void choose_cells(DartThrowingRequest& request, double side);

/// Is a region so long that a cube of cells around it would have more than memory has room for? Methods whose random
/// numbers belong to a box around the region take them for its cells then.
bool is_long(double min_distance, int dimension);

/// Says what candidates fall into for such a distance.
CandidateArea candidate_area(double min_distance, int dimension);

}
