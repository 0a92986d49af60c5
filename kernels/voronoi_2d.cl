// The centroids of the Voronoi cells of points on the torus, exactly, each cell for itself ("meshless
// Voronoi").
//
// After Ray, Sokolov, Lefebvre, Levy: Meshless Voronoi on the GPU, ACM Transactions on Graphics 37(6), 2018:
// each cell is cut by the bisectors of points in nearby grid cells, until no point farther away can matter
// (security radius). Unlike there, the cell is not clipped plane by plane but walked around ("gift
// wrapping"): from one edge to the next, a step looks at all points at once, as vectors.
//   find_centroids_fast   cells whose Voronoi neighbours all lie in the surrounding 3 x 3 or 5 x 5 grid
//                         cells, several at once. Neighbours are found in single precision; the result is
//                         taken only if every vertex is seen, by more than any rounding error, to be nearer
//                         to its own three points than to any other. The geometry of the cell is computed
//                         from its neighbours in double precision. All other sites are listed.
//   find_centroids        the sites of that list, in double precision, without limit to the number of points
//   or edges.
// Points that coincide share their cell as if shifted apart along x by an infinitesimal distance, in order of
// their ids: the first gets the left part of the cell, the last the right part, those between them nothing.
//
// Points are sorted by grid cells, see point_grid.cl. Results are in that order.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/voronoi_2d.clh"
#include "kernels/common/voronoi_2d_batch.clh"
#include "kernels/common/voronoi_2d_window.clh"

/// The results, a value a site.
typedef struct
{
    global double* areas;
    global double2* displacements;
    global double* energies;
    global double* squared_near;
} Results;

ALWAYS_INLINE void store_cell(const VoronoiCell* cell, uint site, Results results)
{
    results.areas[site] = cell->area;
    results.displacements[site] = cell->area > 0 ? cell->moment / cell->area : (double2)0;
    results.energies[site] = cell->energy;
    results.squared_near[site] = cell->squared_near;
}

/// Finds a cell among the points of a window, or proves that `cell`, which is known with its vertices, is right there.
ALWAYS_INLINE bool find_in_window(const Window* window, Margins margins, uint site, bool is_known, const Grid* grid,
                                  VoronoiCell* cell, Vertices* vertices, bool* is_proven)
{
    Differences d;
    const uint vectors =
        subtract_site(window, site, grid->fixed_point[site], grid->fixed_point[grid->stride + site], &d);
    *is_proven = is_known && is_complete(vertices, margins) && is_certain(&d, vectors, vertices);
    if (*is_proven) return true;
    return cell_among(&d, vectors, window, grid->positions[site], grid->positions, cell, vertices) &&
           is_complete(vertices, margins) && is_certain(&d, vectors, vertices);
}

/// A cell of the batch, and its vertices in one piece.
ALWAYS_INLINE void copy_vertices(const BatchCells* cells, uint slot, uint edges, Vertices* vertices)
{
    vertices->count = edges;
    for (uint k = 0; k < (edges <= LANES ? LANES : MAX_EDGES); ++k) {
        vertices->x[k] = ((const float*)&cells->x[k])[slot];
        vertices->y[k] = ((const float*)&cells->y[k])[slot];
    }
    vertices->radius = ((const float*)&cells->radius)[slot];
    vertices->left = ((const float*)&cells->left)[slot];
    vertices->right = ((const float*)&cells->right)[slot];
    vertices->below = ((const float*)&cells->below)[slot];
    vertices->above = ((const float*)&cells->above)[slot];
}

ALWAYS_INLINE void store_of_batch(const BatchCells* cells, uint slot, uint site, Results results)
{
    results.areas[site] = ((const double*)&cells->area)[slot];
    results.displacements[site] = (double2)(((const double*)&cells->displacement_x)[slot],
                                            ((const double*)&cells->displacement_y)[slot]);
    results.energies[site] = ((const double*)&cells->energy)[slot];
    results.squared_near[site] = ((const double*)&cells->squared_near)[slot];
}

