// The contract of tile_finder.cl and its host code, host/isohedral_tiling/tile_finder.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(tile_finder)

/// Bits after the point of coordinates along the translations.
DERIVED(LATTICE_BITS, (), 26)

/// A tile that reaches into the unit at (0, 0), in units of 2^-26 of the translations.
struct Candidate
{
    int aspect;
    int column, row;    ///< of its own unit
    int first, count;   ///< its outline among the corners, as of unit (0, 0)
    int low_x, low_y;   ///< what its outline reaches, as of unit (0, 0)
    int high_x, high_y;
    int anchor_x, anchor_y; ///< where the middle of the tile is, as of unit (0, 0)
};

/// Which tile, and where in it.
struct FoundTile
{
    int aspect;
    int column, row;
    int x, y; ///< from the middle of the tile
};

END_CONTRACT
