// The contract of inside_region.clh and host code that runs kernels with it.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(regions)

/// The margins of a FixedRegion, one for each kind of edges (see FixedEdgeKind), the bits of its grid, and those by which
/// cells with many edges are divided further; 0: none is.
struct RegionGrid
{
    ulong squared_margins[3]; ///< in units of 2^-64, rounded up
    uint margins[3];          ///< in positions, rounded up
    uint bits;
    uint fine_bits;
    uint unused;
};

END_CONTRACT
