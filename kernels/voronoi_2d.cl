// The centroids of the Voronoi cells of points on the torus, exactly, one cell after the other ("meshless Voronoi").
//
// After Ray, Sokolov, Lefebvre, Levy: Meshless Voronoi on the GPU, ACM Transactions on Graphics 37(6), 2018: each cell is
// cut by the bisectors of points in nearby grid cells, until no point farther away can matter (security radius). Unlike
// there, the cell is not clipped plane by plane but walked around ("gift wrapping"): from one edge to the next, a step
// looks at all points at once, as vectors.
//   find_centroids_fast   cells whose Voronoi neighbours all lie in the surrounding 3 x 3 or 5 x 5 grid cells. Neighbours
//                         are found in single precision; the result is taken only if every vertex is seen, by more than
//                         any rounding error, to be nearer to its own three points than to any other. The geometry of the
//                         cell is then computed from its neighbours in double precision. All other sites are listed.
//   find_centroids        the sites of that list, in double precision, without limit to the number of points or edges.
// Points that coincide share their cell as if shifted apart along x by an infinitesimal distance, in order of their ids:
// the first gets the left part of the cell, the last the right part, those between them nothing.
//
// Points are sorted by grid cells, see point_grid.cl. Results are in that order.

#pragma OPENCL FP_CONTRACT OFF

#define ALWAYS_INLINE __attribute__((always_inline))

#define LANES 8
#define VECTORS 12                // room for points of a window
#define MAX_POINTS (LANES * VECTORS)
#define MAX_EDGES 16              // a power of two; more edges go the slow way

/// What is known of a Voronoi cell, with coordinates relative to its site.
typedef struct
{
    double area;
    double2 moment;      // integral of the position
    double energy;       // integral of the squared distance to the site
    double squared_near; // squared distance of the nearest point
} VoronoiCell;

/// Points in grid cells around one grid cell.
typedef struct
{
    int x[MAX_POINTS + LANES], y[MAX_POINTS + LANES]; // fixed point, units of 2^-32
    uint index[MAX_POINTS + LANES];
    uint count;
} Window;

/// The difference of coordinates on the torus, in [-1/2, 1/2].
ALWAYS_INLINE double2 torus_difference(double2 difference) { return difference - rint(difference); }

ALWAYS_INLINE double cross_product(double2 a, double2 b) { return a.x * b.y - a.y * b.x; }

ALWAYS_INLINE int minimum_of(int8 v)
{
    const int4 a = min(v.lo, v.hi);
    const int2 b = min(a.lo, a.hi);
    return min(b.x, b.y);
}

ALWAYS_INLINE int sum_of(int8 v)
{
    const int4 a = v.lo + v.hi;
    const int2 b = a.lo + a.hi;
    return b.x + b.y;
}

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
        vstore8((uint8)(0, 1, 2, 3, 4, 5, 6, 7) + (begin + i), 0, window->index + at);
    }
    window->count += count;
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

/// Positions of the window's points relative to a site, in units of 2^-32.
typedef struct
{
    float8 x[VECTORS], y[VECTORS];
} Differences;

/// Float lanes as integers with the same order, the lane's number in the lowest bits.
ALWAYS_INLINE int8 numbered(float8 value, uint vector_number)
{
    const int8 bits = as_int8(value);
    const int8 ordered = bits ^ ((bits >> 31) & 0x7fffffff);
    return (ordered & ~127) | ((int8)(0, 1, 2, 3, 4, 5, 6, 7) + (int)(vector_number * LANES));
}

/// The lanes of the site's Voronoi neighbours, counterclockwise, up to MAX_EDGES of them. Returns their number, or 0 where
/// the walk does not close. May be wrong where rounding decides.
ALWAYS_INLINE uint walk_around(const Differences* d, uint vectors, uint* neighbours)
{
    const float* x = (const float*)d->x;
    const float* y = (const float*)d->y;

    // The nearest point is a Voronoi neighbour.
    int8 nearest = INT_MAX;
    for (uint v = 0; v < vectors; ++v) {
        const float8 squared = d->x[v] * d->x[v] + d->y[v] * d->y[v];
        const int8 key = numbered(squared, v);
        nearest = min(nearest, squared > 0.0f ? key : INT_MAX);
    }
    const uint first = (uint)minimum_of(nearest) & 127;
    if (first >= MAX_POINTS) return 0;

    // The bisector of neighbour a meets that of d at a / 2 + t / 2 * (a turned left), t = d (d - a) / (a x d): the next
    // neighbour is where t is smallest.
    uint count = 0;
    uint lane = first;
    do {
        if (count == MAX_EDGES) return 0;
        neighbours[count++] = lane;
        const float ax = x[lane];
        const float ay = y[lane];
        int8 next = INT_MAX;
        for (uint v = 0; v < vectors; ++v) {
            const float8 dx = d->x[v];
            const float8 dy = d->y[v];
            const float8 ex = dx - ax;
            const float8 ey = dy - ay;
            const float8 turn = ax * ey - ay * ex;
            const float8 t = (dx * ex + dy * ey) / turn;
            next = min(next, turn > 0.0f ? numbered(t, v) : INT_MAX);
        }
        lane = (uint)minimum_of(next) & 127;
        if (lane >= MAX_POINTS) return 0;
    } while (lane != first);
    return count;
}

