// The contract of masked_squares.cl and its host code, host/texture/masked_squares_kernel.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(masked_squares)

struct MaskedSquaresSizes
{
    int exemplar_width;          ///< pixels
    int width, height, channels; ///< of mask and piece
    int columns, rows;           ///< places of the window
};

END_CONTRACT
