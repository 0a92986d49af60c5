// The contract of averaged_tiles.cl and its host code, host/tile_sampling/wang_tiles/averaged_tile_kernel.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(averaged_tiles)

enum
{
    TILES = 8,
    TILE_UNITS = 65536, ///< a tile's side
    SIDES = 4,          ///< west, east, south, north
    BESIDE = 4,         ///< tiles that fit at a side
    QUADRANTS = 4,      ///< towards the east: bit 0, the north: bit 1
    BETWEEN = 2,        ///< tiles that fit between those at two sides
    SURROUNDING = 9     ///< tiles, row by row from the lower left
};

/// Beyond 3 x 3 tiles, in units.
REAL(CELL_REACH, 262144.0)

/// The way from a point to where it should be.
struct CentroidShift
{
    int x, y;      ///< units
    uint is_known; ///< 0: in some surrounding more than the quadrant's tiles matter, or a cell has too many corners
    uint unused;
};

END_CONTRACT
