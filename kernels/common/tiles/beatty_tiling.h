// The contract of beatty_tiling.cl and its host code, host/aperiodic_tiling/beatty_generator.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(beatty_tiling)

/// Tiles that a work-item makes, one after the other.
DERIVED(RUN_TILES, (), 256)

/// The number that stands where the set has no tile.
DERIVED(NO_TILE, (), 255)

/// alpha and beta of the digits on the north of a row, modulo 2^32 in units of 2^-96, and which machine it has.
struct Row
{
    ulong slope_high, slope_low;
    ulong offset_high, offset_low;
    ulong machine;
};

/// A machine's multiplication: a carry's number is factor floor(x) - divisor floor(q x) + shift.
struct Machine
{
    uint factor, divisor, shift;
};

/// The part of a window that is made at once: `rows` rows from the first of the buffer on, of `width` tiles each.
struct Part
{
    ulong x; ///< of the first column, modulo 2^64
    uint width;
    uint rows;
    struct Machine first, second;
};

END_CONTRACT
