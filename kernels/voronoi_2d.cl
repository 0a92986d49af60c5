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
#include "kernels/common/voronoi/voronoi_2d.clh"
#include "kernels/common/voronoi/voronoi_2d_window.clh"
#include "kernels/common/voronoi/voronoi_2d_around.clh"
#if DOUBLES
#include "kernels/common/voronoi/voronoi_2d_batch.clh"
#include "kernels/common/voronoi/voronoi_2d_batch_cells.clh"
#include "kernels/common/voronoi/voronoi_2d_wide.clh"
#endif
#include "kernels/common/voronoi/grid_rings_2d.clh"
#include "kernels/common/voronoi/voronoi_2d_slow.clh"

/// The results, a value a site.
typedef struct
{
    global real* areas;
    global Pair* displacements;
    global real* energies;
    global real* squared_near;
} Results;

ALWAYS_INLINE void store_cell(const VoronoiCell* cell, uint site, Results results)
{
    const bool is_there = is_positive(cell->area);
    const real x = is_there ? over(cell->moment.x, cell->area) : REAL_ZERO;
    const real y = is_there ? over(cell->moment.y, cell->area) : REAL_ZERO;
    results.areas[site] = cell->area;
    results.displacements[site] = (Pair)(x, y);
    results.energies[site] = cell->energy;
    results.squared_near[site] = cell->squared_near;
}

/// The work of one work-item: sites go from batch to batch until their cells are proven, or to the list of slow ones.
typedef struct
{
    Grid grid;
    Results results;
    global uint* slow;
    global uint* slow_count;
#if DOUBLES
    Batch near; // sites whose cells are looked for in 3 x 3 grid cells
    Window near_windows[BATCH_SITES];
    Batch wide; // sites whose cells in 3 x 3 grid cells are cut by points of the ring around
    Window wide_windows[BATCH_SITES];
    BatchPoints points; // of the batch that is being computed
#endif
    Window large; // 5 x 5 grid cells around large_cell, for one site at a time
    uint large_cell;
} Search;

ALWAYS_INLINE void list_slow(const Search* search, uint site) { search->slow[atomic_inc(search->slow_count)] = site; }

ALWAYS_INLINE void add_vertex(Pair exact, uint k, Vertices* vertices)
{
    const real units = REAL_OF(4294967296.0, 0x41f0000000000000ul);
    const float x = float_of(times(exact.x, units));
    const float y = float_of(times(exact.y, units));
    vertices->x[k] = x;
    vertices->y[k] = y;
    const float distance = sqrt(x * x + y * y) * (1 + 0x1p-20f);
    vertices->radius = larger_of(vertices->radius, distance);
    vertices->left = larger_of(vertices->left, distance - x);
    vertices->right = larger_of(vertices->right, distance + x);
    vertices->below = larger_of(vertices->below, distance - y);
    vertices->above = larger_of(vertices->above, distance + y);
}

/// Returns a difference, reduced to [-0.5, 0.5] by whole turns.
ALWAYS_INLINE real torus_difference(real a, real b)
{
    const real difference = minus(a, b);
    const real shift = REAL_OF(0x1.8p52, 0x4338000000000000ul); // adding it rounds
    return minus(difference, minus(plus(difference, shift), shift));
}

/// Finds one cell among the points of a window. False where it cannot be found or proven there; `is_closed` where it
/// was found, and no point outside of the window can cut it.
bool find_in_window(const Window* window, Margins margins, uint site, const Grid* grid, VoronoiCell* cell,
                    bool* is_closed)
{
    Differences d;
    Neighbours neighbours;
    const uint vectors =
        subtract_site(window, site, grid->fixed_point[site], grid->fixed_point[grid->stride + site], &d);
    *is_closed = false;
    if (!walk_around(&d, vectors, window->count, &neighbours)) return false;
    Around around;
    Pair corners[MAX_EDGES];
    around.count = neighbours.count;
    const Pair at = grid->positions[site];
    for (uint k = 0; k < neighbours.count; ++k) {
        const Pair other = grid->positions[window->index[neighbours.lane[neighbours.begin + k]]];
        around.at[k] = (Pair)(torus_difference(other.x, at.x), torus_difference(other.y, at.y));
    }
    if (!cell_around(&around, cell, corners)) return false;
    Vertices vertices = {.count = neighbours.count};
    for (uint k = 0; k < neighbours.count; ++k) add_vertex(corners[k], k, &vertices);
    *is_closed = is_complete(&vertices, margins);
    return *is_closed && is_certain(&d, vectors, &vertices);
}

