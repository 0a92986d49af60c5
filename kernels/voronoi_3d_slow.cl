// The centroids of the Voronoi cells on the 3-torus that the fast way, voronoi_3d_fast.cl, leaves: in double precision,
// by clipping. Faces are polygons that share their corners, so that ties, as lattices have them, do no harm. Cells with
// too many faces or corners are made edge by edge, without storage. Where points that are not held may matter, a cell
// cannot be known.
//
// Points that coincide share their cell as if shifted apart along x by an infinitesimal distance, in order of their
// ids: the first gets the left part of the cell, the last the right part, those between them nothing.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/grid_part.clh"
#include "kernels/common/voronoi/voronoi_3d.clh"

#define SLOW_FACES 128
#define SLOW_CORNERS 40

/// A site, and all points of the space that the torus repeats, by shells of grid cells around it.
typedef struct
{
    global const double* positions;
    global const uint* ids;
    global const uint* starts;
    struct GridPart part;
    uint site;
    double3 position;
    int cell_x, cell_y, cell_z;
    int last_shell;                       // that is held
    bool has_twin_before, has_twin_after; // points of lower or of higher id that coincide with the site
} Surroundings;

/// The number of shells around a cell that are held, where not all of the grid is.
int last_shell_of(const struct GridPart* part, int cell_z)
{
    if (part->held == part->cells) return INT_MAX;
    const uint plane = part->grid_size * part->grid_size;
    const int planes = (int)(part->held / plane);
    const int place = (int)(place_of_cell(part, (uint)cell_z * plane) / plane);
    return min(place, planes - 1 - place);
}

/// Everything farther away than this is outside of shells 0 to `shell`.
double reach_of(const Surroundings* s, int shell) { return shell * ((1 - 0x1p-40) / s->part.grid_size); }

/// Floor of i / n.
int repetition_of(int i, int n) { return i >= 0 ? i / n : -((n - 1 - i) / n); }

/// Calls are textual: OpenCL C has no function pointers. BODY sees `difference` and `index` of each point in a shell,
/// but for the site itself and its twins.
#define FOR_EACH_IN_SHELL(s, shell, BODY)                                                                              \
    for (int k_ = -(shell); k_ <= (shell); ++k_) {                                                                     \
        for (int j_ = -(shell); j_ <= (shell); ++j_) {                                                                 \
            const bool is_border_ = abs(k_) == (shell) || abs(j_) == (shell);                                          \
            const int step_ = is_border_ ? 1 : 2 * (shell);                                                            \
            const int n_ = (int)(s)->part.grid_size;                                                                   \
            const int repeat_z_ = repetition_of((s)->cell_z + k_, n_);                                                 \
            const int repeat_y_ = repetition_of((s)->cell_y + j_, n_);                                                 \
            const uint row_ = place_of_cell(                                                                           \
                &(s)->part,                                                                                            \
                (uint)(((s)->cell_y + j_ - repeat_y_ * n_ + ((s)->cell_z + k_ - repeat_z_ * n_) * n_) * n_));          \
            for (int i_ = -(shell); i_ <= (shell); i_ += step_) {                                                      \
                const int repeat_x_ = repetition_of((s)->cell_x + i_, n_);                                             \
                const uint cell_ = row_ + (uint)((s)->cell_x + i_ - repeat_x_ * n_);                                   \
                const double3 repetition_ = (double3)(repeat_x_, repeat_y_, repeat_z_);                                \
                for (uint index = (s)->starts[cell_]; index < (s)->starts[cell_ + 1]; ++index) {                       \
                    const double3 difference = vload3(index, (s)->positions) - (s)->position + repetition_;            \
                    if (difference.x != 0 || difference.y != 0 || difference.z != 0) BODY                              \
                }                                                                                                      \
            }                                                                                                          \
        }                                                                                                              \
    }

/// All positions p with normal . p <= offset; the largest coordinate of `normal` is 1 or -1.
typedef struct
{
    double3 normal;
    double offset;
} HalfSpace;

/// The half-space of the positions that are nearer to the site than to a point, computed without underflow.
HalfSpace half_space_of(double3 difference)
{
    const double largest = fmax(fmax(fabs(difference.x), fabs(difference.y)), fabs(difference.z));
    const double3 normal = difference / largest;
    return (HalfSpace){normal, 0.5 * largest * dot_product(normal, normal)};
}

