// The contract of self_similar.cl and its host code, host/distribution/self_similar_search.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(self_similar)

enum
{
    MAX_BITS = 24,       ///< points of a tile, and bits of a start
    SECOND_STARTS = 4096 ///< that a work-item pairs with its first one
};

struct StartSearch
{
    uint bits;
    uint firsts, seconds; ///< starts
    float least;          ///< squared distance, in squared units of 1 / (2^bits - 1)
    uint capacity;        ///< of what is found
};

END_CONTRACT
