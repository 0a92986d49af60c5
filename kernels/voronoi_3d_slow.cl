// The centroids of the Voronoi cells on the 3-torus that the fast way, voronoi_3d_fast.cl, leaves.

#pragma OPENCL FP_CONTRACT OFF

#define SLOW_FACES 128
#define SLOW_CORNERS 40

#include "kernels/common/voronoi/voronoi_3d.clh"
#include "kernels/common/voronoi/grid_shells_3d.clh"
#include "kernels/common/voronoi/voronoi_3d_slow.clh"

/// The work-items share the sites of the list. `unknown` is set where points that are not held may matter.
kernel void find_centroids(global const double* positions, global const uint* ids, global const uint* starts,
                           struct GridPart part, global const uint* slow, global const uint* slow_count,
                           global double* volumes, global double* displacements, global double* energies,
                           global double* squared_near, global uint* unknown)
{
    const uint grid_size = part.grid_size;
    const uint count = *slow_count;
    for (uint i = get_global_id(0); i < count; i += get_global_size(0)) {
        const uint site = slow[i];
        const double3 position = vload3(site, positions);
        const int cell_x = min((int)(position.x * grid_size), (int)grid_size - 1);
        const int cell_y = min((int)(position.y * grid_size), (int)grid_size - 1);
        const int cell_z = min((int)(position.z * grid_size), (int)grid_size - 1);
        Surroundings s = {positions, ids,    starts, part, site, position, cell_x, cell_y, cell_z,
                          last_shell_of(&part, cell_z), false, false};
        const uint cell_number = place_of_cell(
            &part, (uint)cell_x + ((uint)cell_y + (uint)cell_z * grid_size) * grid_size);
        for (uint other = starts[cell_number]; other < starts[cell_number + 1]; ++other) {
            const double3 q = vload3(other, positions);
            if (q.x != position.x || q.y != position.y || q.z != position.z) continue;
            s.has_twin_before |= ids[other] < ids[site];
            s.has_twin_after |= ids[other] > ids[site];
        }
        bool is_known;
        const VoronoiCell cell = cell_by_shells(&s, &is_known);
        if (!is_known) atomic_or(unknown, 1u);
        store_cell(&cell, site, volumes, displacements, energies, squared_near);
    }
}

/// A single work-item.
kernel void forget_slow(global uint* slow_count, global uint* unknown)
{
    if (get_global_id(0) == 0) *slow_count = *unknown = 0;
}