/// Two vectors that make a right-handed system with a half-space's normal; lengths are between 1 and 2.
void axes_of(double3 normal, double3* first, double3* second)
{
    const double3 n = normal / sqrt(dot_product(normal, normal));
    const double3 u = fabs(n.x) < 0.5 ? (double3)(0, -n.z, n.y) : (double3)(n.z, 0, -n.x);
    *first = u / sqrt(dot_product(u, u));
    *second = cross_product(n, *first);
}

/// A convex polyhedron as polygons, counterclockwise seen from outside. Polygons share corners, bit for bit, so that
/// the surface stays closed whatever rounding does.
typedef struct
{
    uint faces;
    double squared_radius; // distance of the farthest corner
    uint corners[SLOW_FACES];
    double3 corner[SLOW_FACES][SLOW_CORNERS];
} Polyhedron;

/// Edges of the face that a cut makes.
typedef struct
{
    uint count;
    double3 from[SLOW_CORNERS], to[SLOW_CORNERS];
} Seam;

bool equal_positions(double3 a, double3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Appends a corner unless it is the last one again. Returns the number of corners, SLOW_CORNERS + 1 where there are
/// too many.
uint append_corner(double3* corner, uint corners, double3 p)
{
    if (corners > 0 && equal_positions(corner[corners - 1], p)) return corners;
    if (corners >= SLOW_CORNERS) return SLOW_CORNERS + 1;
    corner[corners] = p;
    return corners + 1;
}

/// Cuts a polygon (Sutherland and Hodgman). Returns its number of corners; SLOW_CORNERS + 1 where there are too many.
uint clip_polygon(double3* corner, uint corners, HalfSpace h, Seam* seam)
{
    double3 result[SLOW_CORNERS];
    uint count = 0;
    uint first = 0;
    while (first < corners && dot_product(h.normal, corner[first]) > h.offset) ++first;
    if (first == corners) return 0;
    double3 p = corner[first];
    double p_value = dot_product(h.normal, p) - h.offset;
    double3 way_out = p;
    for (uint i = 1; i <= corners && count <= SLOW_CORNERS; ++i) {
        const double3 q = corner[(first + i) % corners];
        const double q_value = dot_product(h.normal, q) - h.offset;
        if ((p_value > 0) != (q_value > 0)) {
            // The same for the polygon on the other side of the edge.
            const bool is_out = q_value > 0;
            const double3 inside = is_out ? p : q;
            const double3 outside = is_out ? q : p;
            const double inside_value = is_out ? p_value : q_value;
            const double outside_value = is_out ? q_value : p_value;
            const double3 crossing = inside + (inside_value / (inside_value - outside_value)) * (outside - inside);
            count = append_corner(result, count, crossing);
            if (is_out) {
                way_out = crossing;
            } else if (!equal_positions(crossing, way_out)) {
                if (seam->count == SLOW_CORNERS) return SLOW_CORNERS + 1;
                seam->from[seam->count] = crossing;
                seam->to[seam->count++] = way_out;
            }
        }
        if (!(q_value > 0) && count <= SLOW_CORNERS) count = append_corner(result, count, q);
        p = q;
        p_value = q_value;
    }
    if (count > SLOW_CORNERS) return count;
    if (count > 1 && equal_positions(result[count - 1], result[0])) --count;
    for (uint i = 0; i < count; ++i) corner[i] = result[i];
    return count;
}

/// Adds the faces that a seam borders: one, unless rounding makes several loops. False where there is no room.
bool add_seam(Polyhedron* p, Seam* seam)
{
    uint begin = 0; // of the loop
    for (uint i = 0; i < seam->count; ++i) {
        const double3 end = seam->to[i];
        const bool is_closed = equal_positions(end, seam->from[begin]);
        if (!is_closed) {
            for (uint j = i + 1; j < seam->count; ++j) {
                if (!equal_positions(seam->from[j], end)) continue;
                const double3 from = seam->from[j];
                const double3 to = seam->to[j];
                seam->from[j] = seam->from[i + 1];
                seam->to[j] = seam->to[i + 1];
                seam->from[i + 1] = from;
                seam->to[i + 1] = to;
                break;
            }
            continue;
        }
        const uint corners = i + 1 - begin;
        if (corners >= 3) { // others have no area
            if (p->faces == SLOW_FACES) return false;
            for (uint k = 0; k < corners; ++k) p->corner[p->faces][k] = seam->from[begin + k];
            p->corners[p->faces++] = corners;
        }
        begin = i + 1;
    }
    return true;
}

/// False where there is no room.
bool clip(Polyhedron* p, HalfSpace h)
{
    // A corner that lies beyond h by less than this does so by rounding.
    const double radius = sqrt(p->squared_radius);
    const double limit = h.offset + 0x1p-49 * radius;
    bool is_cut = false;
    for (uint f = 0; f < p->faces && !is_cut; ++f) {
        for (uint i = 0; i < p->corners[f]; ++i) is_cut |= dot_product(h.normal, p->corner[f][i]) > limit;
    }
    if (!is_cut) return true;

    Seam seam;
    seam.count = 0;
    uint faces = 0;
    for (uint f = 0; f < p->faces; ++f) {
        const uint corners = clip_polygon(p->corner[f], p->corners[f], h, &seam);
        if (corners > SLOW_CORNERS) return false;
        if (corners < 3) continue;
        if (faces != f) {
            for (uint i = 0; i < corners; ++i) p->corner[faces][i] = p->corner[f][i];
        }
        p->corners[faces++] = corners;
    }
    p->faces = faces;
    if (!add_seam(p, &seam)) return false;
    p->squared_radius = 0;
    for (uint f = 0; f < p->faces; ++f) {
        for (uint i = 0; i < p->corners[f]; ++i) {
            p->squared_radius = fmax(p->squared_radius, dot_product(p->corner[f][i], p->corner[f][i]));
        }
    }
    return true;
}

/// Adds the tetrahedron of the site and three positions.
void add_tetrahedron(double3 p, double3 q, double3 r, VoronoiCell* cell)
{
    const double volume = dot_product(p, cross_product(q, r)) / 6;
    const double3 sum = p + q + r;
    cell->volume += volume;
    cell->moment += volume / 4 * sum;
    cell->energy += volume / 20 * (dot_product(sum, sum) + dot_product(p, p) + dot_product(q, q) + dot_product(r, r));
}

/// The plane of a face: positions are origin + x * first + y * second.
typedef struct
{
    double3 origin, first, second;
    double squared_radius; // of a disk around the origin that holds the face
    int last_shell;        // of the points that matter
    uint number;           // of the face's point, in the order of shells
} FacePlane;

/// The positions (x, y) in the plane of a face with x * normal.x + y * normal.y <= offset.
typedef struct
{
    double2 normal;
    double offset;
    uint number;
} HalfPlane;

HalfPlane half_plane_of(const FacePlane* plane, HalfSpace h, uint number)
{
    return (HalfPlane){(double2)(dot_product(h.normal, plane->first), dot_product(h.normal, plane->second)),
                       h.offset - dot_product(h.normal, plane->origin), number};
}

/// An edge on the border of a half-plane: border + t * direction.
typedef struct
{
    HalfPlane line;
    double low, high;
} Edge;

double2 direction_of(const HalfPlane* h) { return (double2)(-h->normal.y, h->normal.x); }

void clip_edge(Edge* e, HalfPlane h)
{
    const double2 n = e->line.normal;
    const double2 m = h.normal;
    const double cross = n.x * m.y - n.y * m.x;
    const double length = n.x * n.x + n.y * n.y;
    if (cross == 0) {
        const double along = n.x * m.x + n.y * m.y;
        const double excess = e->line.offset * along - h.offset * length;
        // If several lines are equal, the first counts.
        if (excess > 0 || (excess == 0 && along > 0 && h.number < e->line.number)) e->high = -INFINITY;
        return;
    }
    // The same position, bit for bit, when the lines change places: no edge is counted twice.
    const double x = (e->line.offset * m.y - h.offset * n.y) / cross;
    const double y = (n.x * h.offset - m.x * e->line.offset) / cross;
    const double t = (y * n.x - x * n.y) / length;
    if (cross > 0) {
        e->high = fmin(e->high, t);
    } else {
        e->low = fmax(e->low, t);
    }
}

#define HALF_SPACE_BEFORE ((HalfSpace){(double3)(-1, 0, 0), 0})
#define HALF_SPACE_AFTER ((HalfSpace){(double3)(1, 0, 0), 0})

/// Adds the part of a face between its origin and the edge with one other bisector.
void add_edge(const Surroundings* s, const FacePlane* plane, HalfPlane line, VoronoiCell* cell)
{
    const double squared = line.normal.x * line.normal.x + line.normal.y * line.normal.y;
    if (squared == 0) return;
    Edge e = {line, -sqrt(plane->squared_radius / squared), sqrt(plane->squared_radius / squared)};
    uint number = 2;
    if (s->has_twin_before && line.number != 0) clip_edge(&e, half_plane_of(plane, HALF_SPACE_BEFORE, 0));
    if (s->has_twin_after && line.number != 1) clip_edge(&e, half_plane_of(plane, HALF_SPACE_AFTER, 1));
    for (int shell = 0; shell <= plane->last_shell; ++shell) {
        FOR_EACH_IN_SHELL(s, shell, {
            const uint other = number++;
            if (other == plane->number || other == line.number) continue;
            clip_edge(&e, half_plane_of(plane, half_space_of(difference), other));
            if (!(e.low < e.high)) return;
        })
    }
    const double2 foot = line.normal * (line.offset / squared);
    const double2 from = foot + e.low * direction_of(&line);
    const double2 to = foot + e.high * direction_of(&line);
    add_tetrahedron(plane->origin, plane->origin + from.x * plane->first + from.y * plane->second,
                    plane->origin + to.x * plane->first + to.y * plane->second, cell);
}

/// Is a face behind that of another point, or the same and later in order?
bool is_hidden(const FacePlane* plane, HalfSpace other, uint number)
{
    const HalfPlane h = half_plane_of(plane, other, number);
    if (h.normal.x != 0 || h.normal.y != 0) return false;
    return h.offset < 0 || (h.offset == 0 && number < plane->number);
}

/// Adds the pyramid of a face: by its edges, each of which is what all other bisectors leave of a line.
void add_face_by_edges(const Surroundings* s, double3 face_difference, FacePlane plane, VoronoiCell* cell)
{
    const HalfSpace face = half_space_of(face_difference);
    axes_of(face.normal, &plane.first, &plane.second);
    plane.origin = 0.5 * face_difference;
    uint number = 2;
    for (int shell = 0; shell <= plane.last_shell; ++shell) {
        FOR_EACH_IN_SHELL(s, shell, {
            const uint other = number++;
            if (other != plane.number && is_hidden(&plane, half_space_of(difference), other)) return;
        })
    }
    if (s->has_twin_before) add_edge(s, &plane, half_plane_of(&plane, HALF_SPACE_BEFORE, 0), cell);
    if (s->has_twin_after) add_edge(s, &plane, half_plane_of(&plane, HALF_SPACE_AFTER, 1), cell);
    number = 2;
    for (int shell = 0; shell <= plane.last_shell; ++shell) {
        FOR_EACH_IN_SHELL(s, shell, {
            const uint other = number++;
            if (other != plane.number) {
                add_edge(s, &plane, half_plane_of(&plane, half_space_of(difference), other), cell);
            }
        })
    }
}

/// A cell inside a ball around the site, without limit to the number of faces and edges, in a time of the cube of the
/// number of points within twice the radius. Sets `is_known` to false where some of these may not be held.
VoronoiCell cell_by_edges(const Surroundings* s, double squared_radius, bool* is_known)
{
    VoronoiCell cell = {0, (double3)0, 0, 1};
    FacePlane plane;
    plane.squared_radius = 1.01 * squared_radius;
    plane.last_shell = 0;
    while (!(reach_of(s, plane.last_shell) > 2 * sqrt(squared_radius))) ++plane.last_shell;
    *is_known = plane.last_shell <= s->last_shell;
    if (!*is_known) return cell;
    uint number = 2;
    for (int shell = 0; shell <= plane.last_shell; ++shell) {
        FOR_EACH_IN_SHELL(s, shell, {
            plane.number = number++;
            if (!(dot_product(difference, difference) > 4.01 * squared_radius)) {
                add_face_by_edges(s, difference, plane, &cell);
            }
            cell.squared_near = fmin(cell.squared_near, dot_product(difference, difference));
        })
    }
    return cell;
}

/// The volume nearer to the site than to its own repetitions along the axes.
void start_with_box(const Surroundings* s, Polyhedron* p)
{
    p->faces = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (int side = -1; side <= 1; side += 2) {
            const double3 normal = (double3)(axis == 0 ? side : 0, axis == 1 ? side : 0, axis == 2 ? side : 0);
            const double3 u = 0.5 * (double3)(axis == 1, axis == 2, axis == 0);
            const double3 v = 0.5 * (double3)(axis == 2, axis == 0, axis == 1) * -side;
            p->corner[p->faces][0] = 0.5 * normal + u + v;
            p->corner[p->faces][1] = 0.5 * normal - u + v;
            p->corner[p->faces][2] = 0.5 * normal - u - v;
            p->corner[p->faces][3] = 0.5 * normal + u - v;
            p->corners[p->faces++] = 4;
        }
    }
    p->squared_radius = 0.75;
    if (s->has_twin_before) clip(p, HALF_SPACE_BEFORE);
    if (s->has_twin_after) clip(p, HALF_SPACE_AFTER);
}

