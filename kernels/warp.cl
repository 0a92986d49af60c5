// Points through the inverse cumulative distribution of a density: rows by y, columns of the row by x.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 7.2 and 7.3. All sums are exact integers. Floating-point
// numbers only guess a quotient, which integers then correct: results are those of the plain twin,
// host/sampling/warp/reference/warp.cpp, bit for bit.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/fields/warp.h"

/// total * u / 2^32, rounded down; total < 2^63.
ulong part_of(ulong total, uint u)
{
    return (total >> 32) * u + ((total & 0xffffffffUL) * u >> 32);
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

/// Goes through the points of a work-item.
#define EACH_POINT for (uint k = 0; k < POINTS_AN_ITEM; ++k)

/// The places of points in rows of n cells: pixels times 2^32. The row of point k has its sums and its guide from
/// first[k] on; u[k] says where in the row the point is. The cell is the last one whose sum of those before it is at
/// most t = part_of(total, u): never an empty one; the guide has that of the least t of each n-th of all u, between two
/// of which it is searched for. All searches take a step in turn: none waits for memory alone, and no branch depends
/// on a single one.
void find_places(global const ulong* sums, global const uint* guide, const size_t* first, uint n, const uint* u,
                 ulong* places)
{
    ulong t[POINTS_AN_ITEM];
    uint low[POINTS_AN_ITEM], high[POINTS_AN_ITEM];
    EACH_POINT
    {
        const size_t part = first[k] + (uint)((ulong)u[k] * n >> 32);
        t[k] = part_of(sums[first[k] + n], u[k]);
        low[k] = guide[part];
        high[k] = guide[part + 1];
    }
    for (uint open = 1; open != 0;) {
        open = 0;
        EACH_POINT
        {
            const uint middle = (low[k] + high[k] + 1) / 2; // low, where the search is over
            const bool is_above = sums[first[k] + middle] > t[k];
            low[k] = is_above ? low[k] : middle;
            high[k] = is_above ? middle - 1 : high[k];
            open |= high[k] - low[k];
        }
    }
    EACH_POINT
    {
        const size_t cell = first[k] + low[k];
        places[k] = ((ulong)low[k] << 32) | quotient(t[k] - sums[cell], sums[cell + 1] - sums[cell]);
    }
}

/// A work-item warps POINTS_AN_ITEM points, each as far after the one before it as there are work-items, and the last
/// point again where there are no more.
kernel void warp_points(struct Warping warping, global const ulong* row_sums, global const uint* row_guide,
                        global const ulong* sums, global const uint* guide, global const uint2* points,
                        global ulong2* places)
{
    const uint id = get_global_id(0);
    const uint items = (warping.points + POINTS_AN_ITEM - 1) / POINTS_AN_ITEM;
    if (id >= items) return;
    uint u[POINTS_AN_ITEM], v[POINTS_AN_ITEM];
    size_t first[POINTS_AN_ITEM];
    ulong x[POINTS_AN_ITEM], y[POINTS_AN_ITEM];
    EACH_POINT
    {
        const uint2 point = points[min(id + k * items, warping.points - 1)];
        u[k] = point.x;
        v[k] = point.y;
        first[k] = 0;
    }
    find_places(row_sums, row_guide, first, warping.height, v, y);
    EACH_POINT first[k] = (y[k] >> 32) * ((size_t)warping.width + 1);
    find_places(sums, guide, first, warping.width, u, x);
    EACH_POINT
    if (id + k * items < warping.points) places[id + k * items] = (ulong2)(x[k], y[k]);
}
