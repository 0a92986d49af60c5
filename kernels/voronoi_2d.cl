// The centroids of the Voronoi cells of points on the torus, exactly, one cell after the other ("meshless
// Voronoi").
//
// After Ray, Sokolov, Lefebvre, Levy: Meshless Voronoi on the GPU, ACM Transactions on Graphics 37(6), 2018:
// each cell is cut by the bisectors of points in nearby grid cells, until no point farther away can matter
// (security radius). Unlike there, the cell is not clipped plane by plane but walked around ("gift
// wrapping"): from one edge to the next, a step looks at all points at once, as vectors.
//   find_centroids_fast   cells whose Voronoi neighbours all lie in the surrounding 3 x 3 or 5 x 5 grid
//   cells. Neighbours
//                         are found in single precision; the result is taken only if every vertex is seen, by
//                         more than any rounding error, to be nearer to its own three points than to any
//                         other. The geometry of the cell is then computed from its neighbours in double
//                         precision. All other sites are listed.
//   find_centroids        the sites of that list, in double precision, without limit to the number of points
//   or edges.
// Points that coincide share their cell as if shifted apart along x by an infinitesimal distance, in order of
// their ids: the first gets the left part of the cell, the last the right part, those between them nothing.
//
// Points are sorted by grid cells, see point_grid.cl. Results are in that order.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/voronoi_2d.clh"

#define MAX_REACH 2 // rings of grid cells around a site's

ALWAYS_INLINE void append_vector(Window* window, uint at, global const int* fixed_point, uint stride, uint from)
{
    vstore8(vload8(0, fixed_point + from), 0, window->x + at);
    vstore8(vload8(0, fixed_point + stride + from), 0, window->y + at);
    vstore8((uint8)(0, 1, 2, 3, 4, 5, 6, 7) + from, 0, window->index + at);
}

/// Appends a row's points. Copies whole vectors; what is too much is overwritten by the next row.
ALWAYS_INLINE void append_row(Window* window, global const int* fixed_point, uint stride, uint begin,
                              uint end)
{
    const uint at = window->count;
    window->count += end - begin;
    if (window->count > MAX_POINTS) return;
    // Mostly these are enough: no branch to be mispredicted.
    append_vector(window, at, fixed_point, stride, begin);
    append_vector(window, at + LANES, fixed_point, stride, begin + LANES);
    for (uint i = 2 * LANES; i < end - begin; i += LANES) {
        append_vector(window, at + i, fixed_point, stride, begin + i);
    }
}

/// All points in the (2 reach + 1)^2 cells around a cell; count > MAX_POINTS where there are too many.
ALWAYS_INLINE void gather_window(Window* window, uint cell_x, uint cell_y, uint reach, uint grid_size,
                                 global const uint* starts, global const int* fixed_point, uint stride)
{
    window->count = 0;
    for (uint j = 0; j < 2 * reach + 1 && window->count <= MAX_POINTS; ++j) {
        const uint y = cell_y + j + (cell_y + j < reach ? grid_size : 0) - reach;
        global const uint* row = starts + (y < grid_size ? y : y - grid_size) * grid_size;
        const uint low = cell_x + (cell_x < reach ? grid_size : 0) - reach;
        const uint high = low + 2 * reach + 1;
        append_row(window, fixed_point, stride, row[low], row[min(high, grid_size)]);
        if (high > grid_size) append_row(window, fixed_point, stride, row[0], row[high - grid_size]);
    }
}

/// Is each vertex nearer to its own three points than to any other of the window, whatever the rounding?
ALWAYS_INLINE bool is_certain(const Differences* d, uint vectors, const Vertices* vertices)
{
#pragma OPENCL FP_CONTRACT ON
    // d is a neighbour of vertex v, or a closer point, when |d|^2 / 2 - d v is at most 0. Rounding of v, d
    // and the products stays below 2^-20 radius^2, rounding of points to fixed point below 6 radius.
    const float4 r = vertices->radius;
    const float radius = max(max(r.x, r.y), max(r.z, r.w));
    const float threshold = radius * (radius * 0x1p-18f + 8.0f);
    int8 touching = 0;
    for (uint v = 0; v < vectors; ++v) {
        const float8 dx = d->x[v];
        const float8 dy = d->y[v];
        const float8 slack = 0.5f * (dx * dx + dy * dy) - threshold;
        for (uint block = 0; block < vertices->count; block += LANES) {
            _Pragma("unroll") for (uint k = block; k < block + LANES; ++k)
            {
                touching -= dx * vertices->x[k] + dy * vertices->y[k] > slack;
            }
        }
    }
    return sum_of(touching) == 2 * (int)vertices->count; // two neighbours and, not in the window, the site
}

