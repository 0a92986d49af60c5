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

#include "kernels/common/grid_part.clh"
#include "kernels/common/listed_cells.clh"
#include "kernels/common/reals.clh"

#define FOR_EACH_AXIS(k) _Pragma("unroll") for (int k = 0; k < DIMENSION; ++k)

#if LISTED
#define LISTED_CELLS , global const uint *row_starts, global const uint *columns
#define THE_LISTED_CELLS , row_starts, columns
#else
#define LISTED_CELLS
#define THE_LISTED_CELLS
#endif

/// The place of the cell that a point is in.
uint cell_of_point(global const real* positions, uint id, const struct GridPart* part LISTED_CELLS)
{
    uint row = 0, column = 0;
    for (int k = DIMENSION - 1; k >= 0; --k) {
        const uint c = uint_of(times(positions[id * DIMENSION + k], real_of_uint(part->grid_size)));
        row = row * part->grid_size + column;
        column = min(c, part->grid_size - 1); // just below 1, the product rounds up
    }
#if LISTED
    return number_of_listed(row_starts, columns, row, column);
#else
    return place_of_cell(part, row * part->grid_size + column);
#endif
}

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

/// Turns the numbers of points in `count` cells into starts, from 0 on, and clears them. Returns their sum.
uint scan_cells(uint count, global uint* counts, global uint* starts)
{
    uint sum = 0;
    for (uint cell = 0; cell < count; ++cell) {
        const uint points = counts[cell];
        counts[cell] = 0;
        starts[cell] = sum;
        sum += points;
    }
    return sum;
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

/// Sorts the points of a cell by their ids and writes them in that order: position, id, and the position in fixed point
/// (units of 2^-32, rounded down), an array of `stride` words for each axis.
void gather_cell(uint begin, uint end, global const real* positions, global const uint* ids, global uint* order,
                 global real* sorted_positions, global uint* sorted_ids, global uint* fixed_point, uint stride)
{
    // Shell sort: cells hold a few points, unless all points crowd in one.
    uint gap = 1;
    while (gap < (end - begin) / 3) gap = 3 * gap + 1;
    for (; gap > 0; gap /= 3) {
        for (uint i = begin + gap; i < end; ++i) {
            const uint source = order[i];
            const uint id = ids[source];
            uint j = i;
            for (; j >= begin + gap && ids[order[j - gap]] > id; j -= gap) order[j] = order[j - gap];
            order[j] = source;
        }
    }
    for (uint i = begin; i < end; ++i) {
        const uint source = order[i];
        sorted_ids[i] = ids[source];
        FOR_EACH_AXIS(k) {
            const real position = positions[source * DIMENSION + k];
            sorted_positions[i * DIMENSION + k] = position;
            fixed_point[k * stride + i] = uint_of(times(position, REAL_OF(4294967296.0, 0x41f0000000000000ul)));
        }
    }
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
    for (uint id = 0; id < point_count; ++id) {
        cells[id] = cell_of_point(positions, id, &part THE_LISTED_CELLS);
        ++counts[cells[id]];
    }
    starts[part.held] = scan_cells(part.held, counts, starts);
    for (uint id = 0; id < point_count; ++id) order[starts[cells[id]] + counts[cells[id]]++] = id;
    for (uint cell = 0; cell < part.held; ++cell) {
        counts[cell] = 0;
        gather_cell(starts[cell], starts[cell + 1], positions, ids, order, sorted_positions, sorted_ids, fixed_point,
                    stride);
    }
}
