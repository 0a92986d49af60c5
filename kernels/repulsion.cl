// Repulsion: what points that are too close push each other by. See host/sampling/repulsion.hpp; points are moved by
// move_points of relaxation.cl.
//
// Points are sorted by grid cells, see point_grid.cl. Needs DIMENSION (2 or 3) and DOUBLES (0 or 1), see reals.clh.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/reals.clh"

/// Floor of i / n, for repeated grids.
int repetition_of(int i, int n) { return i >= 0 ? i / n : -((n - 1 - i) / n); }

/// One work-item owns one point: its displacement, and the squared distance of the nearest point or image of a point
/// that lies in the cells around. `is_fixed` is by id.
kernel void push_points(global const real* positions, global const uint* ids, uint point_count,
                        global const uint* starts, uint grid_size, int reach, real distance, real limit,
                        global const uchar* is_fixed, uint has_fixed, global real* displacements,
                        global real* squared_near)
{
    const uint item = get_global_id(0);
    if (item >= point_count) return;
    const uint id = ids[item];
    const int n = (int)grid_size;
    real position[DIMENSION];
    real sum[DIMENSION];
    int cell[DIMENSION];
    for (int k = 0; k < DIMENSION; ++k) {
        position[k] = positions[item * DIMENSION + k];
        sum[k] = REAL_ZERO;
        cell[k] = (int)min(uint_of(times(position[k], real_of_uint(grid_size))), grid_size - 1);
    }
    real near = REAL_ONE; // the point's own images
    // Beyond this no root is needed.
    const real far = times(times(distance, distance), REAL_OF(1 + 0x1p-40, 0x3ff0000000001000ul));

    // The cells around, row by row; on small grids several times, as the images that they are there.
    const int reach_z = DIMENSION == 3 ? reach : 0;
    for (int z = -reach_z; z <= reach_z; ++z) {
        for (int y = -reach; y <= reach; ++y) {
            real repetition[DIMENSION];
            uint row = 0;
            for (int k = DIMENSION - 1; k > 0; --k) {
                const int moved = cell[k] + (k == 1 ? y : z);
                const int repeated = moved >= 0 && moved < n ? 0 : repetition_of(moved, n);
                repetition[k] = real_of_int(repeated);
                row = row * grid_size + (uint)(moved - repeated * n);
            }
            row *= grid_size;

            // Cells of a row lie one after the other, up to the border of the torus.
            for (int x = cell[0] - reach; x <= cell[0] + reach;) {
                const int repeated = x >= 0 && x < n ? 0 : repetition_of(x, n);
                const int first = x - repeated * n;
                const int end = min(first + cell[0] + reach + 1 - x, n);
                repetition[0] = real_of_int(repeated);
                const uint others_end = starts[row + end];
                for (uint other = starts[row + first]; other < others_end; ++other) {
                    if (other == item) continue;
                    real difference[DIMENSION];
                    real squared = REAL_ZERO;
                    for (int k = 0; k < DIMENSION; ++k) {
                        const real moved = minus(positions[other * DIMENSION + k], position[k]);
                        difference[k] = plus(moved, repetition[k]);
                        squared = plus(squared, times(difference[k], difference[k]));
                    }
                    near = lesser(near, squared);
                    if (is_less(far, squared)) continue;
                    const real length = root_of(squared);
                    if (!is_less(length, distance)) continue;
                    const uint other_id = ids[other];
                    const bool is_held = has_fixed && is_fixed[other_id];
                    const real gap = minus(distance, length);
                    const real push = is_held ? gap : halved(gap);
                    if (is_equal(length, REAL_ZERO)) {
                        sum[0] = plus(sum[0], id < other_id ? negated(push) : push);
                    } else {
                        for (int k = 0; k < DIMENSION; ++k)
                            sum[k] = minus(sum[k], times(over(difference[k], length), push));
                    }
                }
                x += end - first;
            }
        }
    }
    squared_near[item] = near;

    real squared = REAL_ZERO;
    for (int k = 0; k < DIMENSION; ++k) squared = plus(squared, times(sum[k], sum[k]));
    const real length = root_of(squared);
    const real scale = has_fixed && is_fixed[id] ? REAL_ZERO : is_less(limit, length) ? over(limit, length) : REAL_ONE;
    for (int k = 0; k < DIMENSION; ++k) displacements[item * DIMENSION + k] = times(scale, sum[k]);
}

/// One work-item owns one point: keeps its position, by id.
kernel void keep_points(global const real* positions, global const uint* ids, uint point_count, global real* kept)
{
    const uint item = get_global_id(0);
    if (item >= point_count) return;
    for (int k = 0; k < DIMENSION; ++k) kept[ids[item] * DIMENSION + k] = positions[item * DIMENSION + k];
}
