// The centroids of the Voronoi cells of points on the 3-torus, exactly, one cell after the other ("meshless Voronoi"):
// the fast way.
//
// After Ray, Sokolov, Lefebvre, Levy: Meshless Voronoi on the GPU, ACM Transactions on Graphics 37(6), 2018: each cell is
// made from the points in nearby grid cells, until no point farther away can matter (security radius). Unlike there, the
// cell is not clipped plane by plane but walked along ("gift wrapping"): from a vertex along an edge to the next, a step
// looks at all points at once, as vectors.
//
// This finds cells whose Voronoi neighbours all lie in the surrounding 5^3 or 7^3 grid cells. Neighbours are found in
// single precision; vertices are computed from them in double precision. The result is taken only if the walk closes and
// every vertex is seen, by more than any rounding error, to be nearer to its own four points than to any other. All other
// sites are listed, for voronoi_3d_slow.cl.
//
// Points are sorted by grid cells, see point_grid.cl. Results are in that order.

#pragma OPENCL FP_CONTRACT OFF

#include "common/voronoi_3d.clh"

#define LANES 8
#define VECTORS 56      // room for points of a window
#define MAX_POINTS (LANES * VECTORS)
#define NEAR_VECTORS 12 // room for points near a site
#define MAX_NEAR (LANES * NEAR_VECTORS)
#define MAX_FACES 32    // more go the slow way
#define MAX_VERTICES (2 * MAX_FACES - 4)
#define NONE 255

/// Points in grid cells around one grid cell.
typedef struct
{
    int x[MAX_POINTS + LANES], y[MAX_POINTS + LANES], z[MAX_POINTS + LANES]; // fixed point, units of 2^-32
    uint index[MAX_POINTS + LANES];
    uint count;
} Window;

/// The difference of coordinates on the torus, in [-1/2, 1/2].
ALWAYS_INLINE double3 torus_difference(double3 difference) { return difference - rint(difference); }

ALWAYS_INLINE float minimum_of_floats(float8 v)
{
    const float4 a = fmin(v.lo, v.hi);
    const float2 b = fmin(a.lo, a.hi);
    return fmin(b.x, b.y);
}

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
ALWAYS_INLINE void gather_window(Window* window, uint cell_x, uint cell_y, uint cell_z, int reach, uint grid_size,
                                 global const uint* starts, global const int* fixed_point, uint stride)
{
    window->count = 0;
    const uint low = wrapped(cell_x, -reach, grid_size);
    const uint high = low + 2 * (uint)reach + 1;
    for (int k = -reach; k <= reach; ++k) {
        const uint z = wrapped(cell_z, k, grid_size);
        for (int j = -reach; j <= reach; ++j) {
            if (window->count > MAX_POINTS) return;
            global const uint* row = starts + (wrapped(cell_y, j, grid_size) + z * grid_size) * grid_size;
            append_row(window, fixed_point, stride, row[low], row[min(high, grid_size)]);
            if (high > grid_size && window->count <= MAX_POINTS) {
                append_row(window, fixed_point, stride, row[0], row[high - grid_size]);
            }
        }
    }
}

/// Points relative to a site. The bisector of point d holds the positions p with d . p = h, h = |d|^2 / 2.
typedef struct
{
    float8 x[VECTORS], y[VECTORS], z[VECTORS], h[VECTORS];
    uint vectors;
} Points;

typedef struct
{
    float8 x[NEAR_VECTORS], y[NEAR_VECTORS], z[NEAR_VECTORS], h[NEAR_VECTORS];
    uint vectors;
    ushort lanes[MAX_NEAR]; // among all points of the window
} NearPoints;

/// The lane with the smallest value, or -1 where all are infinite. `vector`: the number of each value's vector.
ALWAYS_INLINE int lane_of_minimum(float8 value, int8 vector)
{
    const float least = minimum_of_floats(value);
    if (!(least < INFINITY)) return -1;
    const int8 lane = vector * LANES + (int8)(0, 1, 2, 3, 4, 5, 6, 7);
    return minimum_of(select((int8)INT_MAX, lane, value == (float8)least));
}

