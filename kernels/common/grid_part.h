// The contract of grid_part.clh, of the kernels that sort points by grid cells and look for neighbours there, and of
// their host code, host/sampling/cells/point_grid.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(grid_part)

/// The cells of a grid on the torus whose points are at hand: those of layers side by side along the last axis, perhaps
/// all. A cell's number is x + grid_size * (y + grid_size * z).
struct GridPart
{
    uint grid_size; ///< cells along each axis of the torus
    uint cells;     ///< of the torus
    uint first;     ///< cell that is held; after the last cell of the torus, the first one follows
    uint held;      ///< cells
    uint own_first; ///< of the cells whose points are asked about: others are held for what is around them
    uint own_end;
};

END_CONTRACT