/// A cell from its Voronoi neighbours, and its vertices in units of 2^-32. False where it is not a polygon that goes
/// around the site once.
ALWAYS_INLINE bool cell_from_neighbours(const double2* neighbours, uint count, VoronoiCell* cell, float2* vertices)
{
    double2 a = neighbours[count - 1];
    double2 previous;
    double2 first;
    bool turns_left = true;
    uint turns = 0;
    double area = 0, energy = 0, squared_near = 2;
    double2 moment = 0;
    for (uint k = 0; k <= count; ++k) {
        const double2 b = neighbours[k < count ? k : 0];
        const double2 e = b - a;
        const double turn = cross_product(a, e);
        const double t = (b.x * e.x + b.y * e.y) / turn;
        const double2 vertex = 0.5 * (double2)(a.x - t * a.y, a.y + t * a.x);
        if (k > 0) {
            const double doubled = cross_product(previous, vertex);
            area += doubled;
            moment += doubled * (previous + vertex);
            energy += doubled * (dot(previous, previous) + dot(vertex, vertex) + dot(previous, vertex));
            turns_left &= turn > 0;
            turns += (a.y < 0) & (b.y >= 0);
            squared_near = fmin(squared_near, dot(a, a));
            vertices[k - 1] = convert_float2(vertex * 4294967296.0);
        }
        previous = vertex;
        a = b;
    }
    cell->area = area / 2;
    cell->moment = moment / 6;
    cell->energy = energy / 12;
    cell->squared_near = squared_near;
    return turns_left & (turns == 1);
}

/// Is each vertex nearer to its own three points than to any other of the window, whatever the rounding? `radius`: the
/// largest distance of a vertex.
ALWAYS_INLINE bool is_certain(const Differences* d, uint vectors, const float2* vertices, uint count, float radius)
{
    // d is a neighbour of vertex v, or a closer point, when |d|^2 / 2 - d v is at most 0. Rounding of v, d and the
    // products stays below 2^-20 radius^2, rounding of points to fixed point below 6 radius.
    const float threshold = radius * (radius * 0x1p-18f + 8.0f);
    int8 touching = 0;
    for (uint v = 0; v < vectors; ++v) {
        const float8 x = d->x[v];
        const float8 y = d->y[v];
        const float8 half_squared = 0.5f * (x * x + y * y);
        for (uint k = 0; k < count; ++k) {
            touching -= half_squared - (x * vertices[k].x + y * vertices[k].y) < threshold;
        }
    }
    return sum_of(touching) == 3 * (int)count; // the site itself and two neighbours
}

/// The cell of a site from a window that reaches `margin` (units of 2^-32) in every direction, at least. Returns 0 where it
/// is sure, 1 where a larger window may help, 2 where doubles are needed.
ALWAYS_INLINE int cell_in_window(const Window* window, uint site, int site_x, int site_y, float margin,
                                 global const double2* positions, VoronoiCell* cell)
{
    const uint vectors = (window->count + LANES - 1) / LANES;
    Differences d;
    for (uint v = 0; v < vectors; ++v) {
        d.x[v] = convert_float8(vload8(v, window->x) - site_x);
        d.y[v] = convert_float8(vload8(v, window->y) - site_y);
    }
    // Lanes without a point: far away, in a direction where there are others.
    const uint last = vectors - 1;
    const int8 is_empty = (int8)(0, 1, 2, 3, 4, 5, 6, 7) + (int)(last * LANES) >= (int)window->count;
    d.x[last] = select(d.x[last], 0x1p40f, is_empty);

    uint lanes[MAX_EDGES];
    const uint count = walk_around(&d, vectors, lanes);
    if (count < 3) return 1;
    const double2 position = positions[site];
    double2 neighbours[MAX_EDGES];
    for (uint k = 0; k < count; ++k) {
        neighbours[k] = torus_difference(positions[window->index[lanes[k]]] - position);
    }
    float2 vertices[MAX_EDGES];
    if (!cell_from_neighbours(neighbours, count, cell, vertices)) return 1;
    float squared_radius = 0;
    for (uint k = 0; k < count; ++k) squared_radius = fmax(squared_radius, dot(vertices[k], vertices[k]));
    const float radius = sqrt(squared_radius);
    if (!(2.0001f * radius < margin)) return 1;
    return is_certain(&d, vectors, vertices, count, radius) ? 0 : 2;
}