/// The first bisector that the ray from p in direction u leaves the cell through, or -1. Bisectors whose angle with the ray
/// is too small to tell are passed over.
ALWAYS_INLINE int first_hit(const float8* x, const float8* y, const float8* z, const float8* h, uint vectors, float3 p,
                            float3 u, float threshold)
{
    float8 best = INFINITY;
    int8 best_vector = 0;
    for (uint v = 0; v < vectors; ++v) {
        const float8 distance = h[v] - (x[v] * p.x + y[v] * p.y + z[v] * p.z);
        const float8 speed = x[v] * u.x + y[v] * u.y + z[v] * u.z;
        const float8 t = distance / speed;
        const int8 is_better = (speed > threshold) & (t < best);
        best = select(best, t, is_better);
        best_vector = select(best_vector, (int8)(int)v, is_better);
    }
    return lane_of_minimum(best, best_vector);
}

/// How many points are at most as far from p as the site, but for a threshold.
ALWAYS_INLINE int8 touching(const float8* x, const float8* y, const float8* z, const float8* h, uint vectors, float3 p,
                            float threshold)
{
    int8 count = 0;
    for (uint v = 0; v < vectors; ++v) {
        count -= h[v] - (x[v] * p.x + y[v] * p.y + z[v] * p.z) < threshold;
    }
    return count;
}

/// A cell while it is walked along. Faces are numbered as they are found. A vertex is where faces a, b, c meet,
/// counterclockwise seen from outside; vertex_at[a][b] = vertex_at[b][c] = vertex_at[c][a] is its number. An edge leads
/// from vertex_at[a][b] to vertex_at[b][a].
typedef struct
{
    uint faces;
    uint vertices;
    double3 difference[MAX_FACES]; // of the point behind a face
    double h[MAX_FACES];           // half its square
    double3 position[MAX_VERTICES];
    double squared[MAX_VERTICES]; // distance of a vertex
    uchar a[MAX_VERTICES], b[MAX_VERTICES], c[MAX_VERTICES];
    uchar vertex_at[MAX_FACES][MAX_FACES];
    ushort lane_of[MAX_FACES];
    uchar face_of[MAX_POINTS]; // NONE: none yet
} Walk;

/// A site and the points around it.
typedef struct
{
    const Points* all;
    const NearPoints* near;
    const Window* window;
    global const double* positions;
    double3 position;
    double3 below, above; // from the site to the borders of the window
    double near_radius;
} Site;

/// The number of a face; NONE where there are too many.
ALWAYS_INLINE uint face_at(Walk* w, const Site* s, uint lane)
{
    const uint known = w->face_of[lane];
    if (known != NONE) return known;
    if (w->faces == MAX_FACES) return NONE;
    const uint face = w->faces++;
    const double3 d = torus_difference(vload3(s->window->index[lane], s->positions) - s->position);
    w->difference[face] = d;
    w->h[face] = 0.5 * dot_product(d, d);
    w->lane_of[face] = (ushort)lane;
    w->face_of[lane] = (uchar)face;
    return face;
}

/// Is the ball around p that the site lies on inside the window?
ALWAYS_INLINE bool is_ball_inside(const Site* s, double3 p, double squared)
{
    const double r = sqrt(squared);
    return (r - p.x < s->below.x) & (r - p.y < s->below.y) & (r - p.z < s->below.z) & (r + p.x < s->above.x) &
           (r + p.y < s->above.y) & (r + p.z < s->above.z);
}

/// Where the bisectors of a, b, c meet; u = a x b. False where rounding may matter.
ALWAYS_INLINE bool meet(double3 a, double ha, double3 b, double hb, double3 c, double hc, double3 u, double3* vertex)
{
    const double determinant = dot_product(c, u);
    const double3 sum = ha * cross_product(b, c) + hb * cross_product(c, a) + hc * u;
    *vertex = sum / determinant;
    // 2^-20 of the product of lengths.
    return determinant * determinant > 0x1p-40 * 8 * ha * hb * hc;
}