/// Finds a cell alone: in a window of (2 reach + 1)^2 grid cells, then in 5 x 5, which are gathered once for all points
/// of a cell; or lists its site.
void finish_alone(Search* search, const Window* window, uint site, uint grid_cell, uint reach)
{
    const Grid* grid = &search->grid;
    for (; reach <= 2; ++reach) {
        if (reach == 2) {
            if (grid->part.grid_size < 6) break;
            if (search->large_cell != grid_cell) gather_window(&search->large, grid_cell, 2, grid);
            search->large_cell = grid_cell;
            window = &search->large;
        }
        if (window->count > MAX_POINTS) break;
        Margins margins;
        margins_around(site, grid_cell, reach, grid, &margins);
        VoronoiCell cell;
        bool is_closed;
        if (find_in_window(window, margins, site, grid, &cell, &is_closed)) {
            store_cell(&cell, site, search->results);
            return;
        }
        if (is_closed) break;
    }
    list_slow(search, site);
}

#if DOUBLES

ALWAYS_INLINE void store_of_batch(const BatchCells* cells, uint slot, uint site, Results results)
{
    results.areas[site] = ((const double*)&cells->area)[slot];
    results.displacements[site] = (double2)(((const double*)&cells->displacement_x)[slot],
                                            ((const double*)&cells->displacement_y)[slot]);
    results.energies[site] = ((const double*)&cells->energy)[slot];
    results.squared_near[site] = ((const double*)&cells->squared_near)[slot];
}

/// Computes the cells of the second batch. Few are uncertain, and get another look at all points.
void finish_wide(Search* search)
{
    const Batch* batch = &search->wide;
    BatchNeighbours neighbours;
    BatchCells cells;
    find_batch_cells(&search->wide, search->grid.positions, &search->points, &neighbours, &cells);
    for (uint slot = 0; slot < batch->count; ++slot) {
        if (cells.is_known[slot] && cells.is_complete[slot] && cells.is_certain[slot]) {
            store_of_batch(&cells, slot, batch->site[slot], search->results);
        } else {
            finish_alone(search, 0, batch->site[slot], batch->grid_cell[slot], 2);
        }
    }
    search->wide.count = 0;
}

/// A cell that is right among the points of 3 x 3 grid cells, but that others may cut: looks for them in 5 x 5.
void widen(Search* search, const BatchCells* cells, const BatchNeighbours* neighbours, uint slot)
{
    const Grid* grid = &search->grid;
    const Batch* near = &search->near;
    const uint site = near->site[slot];
    const uint grid_cell = near->grid_cell[slot];
    if (grid->part.grid_size < 6) {
        list_slow(search, site);
        return;
    }
    const uint edges = (uint)neighbours->count[slot];
    CellVertices vertices;
    copy_vertices(cells, slot, edges, &vertices);
    Margins near_margins;
    Margins margins;
    margins_around(site, grid_cell, 1, grid, &near_margins);
    margins_around(site, grid_cell, 2, grid, &margins);
    Window* window = &search->wide_windows[search->wide.count];
    window->count = 0;
    append_ring(window, grid, grid_cell, &near_margins, site, &vertices);
    if (window->count + edges > MAX_POINTS) {
        list_slow(search, site);
    } else if (window->count > 0) {
        for (uint k = 0; k < edges; ++k) {
            append_point(window, grid, neighbour_of(near, neighbours, slot, k));
        }
        add_to_batch(&search->wide, window, site, grid->fixed_point[site], grid->fixed_point[grid->stride + site],
                     grid_cell, &margins);
        if (search->wide.count == BATCH_SITES) finish_wide(search);
    } else if (vertices.left < margins.left && vertices.right < margins.right && vertices.below < margins.below &&
               vertices.above < margins.above) {
        store_of_batch(cells, slot, site, search->results);
    } else {
        list_slow(search, site);
    }
}