ALWAYS_INLINE void store_cell(const VoronoiCell* cell, uint site, global double* areas,
                              global double2* displacements, global double* energies,
                              global double* squared_near)
{
    areas[site] = cell->area;
    displacements[site] = cell->area > 0 ? cell->moment / cell->area : (double2)0;
    energies[site] = cell->energy;
    squared_near[site] = cell->squared_near;
}

/// The cell of a site from the points in 3 x 3, or else 5 x 5 grid cells around its own; windows are gathered when
/// first needed, until then they hold nothing. False where the slow way is needed.
ALWAYS_INLINE bool find_cell(Window* windows, uint site, uint grid_cell, global const double2* positions,
                             global const int* fixed_point, uint stride, global const uint* starts, uint grid_size,
                             float width, VoronoiCell* cell)
{
    const uint cell_x = grid_cell % grid_size;
    const uint cell_y = grid_cell / grid_size;
    const int x = fixed_point[site];
    const int y = fixed_point[stride + site];
    // Rounding of the positions and of the borders is below 1,024.
    const float left = (float)(uint)x - cell_x * width - 1024.0f;
    const float below = (float)(uint)y - cell_y * width - 1024.0f;
    Vertices vertices;
    bool is_known = false;
    for (uint i = 0; i < MAX_REACH && 2 * i + 4 <= grid_size; ++i) {
        const uint reach = i + 1;
        Window* window = windows + i;
        if (window->count == 0) {
            gather_window(window, cell_x, cell_y, reach, grid_size, starts, fixed_point, stride);
        }
        if (window->count > MAX_POINTS) return false;
        const float width_around = (2 * reach + 1) * width - 4096.0f;
        const Margins margins = {reach * width + left, width_around - (reach * width + left), reach * width + below,
                                 width_around - (reach * width + below)};
        Differences d;
        const uint vectors = subtract_site(window, site, x, y, &d);
        // The cell found in the smaller window is most often the right one; only its proof needs more points.
        if (is_known && is_complete(&vertices, margins) && is_certain(&d, vectors, &vertices)) return true;
        is_known = cell_among(&d, vectors, window, positions[site], positions, cell, &vertices);
        if (is_known && is_complete(&vertices, margins)) return is_certain(&d, vectors, &vertices);
    }
    return false;
}

/// One work-item owns one grid cell and the Voronoi cells of its points. `displacements` lead from sites to
/// centroids. `width`: that of a grid cell in units of 2^-32, rounded down. Sites that need the slow way are
/// appended to `slow` (in any order); slow_count is 0 before.
kernel void find_centroids_fast(global const double2* positions, global const int* fixed_point, uint stride,
                                global const uint* starts, uint grid_size, float width, global double* areas,
                                global double2* displacements, global double* energies,
                                global double* squared_near, global uint* slow, global uint* slow_count)
{
    const uint id = get_global_id(0);
    if (id >= grid_size * grid_size) return;
    const uint end = starts[id + 1];
    Window windows[MAX_REACH];
    for (uint i = 0; i < MAX_REACH; ++i) windows[i].count = 0;
    for (uint site = starts[id]; site < end; ++site) {
        VoronoiCell cell;
        if (find_cell(windows, site, id, positions, fixed_point, stride, starts, grid_size, width, &cell)) {
            store_cell(&cell, site, areas, displacements, energies, squared_near);
        } else {
            slow[atomic_inc(slow_count)] = site;
        }
    }
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
        store_cell(&cell, site, areas, displacements, energies, squared_near);
    }
}

/// A single work-item.
kernel void forget_slow(global uint* slow_count)
{
    if (get_global_id(0) == 0) *slow_count = 0;
}