ALWAYS_INLINE void store_cell(const VoronoiCell* cell, uint site, global double* areas, global double2* displacements,
                              global double* energies, global double* squared_near)
{
    areas[site] = cell->area;
    displacements[site] = cell->area > 0 ? cell->moment / cell->area : (double2)0;
    energies[site] = cell->energy;
    squared_near[site] = cell->squared_near;
}

/// One work-item owns one grid cell and the Voronoi cells of its points. `displacements` lead from sites to centroids.
/// `margin`: the width of a grid cell in units of 2^-32, rounded down. Sites that need the slow way are appended to `slow`
/// (in any order); slow_count is 0 before.
kernel void find_centroids_fast(global const double2* positions, global const int* fixed_point, uint stride,
                                global const uint* starts, uint grid_size, float margin, global double* areas,
                                global double2* displacements, global double* energies, global double* squared_near,
                                global uint* slow, global uint* slow_count)
{
    const uint id = get_global_id(0);
    if (id >= grid_size * grid_size) return;
    const uint begin = starts[id];
    const uint end = starts[id + 1];
    if (begin == end) return;
    const uint cell_x = id % grid_size;
    const uint cell_y = id / grid_size;

    uint pending = begin; // sites from here on have no cell yet
    Window window;
    for (uint reach = 1; reach <= 2 && 2 * reach + 2 <= grid_size && pending < end; ++reach) {
        gather_window(&window, cell_x, cell_y, reach, grid_size, starts, fixed_point, stride);
        if (window.count > MAX_POINTS) break;
        for (; pending < end; ++pending) {
            VoronoiCell cell;
            const int failure = cell_in_window(&window, pending, fixed_point[pending], fixed_point[stride + pending],
                                               margin * reach, positions, &cell);
            if (failure == 1 && reach == 1) break;
            if (failure == 0) {
                store_cell(&cell, pending, areas, displacements, energies, squared_near);
            } else {
                slow[atomic_inc(slow_count)] = pending;
            }
        }
    }
    for (; pending < end; ++pending) slow[atomic_inc(slow_count)] = pending;
}

/// What is left of a walk along an edge: the nearest vertex, as the parameter t of the edge's line, and who makes it.
typedef struct
{
    double2 difference; // the point behind the vertex
    double offset;      // its bisector holds the positions p with difference . p = offset
    double t;
} Step;

/// A point d, whose bisector holds p with d . p = offset, meets the line of neighbour `a` at parameter t, see walk_around.
ALWAYS_INLINE void consider(const double2 a, double a_offset, const double2 d, double offset, Step* best)
{
    const double2 e = d - a;
    const double turn = cross_product(a, e);
    if (!(turn > 0)) return;
    // With both offsets half the squared lengths, the numerator is d . (d - a) / 2.
    const bool both_bisectors = (offset > 0) & (a_offset > 0);
    const double t = both_bisectors ? dot(d, e) / (2 * turn)
                                    : (offset - a_offset * dot(d, a) / dot(a, a)) / turn;
    if (!(t <= best->t)) return;
    if (t == best->t && cross_product(best->difference, d) < 0) return; // of several at a vertex, the last counterclockwise
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

/// Calls are textual: OpenCL C has no function pointers. BODY sees `difference` and `index` of each point in a ring.
#define FOR_EACH_IN_RING(s, ring, BODY)                                                                                \
    for (int j_ = -(ring); j_ <= (ring); ++j_) {                                                                       \
        const int step_ = j_ == -(ring) || j_ == (ring) || (ring) == 0 ? 1 : 2 * (ring);                               \
        const int n_ = (int)(s)->grid_size;                                                                            \
        const int repeat_y_ = repetition_of((s)->cell_y + j_, n_);                                                     \
        for (int i_ = -(ring); i_ <= (ring); i_ += step_) {                                                            \
            const int repeat_x_ = repetition_of((s)->cell_x + i_, n_);                                                 \
            const uint cell_ = (uint)((s)->cell_x + i_ - repeat_x_ * n_) +                                             \
                               (uint)((s)->cell_y + j_ - repeat_y_ * n_) * (s)->grid_size;                             \
            const double2 repetition = (double2)(repeat_x_, repeat_y_);                                                \
            for (uint index = (s)->starts[cell_]; index < (s)->starts[cell_ + 1]; ++index) {                           \
                const double2 difference = (s)->positions[index] - (s)->position + repetition;                         \
                BODY                                                                                                   \
            }                                                                                                          \
        }                                                                                                              \
    }

/// The nearest of the points that do not coincide with the site; and whether points of lower or of higher id coincide with
/// it.
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
    for (int ring = 0; ring == 0 || !(reach_of(s, ring - 1) > 2 * length(vertex_of(a, a_offset, best.t))); ++ring) {
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
        // Directions turn to the left by less than half a turn a step, so this ends even where rounding hides the first.
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
