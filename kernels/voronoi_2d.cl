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

#define ALWAYS_INLINE __attribute__((always_inline))

#define LANES 8
#define VECTORS 12 // room for points of a window
#define MAX_POINTS (LANES * VECTORS)
#define LANE_BITS 127 // lanes are numbered below this
#define MAX_EDGES 16 // more edges go the slow way
#define MAX_REACH 2  // rings of grid cells around a site's
#define BLOCK 4      // corners of a cell that are computed together

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
    int x[MAX_POINTS + 2 * LANES], y[MAX_POINTS + 2 * LANES]; // fixed point, units of 2^-32
    uint index[MAX_POINTS + 2 * LANES];
    uint count;
} Window;

ALWAYS_INLINE double cross_product(double2 a, double2 b) { return a.x * b.y - a.y * b.x; }

/// fmin and fmax must treat NaN apart, which costs most of their time.
ALWAYS_INLINE float8 smaller_of(float8 a, float8 b) { return a < b ? a : b; }
ALWAYS_INLINE float4 larger_of(float4 a, float4 b) { return a > b ? a : b; }
ALWAYS_INLINE double4 smaller_of_doubles(double4 a, double4 b) { return a < b ? a : b; }

ALWAYS_INLINE float minimum_of(float8 v)
{
    const float4 a = v.lo < v.hi ? v.lo : v.hi;
    const float2 b = a.lo < a.hi ? a.lo : a.hi;
    return b.x < b.y ? b.x : b.y;
}

ALWAYS_INLINE int sum_of(int8 v)
{
    const int4 a = v.lo + v.hi;
    const int2 b = a.lo + a.hi;
    return b.x + b.y;
}

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

/// Positions of the window's other points relative to a site, in units of 2^-32.
typedef struct
{
    float8 x[VECTORS], y[VECTORS];
} Differences;

/// Marks lanes that do not take part in a minimum, and as a key that of no lane.
#define NO_KEY FLT_MAX

/// A lane's number in the lowest bits of its value, so that the minimum tells where it is.
ALWAYS_INLINE float8 numbered(float8 value, int8 lane) { return as_float8((as_int8(value) & ~LANE_BITS) | lane); }

ALWAYS_INLINE uint lane_of(float key) { return as_uint(key) & LANE_BITS; }

/// The lanes of the site's Voronoi neighbours, counterclockwise: `count` of them from `begin`.
typedef struct
{
    uint lane[2 * MAX_EDGES];
    uint begin, count;
} Neighbours;

/// Finds them among the first `point_count` lanes. False where the walk does not close within MAX_EDGES. May be wrong where rounding decides.
ALWAYS_INLINE bool walk_around(const Differences* d, uint vectors, uint point_count, Neighbours* neighbours)
{
#pragma OPENCL FP_CONTRACT ON
    const float* x = (const float*)d->x;
    const float* y = (const float*)d->y;

    const float8 none = NO_KEY;
    const int8 first_lanes = (int8)(0, 1, 2, 3, 4, 5, 6, 7);

    // The nearest point is a Voronoi neighbour.
    float8 nearest = none;
    int8 lane = first_lanes;
    for (uint v = 0; v < vectors; ++v, lane += LANES) {
        const float8 squared = d->x[v] * d->x[v] + d->y[v] * d->y[v];
        nearest = smaller_of(nearest, numbered(squared, lane));
    }
    uint left = lane_of(minimum_of(nearest));
    if (left >= point_count) return false;

    // The bisector of neighbour a meets that of d at a / 2 + t / 2 * (a turned left), t = d (d - a) / (a x
    // d): the next neighbour is where t is smallest. Two walks, to the left and to the right, hide each
    // other's latency.
    uint right = left;
    uint begin = MAX_EDGES;
    uint end = MAX_EDGES + 1;
    neighbours->lane[begin] = left;
    while (true) {
        const float ax = x[left];
        const float ay = y[left];
        const float bx = x[right];
        const float by = y[right];
        float8 next_left = none;
        float8 next_right = none;
        lane = first_lanes;
        for (uint v = 0; v < vectors; ++v, lane += LANES) {
            const float8 dx = d->x[v];
            const float8 dy = d->y[v];
            const float8 ex = dx - ax;
            const float8 ey = dy - ay;
            const float8 fx = dx - bx;
            const float8 fy = dy - by;
            const float8 left_turn = ax * ey - ay * ex;
            const float8 right_turn = by * fx - bx * fy;
            const float8 t = (dx * ex + dy * ey) / left_turn;
            const float8 u = (dx * fx + dy * fy) / right_turn;
            next_left = smaller_of(next_left, left_turn > 0.0f ? numbered(t, lane) : none);
            next_right = smaller_of(next_right, right_turn > 0.0f ? numbered(u, lane) : none);
        }
        const uint to_left = lane_of(minimum_of(next_left));
        const uint to_right = lane_of(minimum_of(next_right));
        if (to_left == right) break;
        if (max(to_left, to_right) >= point_count || end - begin + 2 > MAX_EDGES) return false;
        neighbours->lane[end++] = left = to_left;
        if (to_left == to_right) break;
        neighbours->lane[--begin] = right = to_right;
    }
    neighbours->begin = begin;
    neighbours->count = end - begin;
    return end - begin >= 3;
}

