// The centroids of the Voronoi cells of points on the torus, exactly, each cell for itself ("meshless
// Voronoi").
//
// After Ray, Sokolov, Lefebvre, Levy: Meshless Voronoi on the GPU, ACM Transactions on Graphics 37(6), 2018:
// each cell is cut by the bisectors of points in nearby grid cells, until no point farther away can matter
// (security radius). Unlike there, the cell is not clipped plane by plane but walked around ("gift
// wrapping"): from one edge to the next, a step looks at all points, several at once, as vectors.
//   find_centroids_fast   cells whose Voronoi neighbours all lie in the surrounding 3 x 3 or 5 x 5 grid
//                         cells, several at once. Neighbours are found in single precision; the result is
//                         taken only if every vertex is seen, by more than any rounding error, to be nearer
//                         to its own three points than to any other. The geometry of the cell is computed
//                         from its neighbours in double precision. All other sites are listed.
//   find_centroids        the sites of that list, in double precision, without limit to the number of points
//   or edges.
// On devices without double precision (DOUBLES 0, see reals.clh), cells are found one by one, without batches. A cell has
// the same bits whichever way it is found, see voronoi_2d_around.clh.
// Points that coincide share their cell as if shifted apart along x by an infinitesimal distance, in order of
// their ids: the first gets the left part of the cell, the last the right part, those between them nothing.
//
// Points are sorted by grid cells, see point_grid.cl. Results are in that order.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/reals.clh"
#include "kernels/common/voronoi/voronoi_2d_search.clh"

/// One work-item owns `run` grid cells in a row, of those that are asked about, and the Voronoi cells of their points.
/// `displacements` lead from sites to centroids. `width`: that of a grid cell in units of 2^-32, rounded down. Sites
/// that need the slow way are appended to `slow` (in any order); slow_count is 0 before.
kernel void find_centroids_fast(global const Pair* positions, global const int* fixed_point, uint stride,
                                global const uint* starts, struct GridPart part, float width, uint run,
                                global real* areas, global Pair* displacements, global real* energies,
                                global real* squared_near, global uint* slow, global uint* slow_count)
{
    const uint begin = part.own_first + (uint)get_global_id(0) * run;
    const uint end = min(begin + run, part.own_end);
    const Grid grid = {positions, fixed_point, stride, starts, part, width};
    const Results results = {areas, displacements, energies, squared_near};
    Search search;
    search.grid = grid;
    search.results = results;
    search.slow = slow;
    search.slow_count = slow_count;
    search.large_cell = UINT_MAX;
    find_cells(&search, begin, end);
}

#define SLOW_SECTIONS 16 // of the work-items; threads take those in a row

/// The work-items share the sites of the list: the first of each section begin, so that threads share few sites as well.
/// `unknown` is set where points that are not held may matter.
kernel void find_centroids(global const Pair* positions, global const uint* ids, global const uint* starts,
                           struct GridPart part, global const uint* slow, global const uint* slow_count,
                           global real* areas, global Pair* displacements, global real* energies,
                           global real* squared_near, global uint* unknown)
{
    const uint count = *slow_count;
    const uint sections = get_global_size(0) % SLOW_SECTIONS == 0 ? SLOW_SECTIONS : 1;
    const uint run = get_global_size(0) / sections;
    const Grid grid = {positions, 0, 0, starts, part, 0};
    const Results results = {areas, displacements, energies, squared_near};
    for (uint i = get_global_id(0) % run * sections + get_global_id(0) / run; i < count; i += get_global_size(0)) {
        if (!finish_slow(&grid, ids, slow[i], results)) atomic_or(unknown, 1u);
    }
}

/// A single work-item.
kernel void forget_slow(global uint* slow_count, global uint* unknown)
{
    if (get_global_id(0) == 0) *slow_count = *unknown = 0;
}
