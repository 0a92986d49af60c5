// The contract of recursive_tiles.cl and its host code, host/tile_sampling/recursive/recursive_sampler.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(recursive_tiles)

enum
{
    TILES = 8,
    CELLS = 16,      ///< of a tile, row by row from the lower left
    POINT_BITS = 12, ///< of a link; its cell comes above
    WEIGHT_BITS = 40 ///< of a density's full weight
};

/// A tile of a level, and the ranks of it that may have points.
struct RankedTile
{
    ulong cell_x, cell_y; ///< in tiles of the level
    ulong turn;           ///< when it gets its next point: parts of 2^32 of one
    uint tile;
    uint first; ///< rank
    uint begin; ///< where its ranks begin among those of all tiles
    uint unused;
};

/// The tiles of a level on a torus, and the density there.
struct RankedLevel
{
    ulong most;   ///< points per tile of level 0 at full weight, parts of 2^32 of one
    ulong across; ///< tiles of the next level along each axis: below 2^32
    uint level;
    uint tiles, ranks; ///< of all tiles
    uint points_per_tile;
    uint width, height; ///< of the density
    uint is_uniform;
    uint unused;
};

END_CONTRACT
