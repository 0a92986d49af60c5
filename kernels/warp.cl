// Points through the inverse cumulative distribution of a density: rows by y, columns of the row by x.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 7.2 and 7.3. All sums are exact integers. Floating-point
// numbers only guess a quotient, which integers then correct: results are those of the plain twin,
// host/distribution/reference/warp.cpp, bit for bit.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/warp.h"

/// total * u / 2^32, rounded down; total < 2^63.
ulong part_of(ulong total, uint u)
{
    return (total >> 32) * u + ((total & 0xffffffffUL) * u >> 32);
}

/// The last of n cells whose sum of those before it is at most t = part_of(sums[n], u): never an empty one. `guide` has
/// that of the least t of each n-th of all u.
uint cell_of(global const ulong* sums, global const uint* guide, uint n, uint u, ulong t)
{
    const uint part = (uint)((ulong)u * n >> 32);
    uint low = guide[part];
    uint high = guide[part + 1];
    while (low < high) {
        const uint middle = (low + high + 1) / 2;
        if (sums[middle] <= t)
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

/// rest * 2^32 / weight, rounded down; rest < weight <= 2^63. The guess is off by one at most.
uint quotient(ulong rest, ulong weight)
{
    const double guess = (double)rest / (double)weight * 4294967296.0;
    const ulong q = guess < 4294967295.0 ? (ulong)guess : 0xffffffffUL;
    const ulong left = (rest << 32) - q * weight; // modulo 2^64
    if (left > 0xc000000000000000UL) return (uint)q - 1;
    return left >= weight ? (uint)q + 1 : (uint)q;
}

/// The place in one row of cells: pixels times 2^32.
ulong place_in(global const ulong* sums, global const uint* guide, uint n, uint u, uint* cell)
{
    const ulong t = part_of(sums[n], u);
    *cell = cell_of(sums, guide, n, u, t);
    const ulong first = sums[*cell];
    return ((ulong)*cell << 32) | quotient(t - first, sums[*cell + 1] - first);
}

/// One work-item warps one point.
kernel void warp_points(struct Warping warping, global const ulong* row_sums, global const uint* row_guide,
                        global const ulong* sums, global const uint* guide, global const uint2* points,
                        global ulong2* places)
{
    const uint id = get_global_id(0);
    if (id >= warping.points) return;
    const uint2 point = points[id];
    uint row, column;
    const ulong y = place_in(row_sums, row_guide, warping.height, point.y, &row);
    const size_t first = (size_t)row * (warping.width + 1);
    const ulong x = place_in(sums + first, guide + first, warping.width, point.x, &column);
    places[id] = (ulong2)(x, y);
}