ALWAYS_INLINE float3 to_floats(double3 v) { return (float3)((float)v.x, (float)v.y, (float)v.z); }

/// Walks to all vertices. Returns 0 where the walk closes, 1 where a larger window may help, 2 where it does not.
ALWAYS_INLINE int walk_along(Walk* w, const Site* s)
{
    const Points* all = s->all;
    const NearPoints* near = s->near;
    const double squared_near_radius = s->near_radius * s->near_radius;

    // The nearest point is a Voronoi neighbour, and halfway to it is on its face.
    float8 best = INFINITY;
    int8 best_vector = 0;
    for (uint v = 0; v < near->vectors; ++v) {
        const int8 is_better = (near->h[v] > 0.0f) & (near->h[v] < best);
        best = select(best, near->h[v], is_better);
        best_vector = select(best_vector, (int8)(int)v, is_better);
    }
    const int nearest = lane_of_minimum(best, best_vector);
    if (nearest < 0) return 1;
    face_at(w, s, near->lanes[nearest]);
    const double3 a = w->difference[0];

    // Any direction in the face leads to an edge, and along the edge to a first vertex. These are vertices 0 and 1 of a
    // search; others start from a vertex.
    double3 p = 0.5 * a;
    double3 u = fabs(a.x) < fabs(a.y) ? (double3)(0, -a.z, a.y) : (double3)(a.z, 0, -a.x);
    uint second = NONE;
    for (int step = 0; step < 2; ++step) {
        const float3 pf = to_floats(p);
        const float3 uf = to_floats(u);
        const float threshold = (float)(s->near_radius * sqrt(dot_product(u, u))) * 0x1p-18f;
        int lane = first_hit(near->x, near->y, near->z, near->h, near->vectors, pf, uf, threshold);
        bool is_sure = false;
        double3 q;
        for (int attempt = 0; attempt < 2 && !is_sure; ++attempt) {
            if (attempt == 1) {
                lane = first_hit(all->x, all->y, all->z, all->h, all->vectors, pf, uf, threshold);
                if (lane < 0) return 1;
            } else {
                if (lane < 0) continue;
                lane = near->lanes[lane];
            }
            const double3 d =
                torus_difference(vload3(s->window->index[lane], s->positions) - s->position);
            const double t = (0.5 * dot_product(d, d) - dot_product(d, p)) / dot_product(d, u);
            q = p + t * u;
            is_sure = attempt == 1 || 4 * dot_product(q, q) < squared_near_radius;
        }
        const uint face = face_at(w, s, (uint)lane);
        if (step == 0) {
            second = face;
            p = q;
            u = cross_product(a, w->difference[face]);
        } else {
            if (w->faces != 3) return 2;
            double3 vertex;
            if (!meet(a, w->h[0], w->difference[second], w->h[second], w->difference[face], w->h[face], u, &vertex)) {
                return 2;
            }
            w->position[0] = vertex;
            w->squared[0] = dot_product(vertex, vertex);
            if (!is_ball_inside(s, vertex, w->squared[0])) return 1;
            w->a[0] = 0;
            w->b[0] = (uchar)second;
            w->c[0] = (uchar)face;
            w->vertex_at[0][second] = w->vertex_at[second][face] = w->vertex_at[face][0] = 0;
            w->vertices = 1;
        }
    }

    for (uint v = 0; v < w->vertices; ++v) {
        uint fa = w->a[v];
        uint fb = w->b[v];
        uint fc = w->c[v];
        const float3 pf = to_floats(w->position[v]);
        for (int edge = 0; edge < 3; ++edge) {
            if (w->vertex_at[fb][fa] == NONE) {
                const double3 da = w->difference[fa];
                const double3 db = w->difference[fb];
                const double ha = w->h[fa];
                const double hb = w->h[fb];
                const double3 direction = cross_product(db, da);
                const float3 uf = to_floats(direction);
                const float threshold =
                    (float)s->near_radius * (fabs(uf.x) + fabs(uf.y) + fabs(uf.z)) * 0x1p-19f;
                const int near_lane =
                    first_hit(near->x, near->y, near->z, near->h, near->vectors, pf, uf, threshold);
                bool is_found = false;
                const uint faces = w->faces;
                uint face = NONE;
                double3 vertex;
                double squared;
                if (near_lane >= 0) {
                    face = face_at(w, s, near->lanes[near_lane]);
                    if (face == NONE) return 2;
                    if (!meet(db, hb, da, ha, w->difference[face], w->h[face], direction, &vertex)) return 2;
                    squared = dot_product(vertex, vertex);
                    is_found = 4 * squared < squared_near_radius;
                }
                if (!is_found) {
                    const int lane = first_hit(all->x, all->y, all->z, all->h, all->vectors, pf, uf, threshold);
                    if (lane < 0) return 1;
                    if (near_lane < 0 || lane != near->lanes[near_lane]) {
                        if (w->faces > faces) { // what was nearest among the near ones is no face, so far
                            w->face_of[near->lanes[near_lane]] = NONE;
                            w->faces = faces;
                        }
                        face = face_at(w, s, (uint)lane);
                        if (face == NONE) return 2;
                        if (!meet(db, hb, da, ha, w->difference[face], w->h[face], direction, &vertex)) return 2;
                        squared = dot_product(vertex, vertex);
                    }
                    if (!is_ball_inside(s, vertex, squared)) return 1;
                }
                if (face == fa || face == fb || w->vertex_at[fa][face] != NONE || w->vertex_at[face][fb] != NONE) {
                    return 2;
                }
                if (w->vertices == MAX_VERTICES) return 2;
                const uint next = w->vertices++;
                w->position[next] = vertex;
                w->squared[next] = squared;
                w->a[next] = (uchar)fb;
                w->b[next] = (uchar)fa;
                w->c[next] = (uchar)face;
                w->vertex_at[fb][fa] = w->vertex_at[fa][face] = w->vertex_at[face][fb] = (uchar)next;
            }
            const uint first = fa;
            fa = fb;
            fb = fc;
            fc = first;
        }
    }
    return w->vertices + 4 == 2 * w->faces ? 0 : 2;
}

