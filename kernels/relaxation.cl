// The kernels that relaxation methods share: moving points in their domain, and summing up over points.
//
// Needs DIMENSION (2 or 3).

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/domain.clh"

/// One work-item owns one point and moves it by what the domain allows of its displacement. `is_fixed` is by id.
kernel void move_points(global double* positions, global const uint* ids, global const double* displacements,
                        uint point_count, global const uchar* is_fixed, uint has_fixed, global const double* regions,
                        uint region_count, global const double* half_spaces, uint slides)
{
    const uint id = get_global_id(0);
    if (id >= point_count) return;
    if (has_fixed && is_fixed[ids[id]]) return;
    Vector position;
    Vector movement;
    for (int k = 0; k < DIMENSION; ++k) {
        position.c[k] = positions[id * DIMENSION + k];
        movement.c[k] = displacements[id * DIMENSION + k];
    }
    if (region_count > 0) {
        movement = allowed_displacement(&position, movement, regions, region_count, half_spaces, slides);
    }
    for (int k = 0; k < DIMENSION; ++k) {
        const double moved = position.c[k] + movement.c[k];
        const double wrapped = moved - floor(moved);
        positions[id * DIMENSION + k] = wrapped < 1 ? wrapped : 0; // just below 0, the sum rounds to 1
    }
}

/// One work-item owns `run` points in a row: the sum of their energies, and their smallest squared distance. Results are
/// those from number `first` on.
kernel void summarize_points(global const double* energies, global const double* squared_near, uint point_count,
                             uint run, uint first, global double* energy_sums, global double* smallest)
{
    const uint begin = get_global_id(0) * run;
    if (begin >= point_count) return;
    const uint end = min(begin + run, point_count);
    double sum = 0;
    double minimum = INFINITY;
    for (uint i = begin; i < end; ++i) {
        sum += energies[i];
        minimum = fmin(minimum, squared_near[i]);
    }
    energy_sums[first + get_global_id(0)] = sum;
    smallest[first + get_global_id(0)] = minimum;
}
