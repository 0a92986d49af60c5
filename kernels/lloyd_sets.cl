// Lloyd relaxation of sets of few points in 2D, side by side on a processor: a work-item makes iterations of a set one
// after the other. Launching a kernel for each of their steps would take longer than that.
//
// These are the steps of point_grid.cl, voronoi_2d.cl and relaxation.cl, and their bits. Needs DOUBLES, see reals.clh.

#pragma OPENCL FP_CONTRACT OFF

#define DIMENSION 2
#define LISTED 0

#include "kernels/common/lloyd_sets.h"
#include "kernels/common/reals.clh"
#include "kernels/common/relaxation.clh"
#include "kernels/common/sort_points.clh"
#include "kernels/common/voronoi/voronoi_2d_search.clh"

/// Sums up in the order of PointSummary.
Summary summary_of_set(global const real* energies, global const real* squared_near, uint points)
{
    Summary all = {REAL_ZERO, REAL_INFINITE};
    for (uint begin = 0; begin < points; begin += SUMMARY_RUN) {
        const Summary some = summary_of(energies, squared_near, begin, min(begin + SUMMARY_RUN, points));
        all.energy = plus(all.energy, some.energy);
        all.smallest = lesser(all.smallest, some.smallest);
    }
    return all;
}

/// One work-item owns a set, and its part of each buffer. Measures its iterates so many times, moves its points so many
/// times, after a measure each, and leaves them in `positions` and `ids`, not sorted. `counts` is clear before.
kernel void relax_sets(struct Sets sets, struct GridPart part, float width, global real* positions, global uint* ids,
                       global real* sorted, global uint* sorted_ids, global uint* counts, global uint* cells,
                       global uint* starts, global uint* order, global uint* fixed_point, global real* areas,
                       global real* displacements, global real* energies, global real* squared_near,
                       global uint* slow, global real* energy_sums, global real* smallest)
{
    const uint set = get_global_id(0);
    if (set >= sets.count) return;
    const uint n = sets.points, stride = n + PADDING;
    positions += 2 * n * set, sorted += 2 * n * set, displacements += 2 * n * set;
    ids += n * set, sorted_ids += n * set, cells += n * set, order += n * set;
    areas += n * set, energies += n * set, squared_near += n * set;
    slow += (n + 1) * set; // the last one counts them
    counts += part.held * set, starts += (part.held + 1) * set, fixed_point += 2 * stride * set;

    Search search;
    const Grid grid = {(global const Pair*)sorted, (global const int*)fixed_point, stride, starts, part, width};
    const Results results = {areas, (global Pair*)displacements, energies, squared_near};
    search.grid = grid;
    search.results = results;
    search.slow = slow;
    search.slow_count = slow + n;
    for (uint i = 0; i < sets.measures; ++i) {
        sort_all(positions, ids, n, &part, counts, cells, starts, order, sorted, sorted_ids, fixed_point, stride);
        *search.slow_count = 0;
        search.large_cell = UINT_MAX;
        find_cells(&search, 0, part.cells);
        for (uint k = 0; k < *search.slow_count; ++k) finish_slow(&grid, sorted_ids, slow[k], results);
        const Summary summary = summary_of_set(energies, squared_near, n);
        energy_sums[sets.measures * set + i] = summary.energy;
        smallest[sets.measures * set + i] = summary.smallest;
        if (i >= sets.moves) break;
        for (uint k = 0; k < 2 * n; ++k) positions[k] = moved_coordinate(sorted[k], displacements[k]);
        for (uint k = 0; k < n; ++k) ids[k] = sorted_ids[k];
    }
}
