// class_tiles.cl shares these constants and records with its host code, host/tile_construction/classes/class_filler.cpp,
// and its twin.
#pragma once

#include "kernels/common/tiles/tile_filling.h"

CONTRACT(class_tiles)

enum
{
    PART_BITS = 16, ///< parts of the squared distances that classes keep are in units of 2^-16
    MOST_CLASSES = 32,
    MOST_PART = 4 << PART_BITS ///< larger parts count as this
};

/// The arguments of throw_class_tile_darts and push_class_tiles.
struct ClassFilling
{
#ifdef __cplusplus
    tile_filling::Tori tori;
#else
    struct Tori tori;
#endif
    uint attempt, stage, key_x, key_y; ///< of random numbers
    int low;                           ///< of the box that darts fall into, along each axis
    uint extent;                       ///< of the box
    uint classes;
    uint levels;   ///< parts of distances that darts keep, one after the other
    uint attempts; ///< failures in a row before the next
    uint passes;   ///< of pushing points apart, at most
};

END_CONTRACT