/// Computes the cells of the first batch. Most are complete in the window that they were found in.
void finish_near(Search* search)
{
    const Batch* batch = &search->near;
    BatchNeighbours neighbours;
    BatchCells cells;
    find_batch_cells(&search->near, search->grid.positions, &search->points, &neighbours, &cells);
    for (uint slot = 0; slot < batch->count; ++slot) {
        const bool is_right = cells.is_known[slot] && cells.is_certain[slot];
        if (is_right && cells.is_complete[slot]) {
            store_of_batch(&cells, slot, batch->site[slot], search->results);
        } else if (is_right) {
            widen(search, &cells, &neighbours, slot);
        } else {
            finish_alone(search, batch->window[slot], batch->site[slot], batch->grid_cell[slot], 1);
        }
    }
    search->near.count = 0;
}

/// Finds the cells of the points in grid cells from `begin` to `end` - 1.
ALWAYS_INLINE void find_cells(Search* search, uint begin, uint end)
{
    const Grid* grid = &search->grid;
    search->near.count = search->wide.count = 0;
    uint number = 0;
    for (uint cell = begin; cell < end; ++cell) {
        const uint place = place_of_cell(&grid->part, cell);
        const uint first = grid->starts[place];
        const uint last = grid->starts[place + 1];
        if (first == last) continue;
        // Sites wait for others, each with the window of its cell: it stays until BATCH_SITES cells later, when they
        // are done. Empty and crowded cells do not count.
        Window* window = &search->near_windows[number % BATCH_SITES];
        window->count = MAX_POINTS + 1;
        if (grid->part.grid_size >= 4) gather_window(window, cell, 1, grid);
        if (window->count > MAX_POINTS) {
            for (uint site = first; site < last; ++site) list_slow(search, site);
            continue;
        }
        ++number;
        for (uint site = first; site < last; ++site) {
            Margins margins;
            margins_around(site, cell, 1, grid, &margins);
            add_to_batch(&search->near, window, site, grid->fixed_point[site], grid->fixed_point[grid->stride + site],
                         cell, &margins);
            if (search->near.count == BATCH_SITES) finish_near(search);
        }
    }
    if (search->near.count > 0) finish_near(search);
    if (search->wide.count > 0) finish_wide(search);
}

#else

/// Finds the cells of the points in grid cells from `begin` to `end` - 1.
ALWAYS_INLINE void find_cells(Search* search, uint begin, uint end)
{
    const Grid* grid = &search->grid;
    Window window;
    for (uint cell = begin; cell < end; ++cell) {
        const uint place = place_of_cell(&grid->part, cell);
        const uint first = grid->starts[place];
        const uint last = grid->starts[place + 1];
        if (first == last) continue;
        window.count = MAX_POINTS + 1;
        if (grid->part.grid_size >= 4) gather_window(&window, cell, 1, grid);
        for (uint site = first; site < last; ++site) {
            if (window.count > MAX_POINTS) {
                list_slow(search, site);
            } else {
                finish_alone(search, &window, site, cell, 1);
            }
        }
    }
}

#endif

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
    for (uint i = get_global_id(0) % run * sections + get_global_id(0) / run; i < count; i += get_global_size(0)) {
        const uint site = slow[i];
        const Pair position = positions[site];
        const real size = real_of_uint(part.grid_size);
        const int cell_x = (int)min(uint_of(times(position.x, size)), part.grid_size - 1);
        const int cell_y = (int)min(uint_of(times(position.y, size)), part.grid_size - 1);
        const Surroundings s = {positions, ids,    starts, part, site, position,
                                cell_x,    cell_y, last_ring_of(&part, cell_y)};
        bool is_known;
        const VoronoiCell cell = cell_by_rings(&s, &is_known);
        if (!is_known) atomic_or(unknown, 1u);
        const Results results = {areas, displacements, energies, squared_near};
        store_cell(&cell, site, results);
    }
}

/// A single work-item.
kernel void forget_slow(global uint* slow_count, global uint* unknown)
{
    if (get_global_id(0) == 0) *slow_count = *unknown = 0;
}
