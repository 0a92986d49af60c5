// The kernels that relaxation methods share: moving points in their domain, and summing up over points.
//
// Needs DIMENSION (2 or 3) and DOUBLES (0 or 1), see reals.clh. Regions of a domain need double precision.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/reals.clh"
#include "kernels/common/relaxation.clh"
#if DOUBLES
#include "kernels/common/domain.clh"
#else
typedef struct { real c[DIMENSION]; } Vector;
#endif

/// One work-item owns one point and moves it by what the domain allows of its displacement. `is_fixed` is by id.
kernel void move_points(global real* positions, global const uint* ids, global const real* displacements,
                        uint point_count, global const uchar* is_fixed, uint has_fixed, global const real* regions,
                        uint region_count, global const real* half_spaces, uint slides)
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
#if DOUBLES
    if (region_count > 0) {
        movement = allowed_displacement(&position, movement, regions, region_count, half_spaces, slides);
    }
#endif
    for (int k = 0; k < DIMENSION; ++k) {
        positions[id * DIMENSION + k] = moved_coordinate(position.c[k], movement.c[k]);
    }
}

/// One work-item owns `run` points in a row: the sum of their energies, and their smallest squared distance. Results are
/// those from number `first` on.
kernel void summarize_points(global const real* energies, global const real* squared_near, uint point_count,
                             uint run, uint first, global real* energy_sums, global real* smallest)
{
    const uint begin = get_global_id(0) * run;
    if (begin >= point_count) return;
    const uint end = min(begin + run, point_count);
    const Summary summary = summary_of(energies, squared_near, begin, end);
    energy_sums[first + get_global_id(0)] = summary.energy;
    smallest[first + get_global_id(0)] = summary.smallest;
}
