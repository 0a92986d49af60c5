// The contract of inside_region.clh and host code that runs kernels with it.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(regions)

/// The margins of a FixedRegion, one for each kind of edges (see FixedEdgeKind), and the bits of its grid.
struct RegionGrid
{
    ulong squared_margins[3]; ///< in units of 2^-64, rounded up
    uint margins[3];          ///< in positions, rounded up
    uint bits;
};

END_CONTRACT
