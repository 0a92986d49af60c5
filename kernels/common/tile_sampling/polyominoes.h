// The contract of polyominoes.cl and its host code, host/tile_sampling/polyominoes/polyomino_sampler.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(polyominoes)

/// A torus that is tiled and divided, and the row of the table that its points take their corrections from.
struct Torus
{
    uint roots;       ///< tiles in the beginning
    uint first_level; ///< divisions after which tiles are listed with their classes
    uint depth;       ///< divisions between the tiles that corrections are about and tiles
    uint level;       ///< divisions in all
    uint row;
    uint count;   ///< points
    ulong side;   ///< in units
    int anchor_x; ///< in units, in a tile
    int anchor_y;
};

END_CONTRACT