/// The same test in double precision, for the points that single precision cannot tell.
bool is_certain_in_doubles(const Walk* w, const Site* s, float threshold)
{
    const Points* all = s->all;
    const double limit = 0x1p-26 * s->near_radius * s->near_radius;
    for (uint v = 0; v < w->vertices; ++v) {
        const double3 p = w->position[v];
        const float3 pf = to_floats(p);
        for (uint lane = 0; lane < s->window->count; ++lane) {
            const float x = ((const float*)all->x)[lane];
            const float y = ((const float*)all->y)[lane];
            const float z = ((const float*)all->z)[lane];
            const float h = ((const float*)all->h)[lane];
            if (!(h - (x * pf.x + y * pf.y + z * pf.z) < threshold) || h == 0) continue;
            const uint face = w->face_of[lane];
            if (face != NONE && (face == w->a[v] || face == w->b[v] || face == w->c[v])) continue;
            const double3 d =
                torus_difference(vload3(s->window->index[lane], s->positions) - s->position);
            if (!(0.5 * dot_product(d, d) - dot_product(d, p) > limit)) return false;
        }
    }
    return true;
}

/// Is each vertex nearer to its own four points than to any other of the window, whatever the rounding?
ALWAYS_INLINE bool is_certain(const Walk* w, const Site* s)
{
    const Points* all = s->all;
    const NearPoints* near = s->near;
    const double squared_near_radius = s->near_radius * s->near_radius;
    double squared_radius = 0;
    for (uint v = 0; v < w->vertices; ++v) squared_radius = fmax(squared_radius, w->squared[v]);
    const float radius = (float)sqrt(squared_radius) * 1.0001f;

    // Of points d with |d| <= D, coordinates are rounded to fixed point (2^-32) and to floats (2^-24 of them), and so are the
    // vertex' and the products: h - d . p is off by less than 2^-24 D (2.5 D + 9 |p|) + 2^-30 (D + |p|). Twice that, which
    // also covers what determinants leave of the vertices' precision (2^-29).
    const float near_radius = (float)s->near_radius;
    const float near_threshold = near_radius * (2.5f * near_radius + 9 * radius) * 0x1p-23f + (near_radius + radius) * 0x1p-29f;
    const double3 extent = fmax(s->below, s->above);
    const float far_radius = (float)sqrt(dot_product(extent, extent)) * 1.0001f;
    const float far_threshold = far_radius * (2.5f * far_radius + 9 * radius) * 0x1p-23f + (far_radius + radius) * 0x1p-29f;

    int8 count = 0;
    for (uint v = 0; v < w->vertices; ++v) {
        const float3 p = to_floats(w->position[v]);
        if (4 * w->squared[v] < squared_near_radius) {
            count += touching(near->x, near->y, near->z, near->h, near->vectors, p, near_threshold);
        } else {
            count += touching(all->x, all->y, all->z, all->h, all->vectors, p, far_threshold);
        }
    }
    // The site itself and three neighbours.
    return sum_of(count) == 4 * (int)w->vertices || is_certain_in_doubles(w, s, far_threshold);
}

