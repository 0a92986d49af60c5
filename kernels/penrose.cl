// Points of a Penrose tiling: see host/tile_sampling/penrose/penrose_points.hpp. The plain twin,
// host/tile_sampling/penrose/reference/penrose_points.cpp, finds the same points in the same order.
//
// A work-item divides one triangle down to the level that the density asks for, twice: it counts its points first, and
// writes them where those of the triangles before end. Places are whole numbers throughout.
#include "kernels/common/tile_sampling/penrose.h"

constant long LAST = (1L << FRACTION_BITS) - 1;
constant int SHIFT = FRACTION_BITS - UNIT_BITS;

/// The ring's numbers: see tiles/penrose/penrose_tiles.hpp.
long4 times_phi(long4 a) { return (long4)(a.x + a.y - a.w, a.z + a.w, a.x + a.y, a.z + a.w - a.x); }

long4 unit_vector(uint tenths)
{
    const long4 first[5] = {(long4)(1, 0, 0, 0), (long4)(0, 1, 0, 0), (long4)(0, 0, 1, 0), (long4)(0, 0, 0, 1),
                            (long4)(-1, 1, -1, 1)};
    const long4 v = first[tenths % 5];
    return tenths < 5 ? v : -v;
}

long4 ring_place(struct Tile t) { return (long4)(t.place[0], t.place[1], t.place[2], t.place[3]); }

long4 second_corner(struct Tile t)
{
    const long4 side = unit_vector(t.direction / 2);
    return ring_place(t) + (t.kind >= FAT ? times_phi(times_phi(side)) : side);
}

long4 third_corner(struct Tile t)
{
    return ring_place(t) + times_phi(unit_vector((t.direction / 2 + (t.kind >= FAT ? 1 : 2)) % 10));
}

long2 fixed_place(long4 place, struct Request request, global const struct Scale* scale)
{
    return (long2)(request.root_x, request.root_y) + place.x * (long2)(scale->axis_x[0], scale->axis_y[0]) +
           place.y * (long2)(scale->axis_x[1], scale->axis_y[1]) +
           place.z * (long2)(scale->axis_x[2], scale->axis_y[2]) +
           place.w * (long2)(scale->axis_x[3], scale->axis_y[3]);
}

/// The nearest place of the density's square, in units of 2^-32.
uint2 in_square(long2 place) { return convert_uint2(clamp(place, (long2)(0), (long2)(LAST)) >> SHIFT); }

/// The pixel there.
uint2 pixel_at(uint2 place, struct Request request)
{
    return (uint2)(mul_hi(place.x, request.width), mul_hi(place.y, request.height));
}

/// The importance of a weight, which is full at 2^40: the product over 2^40, rounded down.
ulong importance_of(ulong weight, struct Request request) { return mul_hi(request.importance << 12, weight << 12); }

/// At least the largest weight between two places: see base/densities/density_bounds.hpp.
ulong largest_weight(uint2 low, uint2 high, struct Request request, global const ulong* weights)
{
    uint2 first = pixel_at(low, request), last = pixel_at(high, request);
    uint columns = request.width, rows = request.height;
    ulong begin = 0;
    while (last.x - first.x > 1 || last.y - first.y > 1) {
        begin += (ulong)columns * rows;
        columns = (columns + 1) / 2;
        rows = (rows + 1) / 2;
        first /= 2;
        last /= 2;
    }
    const ulong bottom = begin + (ulong)first.y * columns, top = begin + (ulong)last.y * columns;
    return max(max(weights[bottom + first.x], weights[bottom + last.x]),
               max(weights[top + first.x], weights[top + last.x]));
}

/// Tells whether a triangle can have points in the window that stay.
bool is_needed(struct Tile t, struct Request request, global const struct Scale* scales, global const ulong* weights)
{
    global const struct Scale* scale = scales + t.level;
    const long2 a = fixed_place(ring_place(t), request, scale), b = fixed_place(second_corner(t), request, scale),
                c = fixed_place(third_corner(t), request, scale);
    const long2 low = min(min(a, b), c), high = max(max(a, b), c);
    const long2 begin = (long2)(request.low_x, request.low_y) << SHIFT, end = begin + (request.side << SHIFT);
    if (any(high + scale->reach < begin) || any(low - scale->reach >= end)) return false;
    const long rounding = 1L << 26;
    const ulong weight = largest_weight(in_square(low - rounding), in_square(high + rounding), request, weights);
    return importance_of(weight, request) > scales[t.level + 1].ones[0];
}

uint structural_index(uint digits)
{
    const uint newest = digits & 3, before = digits >> 2 & 3, first = digits >> 4;
    return (newest == 2 ? 13 : newest * 8) + (before == 2 ? 5 : before * 3) + first;
}

