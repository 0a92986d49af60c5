// The contract of inside_space.clh and host code that runs kernels with it.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(spaces)

enum
{
    LATTICE_SHIFT = 24 ///< cells of a solid's lattice are 2^LATTICE_SHIFT positions wide
};

enum Shape
{
    SPACE_BOX,
    SPACE_BALL,
    SPACE_SOLID
};

/// A FixedSpace.
struct SpaceGrid
{
    ulong squared_radius; ///< of a ball, in halves of positions
    uint low[3], high[3]; ///< nothing is inside beyond these positions; nothing at all where low is above high
    uint cells[3];        ///< of a solid's lattice
    uint shape;
};

END_CONTRACT
