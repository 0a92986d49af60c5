// The contract of class_darts.cl, its host code, host/sampling/classes/class_darts.cpp, and its twin.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(class_darts)

enum
{
    TRIES = 256,      ///< darts of a slot at a list of cells, before the list is refined
    TRIES_BEFORE = 32 ///< so many darts fail before the following ones may fall farther from the slot's target
};

enum Counter
{
    SETTLED, ///< slots of the batch that have a point
    REDRAWN, ///< slots whose first dart met another one of the batch
    COUNTERS
};

/// A point's coordinates and class, and then the number of the next point in its cell, and one; 0: none.
DERIVED(CLASS_WORD, (size_t DIMENSION), DIMENSION)
DERIVED(NEXT_WORD, (size_t DIMENSION), DIMENSION + 1)
DERIVED(POINT_WORDS, (size_t DIMENSION), DIMENSION + 2)

/// The number of a slot's dart among its darts, or TRIES if there is none, and then the dart's coordinates.
DERIVED(CANDIDATE_WORDS, (size_t DIMENSION), DIMENSION + 1)

/// The distance that a class keeps from another. The pairs of a class begin with those whose points cover most of the
/// place, since these reject most darts.
struct ClassPair
{
    ulong squared; ///< in units of 2^-64
    ulong reach;   ///< the least length whose square is no less, in units of 2^-32
    uint other;    ///< the other class
    uint unused;
};

/// Cells of points of one class, 2^bits along each axis.
struct ClassGrid
{
    uint bits;
    uint first; ///< its place among the heads of all classes
};

/// Cells of the box that all points lie in, each with a bit for one class: does a single point's disk cover it? Bits
/// are in rows of whole words along the first axis.
struct CoveredCells
{
    uint level;    ///< 2^level along each axis of the torus; 0: there are none
    uint first;    ///< the place of its first word among those of all classes
    uint low[3];   ///< the lowest cell along each axis
    uint count[3]; ///< cells along each axis
};

/// Cells that may have room for one class, 2^level along each axis.
struct ClassCells
{
    uint level;
    uint first; ///< its place among the cells of all classes
    uint count;
    uint spread; ///< bits of targets that are random at first, see dart_of(); 0: darts fall uniformly
};

/// The place of one point in the order in which points come.
struct ClassSlot
{
    uint own;    ///< its class
    uint target; ///< the part of the class's density, in units of 2^-32, near which its darts fall
};

/// The arguments of find_darts and settle_class_darts. Slots are the places of points in the order in which they come.
struct SlotBatch
{
    uint classes;
    uint first; ///< slot: so many points are there
    uint slots;
    uint skipped;      ///< darts of the first slot that failed at former lists of cells
    uint key_x, key_y; ///< of random numbers
};

END_CONTRACT