/// Sets the place that a point is moved to, in units of 2^-32. False: it does not stay, or is outside of the window.
bool is_kept(struct Tile t, struct Request request, global const struct Scale* scales, global const int2* vectors,
             global const ulong* weights, long2* unit)
{
    const long2 corner = fixed_place(ring_place(t), request, scales + t.level);
    const uint2 pixel = pixel_at(in_square(corner), request);
    const ulong importance = importance_of(weights[(ulong)pixel.y * request.width + pixel.x], request);
    if (t.value >= importance) return false;
    uint level = t.level, row = 0;
    // The second condition is for idle lanes of llvmpipe's vectors, which read zeros.
    while (scales[level + 1].ones[0] < importance && level + 2 < SCALES) ++level;
    while (row + 1 < ROWS && scales[level].rows[row + 1] <= importance) ++row;
    const uint older = level - t.level;
    const uint index = structural_index(older < 3 ? t.digits << 2 * older & 63 : 0);
    const uint direction = (t.direction + older / 2 * 10) % TURNS, left = (direction + TURNS / 4) % TURNS;
    const long2 vector = convert_long2(vectors[row * INDICES + index]);
    global const struct Scale* scale = scales + level;
    const long2 place = corner + vector.x * (long2)(scale->turn_x[direction], scale->turn_y[direction]) +
                        vector.y * (long2)(scale->turn_x[left], scale->turn_y[left]);
    *unit = place >> SHIFT;
    const long2 inside = *unit - (long2)(request.low_x, request.low_y);
    return all(inside >= 0) && all(inside < request.side);
}

/// A child: turned by so many twentieths, with a pair of digits behind the code.
struct Tile child_of(struct Tile parent, uint kind, long4 place, uint turn, uint pair,
                     global const struct Scale* scales)
{
    struct Tile child;
    child.place[0] = place.x;
    child.place[1] = place.y;
    child.place[2] = place.z;
    child.place[3] = place.w;
    child.kind = kind;
    child.level = parent.level + 1;
    child.direction = (parent.direction + turn) % TURNS;
    child.digits = (parent.digits << 2 | pair) & 63;
    child.value = parent.value + (pair > 0 ? scales[child.level].ones[pair - 1] : 0);
    return child;
}

/// The triangles that a triangle is divided into. Returns their number; `point` is the new point, if there is one.
uint divide(struct Tile t, global const struct Scale* scales, struct Tile* triangles, struct Tile* point,
            bool* has_point)
{
    const long4 p1 = times_phi(ring_place(t)), p2 = times_phi(second_corner(t)), p3 = times_phi(third_corner(t));
    *has_point = t.kind != THIN_TWIN;
    if (t.kind == THIN) {
        triangles[0] = child_of(t, FAT_TWIN, p3, 14, 0, scales);
        triangles[1] = child_of(t, THIN, p2, 6, 2, scales);
        *point = child_of(t, POINT, third_corner(triangles[0]), 1, 2, scales);
        return 2;
    }
    if (t.kind == THIN_TWIN) {
        triangles[0] = child_of(t, FAT, p2, 6, 0, scales);
        triangles[1] = child_of(t, THIN_TWIN, third_corner(triangles[0]), 14, 2, scales);
        return 2;
    }
    if (t.kind == FAT) {
        triangles[0] = child_of(t, THIN, p3, 12, 2, scales);
        triangles[1] = child_of(t, FAT, p2, 8, 1, scales);
        triangles[2] = child_of(t, FAT_TWIN, p1, 0, 0, scales);
        *point = child_of(t, POINT, second_corner(triangles[0]), 7, 2, scales);
        return 3;
    }
    triangles[0] = child_of(t, FAT_TWIN, p3, 12, 1, scales);
    *point = child_of(t, POINT, third_corner(triangles[0]), 15, 1, scales);
    triangles[1] = child_of(t, FAT, third_corner(triangles[0]), 0, 0, scales);
    triangles[2] = child_of(t, THIN_TWIN, third_corner(triangles[1]), 8, 2, scales);
    return 3;
}

/// Counts the points of a triangle; writes them where `points` is not null.
uint points_of(struct Tile root, struct Request request, global const struct Scale* scales, global const int2* vectors,
               global const ulong* weights, global uint2* points)
{
    struct Tile waiting[WAITING];
    uint count = 0, size = 0;
    waiting[size++] = root;
    while (size > 0) {
        const struct Tile t = waiting[--size];
        if (!is_needed(t, request, scales, weights)) continue;
        struct Tile triangles[3], point;
        bool has_point;
        long2 unit;
        const uint number = divide(t, scales, triangles, &point, &has_point);
        if (has_point && is_kept(point, request, scales, vectors, weights, &unit)) {
            if (points) points[count] = convert_uint2(unit);
            ++count;
        }
        for (uint i = number; i-- > 0;) waiting[size++] = triangles[i]; // the first one is divided next
    }
    return count;
}

/// One work-item counts the points of one triangle.
kernel void count_points(struct Request request, global const struct Scale* scales, global const int2* vectors,
                         global const ulong* weights, global const struct Tile* tiles, global uint* counts)
{
    const uint id = get_global_id(0);
    if (id < request.tiles) counts[id] = points_of(tiles[id], request, scales, vectors, weights, 0);
}

/// One work-item writes the points of one triangle, in units of 2^-32.
kernel void write_points(struct Request request, global const struct Scale* scales, global const int2* vectors,
                         global const ulong* weights, global const struct Tile* tiles, global const uint* starts,
                         global uint2* points)
{
    const uint id = get_global_id(0);
    if (id < request.tiles) points_of(tiles[id], request, scales, vectors, weights, points + starts[id]);
}