/// Sets `is_known` to false, and returns any cell, where points that are not held may matter.
VoronoiCell cell_by_shells(const Surroundings* s, bool* is_known)
{
    VoronoiCell cell = {0, (double3)0, 0, 0};
    *is_known = true;
    if (s->has_twin_before && s->has_twin_after) return cell;

    Polyhedron p;
    start_with_box(s, &p);
    double squared_near = 1;
    for (int shell = 0; shell == 0 || !(reach_of(s, shell - 1) > 2 * sqrt(p.squared_radius)); ++shell) {
        if (shell > s->last_shell) {
            *is_known = false;
            return cell;
        }
        FOR_EACH_IN_SHELL(s, shell, {
            const double squared = dot_product(difference, difference);
            squared_near = fmin(squared_near, squared);
            const double squared_radius = p.squared_radius;
            if (squared < 4.0001 * squared_radius && !clip(&p, half_space_of(difference))) {
                cell = cell_by_edges(s, squared_radius, is_known);
                if (s->has_twin_before || s->has_twin_after) cell.squared_near = 0;
                return cell;
            }
        })
    }
    for (uint f = 0; f < p.faces; ++f) {
        for (uint i = 2; i < p.corners[f]; ++i) {
            add_tetrahedron(p.corner[f][0], p.corner[f][i - 1], p.corner[f][i], &cell);
        }
    }
    cell.squared_near = s->has_twin_before || s->has_twin_after ? 0 : squared_near;
    return cell;
}

