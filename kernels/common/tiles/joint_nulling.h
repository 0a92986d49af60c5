// The contract of joint_nulling.cl and its host code, host/tile_construction/joint/joint_relaxation.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(joint_nulling)

enum
{
    TURN = 1 << 16 ///< entries of the circle: as many as a tile's side has units
};

struct Nulling
{
    uint points, frequencies;
    double step;    ///< units, for a weight of 1
    double longest; ///< movement, units
};

END_CONTRACT
