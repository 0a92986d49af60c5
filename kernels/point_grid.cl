// Sorts points by the cells of a regular grid on the torus, so that neighbours are found in adjacent cells.
//
// A counting sort in four steps; host/sampling/cells/point_grid.cpp runs them:
//   count_points   the number of points in each cell, and each point's place among them
//   scan_counts    numbers to starts, chunk by chunk; scan_totals and add_totals join the chunks
//   place_points   the points' order by cells
//   gather_points  the points of each cell in order of their ids, which makes the result independent of the schedule
// sort_few does all of that in one work-item where there are few points: launches would take longer.
//
// Needs DIMENSION (2 or 3), DOUBLES (0 or 1), see reals.clh, and LISTED (0 or 1): whether only some cells are there, as
// listed_cells.clh has them. Rows of a plane come after those of the plane below.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/sort_points.clh"

/// One work-item owns one point. `counts` is clear before; all points are in cells that are held.
kernel void count_points(global const real* positions, uint point_count, struct GridPart part, global uint* counts,
                         global uint* cells, global uint* places LISTED_CELLS)
{
    const uint id = get_global_id(0);
    if (id >= point_count) return;
    const uint cell = cell_of_point(positions, id, &part THE_LISTED_CELLS);
    cells[id] = cell;
    places[id] = atomic_inc(&counts[cell]);
}

/// One work-item owns `chunk` cells: turns their numbers into starts relative to the chunk's, clears the numbers, and
/// writes the chunk's total. The last start is that of a cell after all others.
kernel void scan_counts(global uint* counts, uint cell_count, uint chunk, global uint* starts, global uint* totals)
{
    const uint begin = get_global_id(0) * chunk;
    if (begin >= cell_count) return;
    const uint end = min(begin + chunk, cell_count);
    const uint sum = scan_cells(end - begin, counts + begin, starts + begin);
    totals[get_global_id(0)] = sum;
    if (end == cell_count) starts[cell_count] = sum;
}

/// A single work-item: the chunks' totals to their starts.
kernel void scan_totals(global uint* totals, uint chunk_count)
{
    if (get_global_id(0) > 0) return;
    uint sum = 0;
    for (uint i = 0; i < chunk_count; ++i) {
        const uint total = totals[i];
        totals[i] = sum;
        sum += total;
    }
}

/// One work-item owns one start.
kernel void add_totals(global uint* starts, uint cell_count, uint chunk, global const uint* totals)
{
    const uint id = get_global_id(0);
    if (id <= cell_count) starts[id] += totals[min(id, cell_count - 1) / chunk];
}

/// One work-item owns one point.
kernel void place_points(global const uint* cells, global const uint* places, uint point_count,
                         global const uint* starts, global uint* order)
{
    const uint id = get_global_id(0);
    if (id < point_count) order[starts[cells[id]] + places[id]] = id;
}

/// One work-item owns one cell.
kernel void gather_points(global const real* positions, global const uint* ids, uint cell_count,
                          global const uint* starts, global uint* order, global real* sorted_positions,
                          global uint* sorted_ids, global uint* fixed_point, uint stride)
{
    const uint cell = get_global_id(0);
    if (cell < cell_count)
        gather_cell(starts[cell], starts[cell + 1], positions, ids, order, sorted_positions, sorted_ids, fixed_point,
                    stride);
}

/// The first work-item owns everything.
kernel void sort_few(global const real* positions, global const uint* ids, uint point_count, struct GridPart part,
                     global uint* counts, global uint* cells, global uint* starts, global uint* order,
                     global real* sorted_positions, global uint* sorted_ids, global uint* fixed_point, uint stride LISTED_CELLS)
{
    if (get_global_id(0) > 0) return;
    sort_all(positions, ids, point_count, &part, counts, cells, starts, order, sorted_positions, sorted_ids, fixed_point,
             stride THE_LISTED_CELLS);
}
