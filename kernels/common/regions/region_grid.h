// The contract of inside_region.clh and host code that runs kernels with it.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(regions)

/// What is known of a FixedRegion beside its lists. Margins are those of kinds of edges: see FixedEdgeKind.
struct RegionGrid
{
    ulong squared_margins[3]; ///< in units of 2^-64, rounded up
    uint margins[3];          ///< in positions, rounded up
    uint bits;
};

END_CONTRACT
