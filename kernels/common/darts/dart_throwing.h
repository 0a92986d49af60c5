// The contract of dart_throwing.cl, darts_in_order.cl and darts_in_rounds.cl and their host code,
// host/sampling/dart_throwing.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(dart_throwing)

/// A dart as words: position, time, level 0 cell.
DERIVED(DART_WORDS, (size_t DIMENSION), DIMENSION + 2)

/// An accepted dart as words: position, time.
DERIVED(POINT_WORDS, (size_t DIMENSION), DIMENSION + 1)

/// An open cell as words: its coordinates on the torus and, with bricks, the number of the level 0 cell that it lies in,
/// with the uppermost bit where it lies inside the region.
DERIVED(PARENT_WORDS, (size_t DIMENSION, size_t BRICKS), DIMENSION + BRICKS)

/// Bricks have so many cells of level 0, 2^BRICK_BITS along each axis.
enum
{
    BRICK_CELLS = 64
};
DERIVED(BRICK_BITS, (size_t DIMENSION), DIMENSION == 2 ? 3 : 2)

/// The bricks around a brick, itself among them.
DERIVED(BRICKS_AROUND, (size_t DIMENSION), DIMENSION == 2 ? 9 : 27)

/// This stands for a brick that the grid has not got.
enum
{
    NO_BRICK = 0x7fffffff
};

/// A bit for each cell of the window around a cell of level 0, which has REACH cells on either side.
DERIVED(MASK_WORDS, (size_t DIMENSION, size_t REACH),
        ((2 * REACH + 1) * (2 * REACH + 1) * (DIMENSION == 2 ? 1 : 2 * REACH + 1) + 31) / 32)

/// A dart's rivals are listed in the first round: their number, then the first of them. Those with more, which are very
/// rare, list what is left of their rivals again in every round.
enum
{
    MAX_RIVALS = 7,
    RIVAL_WORDS = MAX_RIVALS + 1
};

/// Counters in global memory.
enum Counter
{
    OPEN_CELLS,
    DARTS,
    POINTS,
    WAITING_ROUND, ///< 1 + the last round in which a dart had to wait for another round
    KEYS,          ///< that slabs have sorted
    COUNTERS
};

/// Parents of a work-item of throw_darts, a multiple of eight.
enum
{
    THROW_RUN = 16
};

/// Words of local memory that a work-group of throw_darts counts in.
enum
{
    GROUP_WORDS = 4
};

/// Which cells of the torus the grid holds: as many along each axis as the grid has, from `first` on, around the torus.
struct GridPart
{
    uint first[3];
    uint torus_size; ///< cells of level 0 along each axis of the torus; those of the grid where it is all of it
};

/// The arguments of throw_darts. Capacities are numbers of cells and of darts.
struct Batch
{
    ulong step; ///< cell width of level 0, units of 2^-64
    ulong squared_min_distance;
    struct GridPart part;
    uint grid_size; ///< cells of level 0 along each axis
    uint number;
    uint parents;
    int level;          ///< of the children or, where there is no split, of the parents, which then take their place
    uint is_split;      ///< else parents have one child, themselves
    uint is_last_level; ///< of no further split
    uint key_x, key_y;  ///< of random numbers
    uint thresholds;
    uint open_capacity, dart_capacity;
    uint staged_capacity; ///< of cells, and of darts, in local memory
};

/// The arguments of settle_darts.
struct Slabs
{
    ulong squared_min_distance;
    uint slabs;
    uint grid_size; ///< cells of level 0 along each axis, or the number of bricks
    uint row_words; ///< that a row of cells has in `accepted`; bricks have none
    uint darts;
    uint bucket_bits; ///< 2^bucket_bits intervals of time, from 1 to 31
    uint is_rest;     ///< only darts that are undecided
};

END_CONTRACT