/// Sums over the tetrahedra of the site, the foot f of a face and an edge from p to q, det = 6 times its volume: sums of
/// det, det * (f + p + q) and so on, to be divided at the end.
ALWAYS_INLINE void integrate(const Walk* w, VoronoiCell* cell)
{
    double volume = 0;
    double3 moment = 0;
    double energy = 0;
    for (uint v = 0; v < w->vertices; ++v) {
        uint fa = w->a[v];
        uint fb = w->b[v];
        uint fc = w->c[v];
        const double3 p = w->position[v];
        for (int edge = 0; edge < 3; ++edge) {
            const uint next = w->vertex_at[fb][fa];
            if (next > v) {
                const double3 q = w->position[next];
                const double3 normal = cross_product(p, q);
                // Seen from outside, the edge (a, b) from p leaves face a on its right, b on its left.
                const double3 a = w->difference[fa];
                const double3 b = w->difference[fb];
                const double det_a = 0.5 * dot_product(a, normal);
                const double det_b = -0.5 * dot_product(b, normal);
                const double3 sum = p + q;
                const double squares = w->squared[v] + w->squared[next];
                const double3 sum_a = sum + 0.5 * a;
                const double3 sum_b = sum + 0.5 * b;
                volume += det_a + det_b;
                moment += det_a * sum_a + det_b * sum_b;
                energy += det_a * (dot_product(sum_a, sum_a) + squares + 0.5 * w->h[fa]) +
                          det_b * (dot_product(sum_b, sum_b) + squares + 0.5 * w->h[fb]);
            }
            const uint first = fa;
            fa = fb;
            fb = fc;
            fc = first;
        }
    }
    const double sign = volume < 0 ? -1 : 1;
    cell->volume = sign * volume / 6;
    cell->moment = sign * moment / 24;
    cell->energy = sign * energy / 120;
    cell->squared_near = 2 * w->h[0];
    for (uint f = 1; f < w->faces; ++f) cell->squared_near = fmin(cell->squared_near, 2 * w->h[f]);
}

