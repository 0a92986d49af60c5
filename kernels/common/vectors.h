// The number of points that kernels look at as one vector, and how much farther than the last point they read.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(vectors)

enum
{
    LANES = 8,
    PADDING = 2 * LANES ///< entries after the last point that exist: kernels begin with two vectors
};

END_CONTRACT
