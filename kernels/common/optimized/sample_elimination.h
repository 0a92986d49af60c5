// The contract of sample_elimination.cl and its host code, host/sampling/optimized/sample_elimination.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(sample_elimination)

/// Weights are integers, in units of which the largest of a pair has so many: sums are exact, in any order.
REAL(WEIGHT_UNITS, 0x1p40)

/// Factors of points are whole numbers, and this one is a factor of 1.
enum
{
    FACTOR_UNITS = 16
};

/// With listed cells each cell has this many runs of points, those in the cell itself and in the cells around it. A run
/// is two words: its first point and its end. There are two for each row, as three cells side by side along x lie in
/// two tiles at most.
DERIVED(RUNS, (size_t DIMENSION), DIMENSION == 2 ? 6 : 18)

/// The tiles around a tile, itself among them, or NO_TILE.
DERIVED(TILES_AROUND, (size_t DIMENSION), DIMENSION == 2 ? 9 : 27)
enum
{
    NO_TILE = 0x7fffffff
};

/// The arguments of the kernels, about a set. Lengths are in units of 2^-32.
struct Elimination
{
    ulong squared_reach; ///< nearer pairs have a weight
    double reach;        ///< d_max
    double least;        ///< d_min: nearer pairs weigh no more
    uint points;
    uint grid_size; ///< cells along each axis, of at least the reach, or one
    uint tiles;     ///< along each axis: one, or an even number of tiles at least two cells wide; with listed cells,
                    ///< the number after the last tile of the colour
    uint stride;    ///< of coordinates
};

/// Counts of the tiles.
struct EliminationCounts
{
    uint removed;  ///< points, so far
    uint of_round; ///< those of a round
};

END_CONTRACT