/// A cell's vertices in units of 2^-32, relative to the site, then zeros.
typedef struct
{
    float x[MAX_EDGES + LANES], y[MAX_EDGES + LANES];
    uint count;
    // The largest distance of a vertex, and how far the disks around vertices that reach to the site extend to each
    // side, by lanes.
    float4 radius, left, right, below, above;
} Vertices;

ALWAYS_INLINE double total_of(double4 v) { return (v.x + v.y) + (v.z + v.w); }
ALWAYS_INLINE double smallest_of(double4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }

/// To [-0.5, 0.5], by whole turns. Adding this much rounds to whole numbers; rint() is a call on some devices.
ALWAYS_INLINE double4 torus_differences(double4 difference)
{
    const double4 turns = (difference + 0x1.8p52) - 0x1.8p52;
    return difference - turns;
}

ALWAYS_INLINE void add_vertices(double4 exact_x, double4 exact_y, uint at, Vertices* vertices)
{
    const float4 zero = 0;
    const int4 is_vertex = (int4)(0, 1, 2, 3) + (int)at < (int)vertices->count;
    const float4 x = select(zero, convert_float4(exact_x * 4294967296.0), is_vertex);
    const float4 y = select(zero, convert_float4(exact_y * 4294967296.0), is_vertex);
    vstore4(x, 0, vertices->x + at);
    vstore4(y, 0, vertices->y + at);
    const float4 distance = sqrt(x * x + y * y) * (1 + 0x1p-20f);
    vertices->radius = larger_of(vertices->radius, distance);
    vertices->left = larger_of(vertices->left, distance - x);
    vertices->right = larger_of(vertices->right, distance + x);
    vertices->below = larger_of(vertices->below, distance - y);
    vertices->above = larger_of(vertices->above, distance + y);
}

/// The position of a neighbour; after the last, the first follows again.
ALWAYS_INLINE double2 position_of(const Neighbours* neighbours, uint k, const Window* window,
                                  global const double2* positions)
{
    const uint count = neighbours->count;
    const uint around = k < count ? k : k - count;
    const uint twice_around = around < count ? around : around - count;
    return positions[window->index[neighbours->lane[neighbours->begin + twice_around]]];
}