/// Computes the cells of a batch. Most are complete in the window that they were found in; others are proven or found
/// in 5 x 5 grid cells, which are gathered once for all points of a cell. What remains goes the slow way.
void finish_batch(Batch* batch, const Grid* grid, Results results, Window* large, uint* large_cell, global uint* slow,
                  global uint* slow_count)
{
    BatchCells cells;
    find_batch_cells(batch, grid->positions, &cells);
    for (uint slot = 0; slot < batch->count; ++slot) {
        const uint site = batch->site[slot];
        const bool is_known = batch->is_known[slot] && ((const double*)&cells.smallest_turn)[slot] > 0;
        Vertices vertices;
        copy_vertices(&cells, slot, (uint)batch->edges[slot], &vertices);
        if (is_known && is_complete(&vertices, batch->margins[slot])) {
            if (is_certain(&batch->differences[slot], batch->vectors[slot], &vertices)) {
                store_of_batch(&cells, slot, site, results);
            } else {
                slow[atomic_inc(slow_count)] = site;
            }
            continue;
        }
        const uint grid_cell = batch->grid_cell[slot];
        if (grid->grid_size >= 6 && *large_cell != grid_cell) {
            gather_window(large, grid_cell % grid->grid_size, grid_cell / grid->grid_size, 2, grid->grid_size,
                          grid->starts, grid->fixed_point, grid->stride);
            *large_cell = grid_cell;
        }
        Margins margins;
        margins_around(site, grid_cell, 2, grid, &margins);
        VoronoiCell cell;
        bool is_proven = false;
        const bool is_found = grid->grid_size >= 6 && large->count <= MAX_POINTS &&
                              find_in_window(large, margins, site, is_known, grid,
                                             &cell, &vertices, &is_proven);
        if (is_proven) {
            store_of_batch(&cells, slot, site, results);
        } else if (is_found) {
            store_cell(&cell, site, results);
        } else {
            slow[atomic_inc(slow_count)] = site;
        }
    }
    batch->count = 0;
}

/// Adds a site, whose points are in a window of 3 x 3 grid cells; of two sites in a row, the neighbours are found.
ALWAYS_INLINE void add_site(Batch* batch, const Window* window, uint site, uint grid_cell, const Grid* grid)
{
    const uint slot = batch->count++;
    batch->window[slot] = window;
    batch->site[slot] = site;
    batch->grid_cell[slot] = grid_cell;
    margins_around(site, grid_cell, 1, grid, &batch->margins[slot]);
    batch->vectors[slot] = subtract_site(window, site, grid->fixed_point[site],
                                         grid->fixed_point[grid->stride + site], &batch->differences[slot]);
    if (slot % 2 == 1) walk_pair(batch, slot - 1);
}

/// One work-item owns `run` grid cells in a row and the Voronoi cells of their points. `displacements` lead from sites
/// to centroids. `width`: that of a grid cell in units of 2^-32, rounded down. Sites that need the slow way are appended
/// to `slow` (in any order); slow_count is 0 before.
kernel void find_centroids_fast(global const double2* positions, global const int* fixed_point, uint stride,
                                global const uint* starts, uint grid_size, float width, uint run,
                                global double* areas, global double2* displacements, global double* energies,
                                global double* squared_near, global uint* slow, global uint* slow_count)
{
    const uint begin = (uint)get_global_id(0) * run;
    const uint end = min(begin + run, grid_size * grid_size);
    const Grid grid = {positions, fixed_point, stride, starts, grid_size, width};
    const Results results = {areas, displacements, energies, squared_near};
    Batch batch;
    batch.count = 0;
    for (uint k = 0; k < ALL_ROWS; ++k) vstore8((uint8)0, 0, batch.neighbour[k]);
    vstore8((uint8)0, 0, batch.site);
    vstore8((int8)0, 0, batch.edges);
    Window windows[2]; // the last site of a cell may wait for one of another cell: its window stays until then
    Window large;
    uint large_cell = UINT_MAX;
    uint number = 0;
    for (uint cell = begin; cell < end; ++cell) {
        const uint last = starts[cell + 1];
        if (starts[cell] == last) continue;
        Window* window = &windows[number % 2];
        window->count = MAX_POINTS + 1;
        if (grid_size >= 4) {
            gather_window(window, cell % grid_size, cell / grid_size, 1, grid_size, starts, fixed_point, stride);
        }
        if (window->count > MAX_POINTS) {
            for (uint site = starts[cell]; site < last; ++site) slow[atomic_inc(slow_count)] = site;
            continue;
        }
        ++number;
        for (uint site = starts[cell]; site < last; ++site) {
            add_site(&batch, window, site, cell, &grid);
            if (batch.count == BATCH_SITES) finish_batch(&batch, &grid, results, &large, &large_cell, slow, slow_count);
        }
    }
    if (batch.count % 2 == 1) walk_single(&batch, batch.count - 1);
    if (batch.count > 0) finish_batch(&batch, &grid, results, &large, &large_cell, slow, slow_count);
}

