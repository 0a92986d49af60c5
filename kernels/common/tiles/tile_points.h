// The contract of tile_points.cl and its host code, host/tile_points/tile_points.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(tile_points)

/// A run of tiles in a block: it starts at (x, y, z), and goes on along x, then y, then z.
struct Run
{
    uint x, y, z;
    uint count;
    uint width, height;     ///< of the block
    uint reciprocal, shift; ///< n / width = n * reciprocal >> shift for n below 2^31
};

/// The tiling that a block is cut out of.
struct Window
{
    uint seed;
    int period;
    int west, south, bottom; ///< of the block
};

END_CONTRACT
