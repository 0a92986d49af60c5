// The contract of varied_darts.cl, its host code, host/sampling/varied/varied_darts.cpp, and its twin.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(varied_darts)

enum
{
    QUOTIENT_BITS = 18, ///< see quotient_of()
    SCALE_BITS = 31,    ///< a scale of 1
    SPARE = 16          ///< positions by which rounded distances may break the slope, and more
};

enum Counter
{
    SETTLED, ///< slots of the batch that have a point
    REDRAWN, ///< slots whose first dart met another one of the batch
    COUNTERS
};

/// A point's coordinates, its distance, and then the number of the next point in its bucket, and one; 0: none.
enum
{
    DISTANCE_WORD = 2,
    NEXT_WORD = 3,
    POINT_WORDS = 4
};

/// A square of 2^bits positions along each side that may have room.
struct OpenCell
{
    uint x, y; ///< its lowest corner, a multiple of its side
    uint bits;
    uint least; ///< a lower bound of the distances in it; 0: there is no room
};

/// The rule by which distances are read and kept.
struct DistanceRule
{
    uint columns; ///< cells of the field; 0: it has squares
    uint rows;
    uint is_mean; ///< the mean of both distances is kept, else the smaller one
    uint scale;   ///< of all distances, in units of 2^-SCALE_BITS

    /// Points that are too near to a place have at least `below` and at most `above` 2^-16 times its distance, but for
    /// SPARE positions.
    uint below;
    uint above;
    uint least, most; ///< of all distances
    uint buckets;     ///< of points: a power of two, less 1
    uint shift;       ///< nodes of the field are 2^shift positions apart
};

/// The arguments of find_varied_darts and settle_varied_darts. Slots are the places of points in the order in which
/// they come.
struct VariedBatch
{
    ulong skipped; ///< darts of the first slot that failed before
    uint cells;
    uint fineness; ///< see quotient_of()
    uint first;    ///< slot: so many points are there
    uint slots;
    uint tries;        ///< darts of a slot, before the batch ends
    uint key_x, key_y; ///< of random numbers
    uint unused;
};

END_CONTRACT