/// The cell of a site from a window. Returns 0 where it is sure, 1 where a larger window may help, 2 where the slow way is
/// needed. The window reaches from the site by `below` and `above` at least; near_radius is less than all of these.
ALWAYS_INLINE int cell_in_window(const Window* window, int site_x, int site_y, int site_z, double3 position,
                                 double3 below, double3 above, double near_radius, global const double* positions,
                                 VoronoiCell* cell)
{
    Points all;
    all.vectors = (window->count + LANES - 1) / LANES;
    int8 zeros = 0;
    for (uint v = 0; v < all.vectors; ++v) {
        const float8 x = convert_float8(vload8(v, window->x) - site_x) * 0x1p-32f;
        const float8 y = convert_float8(vload8(v, window->y) - site_y) * 0x1p-32f;
        const float8 z = convert_float8(vload8(v, window->z) - site_z) * 0x1p-32f;
        all.x[v] = x;
        all.y[v] = y;
        all.z[v] = z;
        all.h[v] = 0.5f * (x * x + y * y + z * z);
    }
    // Lanes without a point: no ray ever meets them.
    const uint last = all.vectors - 1;
    const int8 is_empty = (int8)(0, 1, 2, 3, 4, 5, 6, 7) + (int)(last * LANES) >= (int)window->count;
    all.x[last] = select(all.x[last], (float8)0.0f, is_empty);
    all.y[last] = select(all.y[last], (float8)0.0f, is_empty);
    all.z[last] = select(all.z[last], (float8)0.0f, is_empty);
    all.h[last] = select(all.h[last], (float8)0x1p60f, is_empty);
    for (uint v = 0; v < all.vectors; ++v) zeros -= all.h[v] == 0.0f;
    if (sum_of(zeros) != 1) return 2;

    NearPoints near;
    const float near_limit = (float)(0.5 * near_radius * near_radius) * 1.0001f;
    uint count = 0;
    for (uint lane = 0; lane < window->count; ++lane) {
        near.lanes[count] = (ushort)lane;
        count += ((const float*)all.h)[lane] < near_limit;
        if (count > MAX_NEAR - LANES) return 2;
    }
    for (uint i = 0; i < count; ++i) {
        const uint lane = near.lanes[i];
        ((float*)near.x)[i] = ((const float*)all.x)[lane];
        ((float*)near.y)[i] = ((const float*)all.y)[lane];
        ((float*)near.z)[i] = ((const float*)all.z)[lane];
        ((float*)near.h)[i] = ((const float*)all.h)[lane];
    }
    near.vectors = (count + LANES - 1) / LANES;
    for (uint i = count; i < near.vectors * LANES; ++i) {
        ((float*)near.x)[i] = ((float*)near.y)[i] = ((float*)near.z)[i] = 0;
        ((float*)near.h)[i] = 0x1p60f;
    }

    const Site site = {&all, &near, window, positions, position, below, above, near_radius};
    Walk walk;
    walk.faces = 0;
    walk.vertices = 0;
    for (uint i = 0; i < MAX_FACES; ++i) {
        vstore16((uchar16)NONE, 0, walk.vertex_at[i]);
        vstore16((uchar16)NONE, 1, walk.vertex_at[i]);
    }
    for (uint i = 0; i < MAX_POINTS / 16; ++i) vstore16((uchar16)NONE, i, walk.face_of);
    const int failure = walk_along(&walk, &site);
    if (failure != 0) return failure;
    if (!is_certain(&walk, &site)) return 2;
    integrate(&walk, cell);
    return 0;
}

/// One work-item owns one grid cell and the Voronoi cells of its points. `displacements` lead from sites to centroids.
/// `margin`: the width of a grid cell in units of 2^-32, rounded down. Sites that need the slow way are appended to `slow`
/// (in any order); slow_count is 0 before.
kernel void find_centroids_fast(global const double* positions, global const int* fixed_point, uint stride,
                                global const uint* starts, uint grid_size, float margin, global double* volumes,
                                global double* displacements, global double* energies, global double* squared_near,
                                global uint* slow, global uint* slow_count)
{
    const uint id = get_global_id(0);
    if (id >= grid_size * grid_size * grid_size) return;
    const uint begin = starts[id];
    const uint end = starts[id + 1];
    if (begin == end) return;
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
            gather_window(&window, cell_x, cell_y, cell_z, reach, grid_size, starts, fixed_point, stride);
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