/// The end of a walk along an edge: the nearest vertex so far, as the parameter t of the edge's line, and the point
/// whose bisector makes it.
typedef struct
{
    double2 difference; // the point behind the vertex
    double offset;      // its bisector holds the positions p with difference . p = offset
    double t;
} Step;

/// A point d, whose bisector holds p with d . p = offset, meets the line of neighbour `a` at parameter t, see
/// walk_around.
ALWAYS_INLINE void consider(const double2 a, double a_offset, const double2 d, double offset, Step* best)
{
    const double2 e = d - a;
    const double turn = cross_product(a, e);
    if (!(turn > 0)) return;
    // If both offsets are half the squared lengths, the numerator is d . (d - a) / 2.
    const bool both_bisectors = (offset > 0) & (a_offset > 0);
    const double t =
        both_bisectors ? dot(d, e) / (2 * turn) : (offset - a_offset * dot(d, a) / dot(a, a)) / turn;
    if (!(t <= best->t)) return;
    if (t == best->t && cross_product(best->difference, d) < 0)
        return; // of several at a vertex, the last counterclockwise
    *best = (Step){d, offset, t};
}

/// A site, and all points of the plane that the torus repeats, by rings of grid cells around it.
typedef struct
{
    global const double2* positions;
    global const uint* ids;
    global const uint* starts;
    uint grid_size;
    uint site;
    double2 position;
    int cell_x, cell_y;
} Surroundings;

/// Everything farther away than this is outside of rings 0 to `ring`.
double reach_of(const Surroundings* s, int ring) { return ring * ((1 - 0x1p-40) / s->grid_size); }

/// Floor of i / n and the remainder, for repeated grids.
int repetition_of(int i, int n) { return i >= 0 ? i / n : -((n - 1 - i) / n); }

/// Calls are textual: OpenCL C has no function pointers. BODY sees `difference` and `index` of each point in
/// a ring.
#define FOR_EACH_IN_RING(s, ring, BODY)                                                                      \
    for (int j_ = -(ring); j_ <= (ring); ++j_) {                                                             \
        const int step_ = j_ == -(ring) || j_ == (ring) || (ring) == 0 ? 1 : 2 * (ring);                     \
        const int n_ = (int)(s)->grid_size;                                                                  \
        const int repeat_y_ = repetition_of((s)->cell_y + j_, n_);                                           \
        for (int i_ = -(ring); i_ <= (ring); i_ += step_) {                                                  \
            const int repeat_x_ = repetition_of((s)->cell_x + i_, n_);                                       \
            const uint cell_ = (uint)((s)->cell_x + i_ - repeat_x_ * n_) +                                   \
                               (uint)((s)->cell_y + j_ - repeat_y_ * n_) * (s)->grid_size;                   \
            const double2 repetition = (double2)(repeat_x_, repeat_y_);                                      \
            for (uint index = (s)->starts[cell_]; index < (s)->starts[cell_ + 1]; ++index) {                 \
                const double2 difference = (s)->positions[index] - (s)->position + repetition;               \
                BODY                                                                                         \
            }                                                                                                \
        }                                                                                                    \
    }

/// The nearest of the points that do not coincide with the site; and whether points of lower or of higher id
/// coincide with it.
double2 nearest_point(const Surroundings* s, bool* has_twin_before, bool* has_twin_after)
{
    *has_twin_before = *has_twin_after = false;
    double2 nearest = (double2)(1, 0); // the site's own repetition
    for (int ring = 0; ring == 0 || reach_of(s, ring - 1) < length(nearest); ++ring) {
        FOR_EACH_IN_RING(s, ring, {
            const double squared = dot(difference, difference);
            if (squared == 0) {
                *has_twin_before |= s->ids[index] < s->ids[s->site];
                *has_twin_after |= s->ids[index] > s->ids[s->site];
            } else if (squared < dot(nearest, nearest)) {
                nearest = difference;
            }
        })
    }
    return nearest;
}

