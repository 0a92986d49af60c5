// The contract of warp.cl and its host code, host/sampling/warp/warp.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(warp)

enum
{
    POINTS_AN_ITEM = 16 ///< that a work-item warps
};

struct Warping
{
    uint points;
    uint width, height; ///< pixels
};

END_CONTRACT
