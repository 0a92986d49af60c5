// The contract of lloyd_sets.cl, and of its host code, host/sampling/lloyd_sets.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(lloyd_sets)

enum
{
    SUMMARY_RUN = 256 ///< points whose sums are taken together, in relaxation.cl as well
};

/// Sets of as many points each.
struct Sets
{
    uint count;
    uint points;
    uint measures; ///< of each set's iterates
    uint moves;    ///< as many, or one less
};

END_CONTRACT