/// The work-items share the sites of the list. `unknown` is set where points that are not held may matter.
kernel void find_centroids(global const double* positions, global const uint* ids, global const uint* starts,
                           struct GridPart part, global const uint* slow, global const uint* slow_count,
                           global double* volumes, global double* displacements, global double* energies,
                           global double* squared_near, global uint* unknown)
{
    const uint grid_size = part.grid_size;
    const uint count = *slow_count;
    for (uint i = get_global_id(0); i < count; i += get_global_size(0)) {
        const uint site = slow[i];
        const double3 position = vload3(site, positions);
        const int cell_x = min((int)(position.x * grid_size), (int)grid_size - 1);
        const int cell_y = min((int)(position.y * grid_size), (int)grid_size - 1);
        const int cell_z = min((int)(position.z * grid_size), (int)grid_size - 1);
        Surroundings s = {positions, ids,    starts, part, site, position, cell_x, cell_y, cell_z,
                          last_shell_of(&part, cell_z), false, false};
        const uint cell_number = place_of_cell(
            &part, (uint)cell_x + ((uint)cell_y + (uint)cell_z * grid_size) * grid_size);
        for (uint other = starts[cell_number]; other < starts[cell_number + 1]; ++other) {
            const double3 q = vload3(other, positions);
            if (q.x != position.x || q.y != position.y || q.z != position.z) continue;
            s.has_twin_before |= ids[other] < ids[site];
            s.has_twin_after |= ids[other] > ids[site];
        }
        bool is_known;
        const VoronoiCell cell = cell_by_shells(&s, &is_known);
        if (!is_known) atomic_or(unknown, 1u);
        store_cell(&cell, site, volumes, displacements, energies, squared_near);
    }
}

/// A single work-item.
kernel void forget_slow(global uint* slow_count, global uint* unknown)
{
    if (get_global_id(0) == 0) *slow_count = *unknown = 0;
}
