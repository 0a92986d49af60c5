// The contract of relaxation_dart_throwing.cl and its host code, host/sampling/relaxation_dart_throwing.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(relaxation_dart_throwing)

/// Darts come from blocks of four random words: in 2D darts 2 j and 2 j + 1 from block j, in 3D dart j.
DERIVED(DARTS_A_BLOCK, (size_t DIMENSION), 4 / DIMENSION)

enum
{
    BLOCKS_A_FLAG_ITEM = 8, ///< blocks that a work-item of throw_darts owns; flags are a byte a block
    DARTS_A_WORD = 64       ///< candidates are a bit a dart
};

/// A point as words: position, 1 + the number of the next point in the cell's chain, and with squares (REGION 2) the
/// number of the square that its dart fell into.
DERIVED(POINT_WORDS, (size_t DIMENSION, size_t REGION), DIMENSION + 1 + (REGION == 2))

/// A cell as words: the position of the last point in it, and a link: 1 + the number of that point, with the
/// uppermost bit if there are more, or 0.
enum
{
    LINK_WORD = 3,
    CELL_WORDS
};

/// The state of the algorithm, as 64-bit words in global memory.
enum State
{
    NEXT_DART,     ///< the first dart that is not decided
    LEVEL,         ///< how often the radius was reduced
    FAILURES,      ///< in a row
    POINTS,        ///< accepted so far
    FIRST_NEW,     ///< the first point that is not in the table yet
    LOW_LEVEL,     ///< the batch at hand must not go beyond this level
    LOW_THRESHOLD, ///< the squared minimum distance there
    CANDIDATES,    ///< looked at by settle_candidates so far
    STATE_WORDS
};

/// The cells of points: `size` along each axis. With squares they are folded, so that as many as one likes share
/// 2^number_bits numbers; else that is 0.
struct PointCells
{
    uint size;
    uint number_bits;
};

/// The arguments of settle_candidates.
struct Settling
{
    ulong first_level; ///< of the thresholds
    ulong attempts;
    uint words;        ///< of candidates
    uint key_x, key_y; ///< of random numbers
    uint target;       ///< points
    uint levels_ahead; ///< that the next batch is allowed
    struct PointCells cells;
    uint unused;
};

/// The squares that darts fall into, of a region that is long: 2^shift positions wide. Blocks of the table have
/// 2^block_bits parts along each axis (host/sampling/relaxing_grids.hpp).
struct DartSquares
{
    uint count;
    uint shift;
    uint block_bits;
};

/// The box that darts fall into, with a region; 2^31 positions along each axis at most.
struct DartBox
{
    uint low[3];
    uint size[3];
};

END_CONTRACT
