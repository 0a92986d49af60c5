// Random points whose density follows distances that vary, and sample elimination of them.
//
// Yuksel, Sample elimination for generating Poisson disk sample sets, 2015, section 4.3 (adaptive sampling): distances
// of pairs count over those that the two are to keep.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/sampling/varied/varied_cells.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// Independent points with a density of 1 / distance^2, and the part of all darts that they are. Fewer than so many
/// where ten million darts in a row fall outside.
struct VariedCandidates
{
    std::vector<TorusPoint<2>> points;
    double share = 0;
};

VariedCandidates varied_candidates(const VariedDartRequest& request, std::size_t count);

/// So many of these points in an order whose every prefix is well spread: see eliminate(). `packing` is that of the
/// request's distances, see DistanceTable::packing, in its region. By a heap, on the host.
PointSet eliminate_varied(const VariedDartRequest& request, const std::vector<TorusPoint<2>>& points, std::size_t kept,
                          double packing);

}
