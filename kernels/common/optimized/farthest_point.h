// The contract of farthest_point.cl, its host code, host/sampling/optimized/farthest_point.cpp, and its twin.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(farthest_point)

enum
{
    NEIGHBOUR_REACH = 2, ///< cells on either side of a point's own in which its neighbours are looked for
    COLORS = 5,          ///< along each axis, or as many as cells: windows of one color have no cell in common
    BATCH = 16           ///< neighbours that cut a Voronoi cell, before the next ones are looked for
};

END_CONTRACT
