// The centroids of the Voronoi cells of points on the 3-torus, exactly, one cell after the other ("meshless Voronoi"):
// the fast way.
//
// After Ray, Sokolov, Lefebvre, Levy: Meshless Voronoi on the GPU, ACM Transactions on Graphics 37(6), 2018: each cell
// is made from the points in nearby grid cells, until no point farther away can matter (security radius). Unlike there,
// the cell is not clipped plane by plane but walked along ("gift wrapping"): from a vertex along an edge to the next, a
// step looks at all points at once, as vectors.
//
// This finds cells whose Voronoi neighbours all lie in the surrounding 5^3 or 7^3 grid cells. Neighbours are found in
// single precision; vertices are computed from them in double precision. The result is taken only if the walk closes
// and every vertex is seen, by more than any rounding error, to be nearer to its own four points than to any other. All
// other sites are listed, for voronoi_3d_slow.cl.
//
// Points are sorted by grid cells, see point_grid.cl. Results are in that order.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/grid_part.clh"
#include "kernels/common/voronoi/voronoi_3d_window.clh"

/// Appends a row's points. Copies whole vectors; what is too much is overwritten by the next row.
ALWAYS_INLINE void append_row(Window* window, global const int* fixed_point, uint stride, uint begin, uint end)
{
    const uint count = end - begin;
    if (window->count + count > MAX_POINTS) {
        window->count = MAX_POINTS + 1;
        return;
    }
    for (uint i = 0; i < count; i += LANES) {
        const uint at = window->count + i;
        vstore8(vload8(0, fixed_point + begin + i), 0, window->x + at);
        vstore8(vload8(0, fixed_point + stride + begin + i), 0, window->y + at);
        vstore8(vload8(0, fixed_point + 2 * stride + begin + i), 0, window->z + at);
        vstore8((uint8)(0, 1, 2, 3, 4, 5, 6, 7) + (begin + i), 0, window->index + at);
    }
    window->count += count;
}

/// `at` + `offset` on a ring of `size` cells; size >= offset.
ALWAYS_INLINE uint wrapped(uint at, int offset, uint size)
{
    const int sum = (int)at + offset;
    return (uint)(sum < 0 ? sum + (int)size : sum >= (int)size ? sum - (int)size : sum);
}

/// All points in the (2 reach + 1)^3 cells around a cell; count > MAX_POINTS where there are too many.
ALWAYS_INLINE void gather_window(Window* window, uint cell_x, uint cell_y, uint cell_z, int reach,
                                 const struct GridPart* part, global const uint* starts,
                                 global const int* fixed_point, uint stride)
{
    const uint grid_size = part->grid_size;
    window->count = 0;
    const uint low = wrapped(cell_x, -reach, grid_size);
    const uint high = low + 2 * (uint)reach + 1;
    for (int k = -reach; k <= reach; ++k) {
        const uint plane = wrapped(cell_z, k, grid_size) * grid_size * grid_size;
        global const uint* plane_starts = starts + place_of_cell(part, plane);
        for (int j = -reach; j <= reach; ++j) {
            if (window->count > MAX_POINTS) return;
            global const uint* row = plane_starts + wrapped(cell_y, j, grid_size) * grid_size;
            append_row(window, fixed_point, stride, row[low], row[min(high, grid_size)]);
            if (high > grid_size && window->count <= MAX_POINTS) {
                append_row(window, fixed_point, stride, row[0], row[high - grid_size]);
            }
        }
    }
}

/// One work-item owns one grid cell, of those that are asked about, and the Voronoi cells of its points. Points of three
/// layers of cells around these are there. `displacements` lead from sites to centroids.
/// `margin`: the width of a grid cell in units of 2^-32, rounded down. Sites that need the slow way are appended to
/// `slow` (in any order); slow_count is 0 before.
kernel void find_centroids_fast(global const double* positions, global const int* fixed_point, uint stride,
                                global const uint* starts, struct GridPart part, float margin, global double* volumes,
                                global double* displacements, global double* energies, global double* squared_near,
                                global uint* slow, global uint* slow_count)
{
    const uint id = part.own_first + (uint)get_global_id(0);
    if (id >= part.own_end) return;
    const uint place = place_of_cell(&part, id);
    const uint begin = starts[place];
    const uint end = starts[place + 1];
    if (begin == end) return;
    const uint grid_size = part.grid_size;
    const uint cell_x = id % grid_size;
    const uint cell_y = id / grid_size % grid_size;
    const uint cell_z = id / grid_size / grid_size;
    const double width = (double)margin * (0x1p-32 * (1 - 0x1p-20));
    const double3 cell = (double3)(cell_x, cell_y, cell_z);

    Window window;
    uint left = 0; // sites that need the larger window
    for (int reach = 2; reach <= 3; ++reach) {
        const bool is_first = reach == 2;
        if (!is_first && left == 0) return;
        bool has_window = 2 * (uint)reach + 2 <= grid_size;
        if (has_window) {
            gather_window(&window, cell_x, cell_y, cell_z, reach, &part, starts, fixed_point, stride);
            has_window = window.count <= MAX_POINTS;
        }
        for (uint site = begin; site < end; ++site) {
            // Sites that are left are marked by a negative volume.
            if (!is_first && volumes[site] >= 0) continue;
            VoronoiCell result;
            int failure = 2;
            if (has_window) {
                const double3 position = vload3(site, positions);
                const double3 at = position * grid_size - cell; // in the cell, in its widths
                const double3 below = (at + reach) * width;
                const double3 above = (reach + 1 - at) * width;
                failure = cell_in_window(&window, fixed_point[site], fixed_point[stride + site],
                                         fixed_point[2 * stride + site], position, below, above, 1.8 * width,
                                         positions, &result);
            }
            if (failure == 0) {
                store_cell(&result, site, volumes, displacements, energies, squared_near);
            } else if (failure == 1 && is_first) {
                volumes[site] = -1;
                ++left;
            } else {
                volumes[site] = 0;
                slow[atomic_inc(slow_count)] = site;
            }
        }
    }
}
