// The contract of farthest_point.cl, its host code, host/sampling/optimized/farthest_point.cpp, and its twin.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(farthest_point)

enum
{
    NEIGHBOUR_REACH = 2, ///< cells on either side of a point's own in which its neighbours are looked for
    COLORS = 3        ///< along each axis: cells of one color are so far apart that none is in the window of another
};

/// Points of a ring of cells are as far away as the cells between are wide, less what rounding does.
REAL(RING_SLACK, 1e-9)

END_CONTRACT
