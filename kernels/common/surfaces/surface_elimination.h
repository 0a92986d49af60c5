// The contract of surface_elimination.cl and its host code, host/sampling/surfaces/surface_elimination.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(surface_elimination)

/// Weights are integers, in units of which the largest of a pair has so many: sums are exact, in any order.
REAL(WEIGHT_UNITS, 0x1p40)

/// A candidate's place and its triangle.
struct Candidate
{
    int place[3];
    uint triangle;
};

/// Which pairs have a weight. Lengths are in units of the surface's grid.
struct Elimination
{
    ulong squared_reach; ///< nearer pairs have a weight,
    double reach;        ///< d_max
    double least;        ///< d_min: nearer pairs weigh no more
    int least_cosine;    ///< where their normals' product is no less
    uint cell;           ///< side of a cell: twice the reach at least
    uint bucket_mask;    ///< a power of two less one
    uint points;
};

END_CONTRACT
