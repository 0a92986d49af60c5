// The contract of voronoi_darts.cl, its host code, host/sampling/voronoi_darts.cpp, and its twin.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(voronoi_darts)

enum DartState
{
    UNDECIDED,
    ACCEPTED,
    REJECTED
};

enum
{
    MAX_TRIALS = 64,   ///< for a place in a piece of free space: each fails with a probability of at most 2/3
    MAX_GAP = 16       ///< cells of the grid between a site and the cells that are looked into
};

/// The free area of a cell that has too many vertices, or neighbours too far away, for this method.
#define UNKNOWN_AREA 0xffffffffffffffffUL

/// A cell of the grid relative to another one.
struct Offset
{
    int x, y;
    int squared_gap; ///< between the two, in cells
};

/// A set and its grid of cells, each of which has room for one point. Lengths are in units of 2^-32, areas in squares
/// of them.
struct Torus
{
    ulong squared_min_distance;
    double squared_cell; ///< area of a cell
    uint grid_size;      ///< cells along each axis
    uint offsets;        ///< in the list, by their gaps
    uint near_offsets;   ///< the first of them: cells with points nearer than the minimum distance
    uint unused;
};

/// The arguments of throw_darts.
struct Batch
{
    ulong free_area; ///< of all sites; 0: darts fall anywhere
    uint sites;      ///< that have some
    uint darts;
    uint number;       ///< of the batch
    uint key_x, key_y; ///< of random numbers
    uint unused;
};

END_CONTRACT
