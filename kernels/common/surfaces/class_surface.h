// The contract of class_surface_darts.cl, its host code, host/sampling/surfaces/class_surface_engine.cpp, and its twin.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(class_surface)

enum
{
    TRIES = 256,      ///< darts of a slot on a list of pieces, before the list is refined
    TRIES_BEFORE = 32 ///< so many darts fail before the following ones may fall farther from the slot's target
};

enum Counter
{
    SETTLED, ///< slots of the batch that have a point
    REDRAWN, ///< slots whose first dart met another one of the batch
    COUNTERS
};

/// Pieces that may have room for one class.
struct OpenPieces
{
    ulong total; ///< the sum of their weights
    uint first;  ///< the place of the first one among the pieces of all classes
    uint count;
    uint first_guide; ///< the place of the first entry of their guide
    uint guide_bits;  ///< 2^guide_bits entries
    uint spread;      ///< bits of targets that are random at first, see draw_dart(); 0: darts fall by weight alone
    uint unused;
};

/// The place of one point in the order in which points come.
struct SurfaceSlot
{
    uint own;    ///< its class
    uint target; ///< the part of the weights of the class's pieces, in units of 2^-32, near which its darts fall
};

/// The arguments of find_class_darts and settle_class_darts.
struct SurfaceSlots
{
    uint classes;
    uint first; ///< slot: so many points are there
    uint slots;
    uint skipped;      ///< darts of the first slot that failed at former lists of pieces
    uint key_x, key_y; ///< of random numbers
};

END_CONTRACT