double2 vertex_of(double2 a, double a_offset, double t)
{
    return a * (a_offset / dot(a, a)) + t * (double2)(-a.y, a.x);
}

/// The end of the edge on the line of neighbour `a`.
Step end_of_edge(const Surroundings* s, double2 a, double a_offset, bool has_twin_before, bool has_twin_after)
{
    Step best = {(double2)0, 0, INFINITY};
    if (has_twin_before) consider(a, a_offset, (double2)(-1, 0), 0, &best);
    if (has_twin_after) consider(a, a_offset, (double2)(1, 0), 0, &best);
    // Points in disks around a vertex through the site are at most twice as far from the site as the vertex.
    for (int ring = 0; ring == 0 || !(reach_of(s, ring - 1) > 2 * length(vertex_of(a, a_offset, best.t)));
         ++ring) {
        FOR_EACH_IN_RING(s, ring, {
            const double squared = dot(difference, difference);
            if (squared > 0) consider(a, a_offset, difference, squared / 2, &best);
        })
    }
    return best;
}

void add_triangle(double2 a, double2 b, VoronoiCell* cell)
{
    const double doubled_area = cross_product(a, b);
    cell->area += doubled_area / 2;
    cell->moment += doubled_area / 6 * (a + b);
    cell->energy += doubled_area / 12 * (dot(a, a) + dot(b, b) + dot(a, b));
}

VoronoiCell cell_by_rings(const Surroundings* s)
{
    VoronoiCell cell = {0, (double2)0, 0, 0};
    bool has_twin_before;
    bool has_twin_after;
    const double2 nearest = nearest_point(s, &has_twin_before, &has_twin_after);
    if (has_twin_before && has_twin_after) return cell;

    const bool has_twin = has_twin_before || has_twin_after;
    const double2 first = !has_twin ? nearest : has_twin_after ? (double2)(1, 0) : (double2)(-1, 0);
    const double first_offset = has_twin ? 0 : dot(nearest, nearest) / 2;
    if (!has_twin) cell.squared_near = dot(nearest, nearest);

    Step step = end_of_edge(s, first, first_offset, has_twin_before, has_twin_after);
    const double2 start = vertex_of(first, first_offset, step.t);
    double2 previous = start;
    for (bool is_closed = false; !is_closed;) {
        const double2 a = step.difference;
        const double a_offset = step.offset;
        step = end_of_edge(s, a, a_offset, has_twin_before, has_twin_after);
        const double2 vertex = vertex_of(a, a_offset, step.t);
        add_triangle(previous, vertex, &cell);
        previous = vertex;
        // Directions turn to the left by less than half a turn a step, so this ends even where rounding hides
        // the first.
        is_closed = cross_product(a, first) > 0 && cross_product(first, step.difference) >= 0;
    }
    add_triangle(previous, start, &cell);
    return cell;
}

/// The work-items share the sites of the list.
kernel void find_centroids(global const double2* positions, global const uint* ids, global const uint* starts,
                           uint grid_size, global const uint* slow, global const uint* slow_count,
                           global double* areas, global double2* displacements, global double* energies,
                           global double* squared_near)
{
    const uint count = *slow_count;
    for (uint i = get_global_id(0); i < count; i += get_global_size(0)) {
        const uint site = slow[i];
        const double2 position = positions[site];
        const int cell_x = min((int)(position.x * grid_size), (int)grid_size - 1);
        const int cell_y = min((int)(position.y * grid_size), (int)grid_size - 1);
        const Surroundings s = {positions, ids, starts, grid_size, site, position, cell_x, cell_y};
        const VoronoiCell cell = cell_by_rings(&s);
        const Results results = {areas, displacements, energies, squared_near};
        store_cell(&cell, site, results);
    }
}

/// A single work-item.
kernel void forget_slow(global uint* slow_count)
{
    if (get_global_id(0) == 0) *slow_count = 0;
}
