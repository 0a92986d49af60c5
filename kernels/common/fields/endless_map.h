// The contract of endless_map.cl and its host code, host/texture/mapping/endless_map.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(endless_map)

enum
{
    EXEMPLAR_LEVELS = 24, ///< at most: of 8,388,608 texels in a row
    TILE_TEXELS = 64,     ///< of what counts as a tile of a texture that has none
    ENCODED_STEPS = 4,    ///< entries of the table of encoded numbers, for each 256th of the root of white
    ENCODED_ENTRIES = 256 * ENCODED_STEPS + 1
};

/// An exemplar at all levels: rows from north to south, levels one after the other, the last one of one texel.
struct ExemplarLevels
{
    int top; ///< the last one
    int widths[EXEMPLAR_LEVELS], heights[EXEMPLAR_LEVELS];
    uint offsets[EXEMPLAR_LEVELS]; ///< where levels begin
};

END_CONTRACT
