// The contract of power_cells.cl, its host code, host/sampling/optimized/power_cells.cpp, and its twin.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(power_cells)

enum
{
    MAX_NEIGHBORS = 20, ///< of a cell that are told; those of more are left out
    MAX_TURNS = 2,      ///< around the torus between a point and its neighbours
    INDEX_BITS = 27     ///< of a neighbour's number, below the turns of its image
};

END_CONTRACT