/// A cell from its Voronoi neighbours. False where it is not a polygon.
ALWAYS_INLINE bool cell_from_neighbours(const Neighbours* neighbours, const Window* window, double2 site,
                                        global const double2* positions, VoronoiCell* cell, Vertices* vertices)
{
    const uint count = neighbours->count;
    *vertices = (Vertices){.count = count};
    double4 squared_near = 2;
    double4 smallest_turn = 1;
    double4 area = 0, moment_x = 0, moment_y = 0, energy = 0;
    const double4 end = torus_differences(position_of(neighbours, count - 1, window, positions).xyxy - site.xyxy);
    double last_x = end.x, last_y = end.y; // the neighbour before this block
    double last_qx = 0, last_qy = 0;       // and the vertex
    // Blocks stay in registers: what is stored in pieces is slow to load as a whole.
    for (uint k = 0; k <= count; k += BLOCK) {
        const double2 n0 = position_of(neighbours, k, window, positions);
        const double2 n1 = position_of(neighbours, k + 1, window, positions);
        const double2 n2 = position_of(neighbours, k + 2, window, positions);
        const double2 n3 = position_of(neighbours, k + 3, window, positions);
        const double4 bx = torus_differences((double4)(n0.x, n1.x, n2.x, n3.x) - site.x);
        const double4 by = torus_differences((double4)(n0.y, n1.y, n2.y, n3.y) - site.y);
        const double4 ax = (double4)(last_x, bx.xyz);
        const double4 ay = (double4)(last_y, by.xyz);

        // Where the bisectors of neighbours a and b meet, see walk_around.
        const double4 ex = bx - ax;
        const double4 ey = by - ay;
        const double4 turn = ax * ey - ay * ex;
        const double4 t = (bx * ex + by * ey) / turn;
        const double4 qx = 0.5 * (ax - t * ay);
        const double4 qy = 0.5 * (ay + t * ax);
        squared_near = smaller_of_doubles(squared_near, bx * bx + by * by);
        smallest_turn = smaller_of_doubles(smallest_turn, turn);
        add_vertices(qx, qy, k, vertices);

        // Triangles from the site to two vertices in a row, the second of them number 1 to `count`.
        const double4 px = (double4)(last_qx, qx.xyz);
        const double4 py = (double4)(last_qy, qy.xyz);
        const double4 zero = 0;
        const double4 doubled = select(zero, px * qy - py * qx, (long4)(0, 1, 2, 3) <= (long)(count - k));
        area += doubled;
        moment_x += doubled * (px + qx);
        moment_y += doubled * (py + qy);
        energy += doubled * ((px * px + py * py) + (qx * qx + qy * qy) + (px * qx + py * qy));
        last_x = bx.w;
        last_y = by.w;
        last_qx = qx.w;
        last_qy = qy.w;
    }
    cell->squared_near = smallest_of(squared_near);
    cell->area = total_of(area) / 2;
    cell->moment = (double2)(total_of(moment_x), total_of(moment_y)) / 6;
    cell->energy = total_of(energy) / 12;
    return smallest_of(smallest_turn) > 0;
}

/// The distances from a site to the left, right, lower, and upper border of a window, in units of 2^-32, or a
/// little less.
typedef struct
{
    float left, right, below, above;
} Margins;

/// Is the disk around each vertex, which reaches to the site, inside of the window? Points that the window
/// does not hold cannot cut the cell then.
ALWAYS_INLINE bool is_complete(const Vertices* vertices, Margins margins)
{
    return all((vertices->left < margins.left) & (vertices->right < margins.right) &
               (vertices->below < margins.below) & (vertices->above < margins.above));
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

/// Positions of a window's points relative to a site. Returns the number of vectors. The site itself, and lanes without
/// a point, are put far away, in a direction where there are others.
ALWAYS_INLINE uint subtract_site(const Window* window, uint site, int site_x, int site_y, Differences* d)
{
    const float8 far = 0x1p40f;
    const uint vectors = (window->count + LANES - 1) / LANES;
    for (uint v = 0; v < vectors; ++v) {
        const float8 x = convert_float8(vload8(v, window->x) - site_x);
        d->x[v] = select(x, far, vload8(v, window->index) == site);
        d->y[v] = convert_float8(vload8(v, window->y) - site_y);
    }
    const uint last = vectors - 1;
    const int8 is_empty = (int8)(0, 1, 2, 3, 4, 5, 6, 7) + (int)(last * LANES) >= (int)window->count;
    d->x[last] = select(d->x[last], far, is_empty);
    return vectors;
}

/// The cell that a site has among the points of a window. False where it is open, or has too many edges.
ALWAYS_INLINE bool cell_among(const Differences* d, uint vectors, const Window* window, double2 position,
                              global const double2* positions, VoronoiCell* cell, Vertices* vertices)
{
    Neighbours found;
    if (!walk_around(d, vectors, window->count, &found)) return false;
    return cell_from_neighbours(&found, window, position, positions, cell, vertices);
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

/// The cell of a site from the points in 3 x 3, or else 5 x 5 grid cells around its own; windows are gathered when first
/// needed, until then they hold nothing. False where the slow way is needed.
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
        // What was found in the smaller window most often is the cell; only its proof needs more points.
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

/// What is left of a walk along an edge: the nearest vertex, as the parameter t of the edge's line, and who
/// makes it.
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
    // With both offsets half the squared lengths, the numerator is d . (d - a) / 2.
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
