// Lloyd relaxation and repulsion of the free points of a batch of tiles at once.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 to 4.6: each work-group relaxes the points of one
// torus of two tiles a side. Points come in three runs: held ones (of pieces that are there already), active ones, and
// surroundings, which are held as well or, in Lloyd relaxation, move in cells of their own. Movements end where they
// would leave the allowed cells; with repulsion they slide along them. The plain twin is host/tile_construction/reference/tile_filling.cpp.
//
// Coordinates are whole units, so that all tests are exact; a torus is small enough to look at all of its points.
//
// Needs DIMENSION (2 or 3).

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/tiles/smallest_of_group.clh"
#include "kernels/common/tiles/tile_torus.clh"
#include "kernels/common/tiles/limited_movement.clh"
#if DIMENSION == 2
#include "kernels/common/voronoi/voronoi_2d.clh"
#else
#include "kernels/common/voronoi/voronoi_3d_window.clh"
#endif

#define MAX_LISTED (LIST_WORDS - 1)
#define NO_LIST 65535
#define UNIT_SHIFT 15 // units to 2^-32 of the torus
#define UNIT_LENGTH 0x1p-17 // of the torus' side

/// The positions of a torus' points: all images of a point one after the other, an array for each axis.
typedef struct
{
    global int* c;
    uint capacity;
    uint count;  // with images
    uint copies; // images of each point
} TorusPoints;

/// The points of a problem, which has `capacity` entries for each axis.
TorusPoints points_of(global int* all, uint problem, uint capacity, uint count, uint copies)
{
    const TorusPoints points = {all + (ulong)problem * DIMENSION * capacity, capacity, count * copies, copies};
    return points;
}

Position point_at(const TorusPoints* points, uint entry)
{
    Position position;
    for (int k = 0; k < DIMENSION; ++k) position.c[k] = points->c[k * points->capacity + entry];
    return position;
}

/// Replaces a point and all its images.
void put_point(const TorusPoints* points, uint number, Position position)
{
    for (uint image = 0; image < points->copies; ++image) {
        for (int k = 0; k < DIMENSION; ++k) {
            points->c[k * points->capacity + number * points->copies + image] =
                (position.c[k] + (int)(image >> k & 1) * TILE_UNITS) & TORUS_MASK;
        }
    }
}

uint smallest_lane(uint8 lanes)
{
    const uint4 four = min(lanes.lo, lanes.hi);
    return min(min(four.x, four.y), min(four.z, four.w));
}

/// Puts a point into a window.
ALWAYS_INLINE void put_into_window(Window* window, uint at, const TorusPoints* points, uint entry)
{
    window->x[at] = points->c[entry] << UNIT_SHIFT;
    window->y[at] = points->c[points->capacity + entry] << UNIT_SHIFT;
#if DIMENSION == 3
    window->z[at] = points->c[2 * points->capacity + entry] << UNIT_SHIFT;
#endif
    window->index[at] = entry;
}

/// Which of eight points have coordinates that are all less than `reach` from a position.
ALWAYS_INLINE int8 are_inside(const TorusPoints* points, uint from, const Position* position, int reach)
{
    int8 is_inside = (int8)(0, 1, 2, 3, 4, 5, 6, 7) + (int)from < (int8)(int)points->count;
    FOR_EACH_AXIS(k)
    {
        const int8 difference = vload8(0, points->c + k * points->capacity + from) - position->c[k];
        is_inside &= lengths_of((difference << 15) >> 15) < (uint8)(uint)reach;
    }
    return is_inside;
}

#define POINTS_A_MASK 32

/// The same for as many points as a word has bits: hits are rare, and whether eight have one is hard to predict.
ALWAYS_INLINE uint mask_inside(const TorusPoints* points, uint from, const Position* position, int reach)
{
    uint8 bits = 0;
    uint8 bit = (uint8)(1, 2, 4, 8, 16, 32, 64, 128);
    for (uint v = from; v < min(from + POINTS_A_MASK, points->count); v += LANES, bit <<= LANES) {
        bits |= as_uint8(are_inside(points, v, position, reach)) & bit;
    }
    const uint4 four = bits.lo | bits.hi;
    const uint2 two = four.lo | four.hi;
    return two.x | two.y;
}

/// The number of the lowest bit that is set.
ALWAYS_INLINE uint lowest_bit(uint bits) { return 31 - clz(bits & (0u - bits)); }

/// Collects the points whose coordinates are all less than `reach` from a position; count > MAX_POINTS: too many.
void gather_box(Window* window, const TorusPoints* points, const Position* position, int reach)
{
    uint count = 0;
    for (uint from = 0; from < points->count; from += POINTS_A_MASK) {
        uint eight = LANES; // points that were appended last, of those of the mask
        for (uint mask = mask_inside(points, from, position, reach); mask != 0; mask &= mask - 1) {
            const uint bit = lowest_bit(mask);
            if (bit / LANES != eight && count > MAX_POINTS - LANES) {
                window->count = MAX_POINTS + 1;
                return;
            }
            eight = bit / LANES;
            put_into_window(window, count++, points, from + bit);
        }
    }
    window->count = count;
}

/// Gathers the window from a list that has all of its points, in the list's order.
void gather_listed(Window* window, const TorusPoints* points, const Position* position, int reach,
                   global const ushort* list)
{
    // A length is less than `reach` where the difference, shifted by reach - 1, is less than 2 reach - 1 around the
    // torus. There is room for one more point that is not inside.
    const uint limit = (uint)(2 * reach - 1) << UNIT_SHIFT;
    uint count = 0;
    const uint end = list[0];
    for (uint i = 1; i <= end; ++i) {
        const uint entry = list[i];
        put_into_window(window, count, points, entry);
        uint is_inside = 1;
        FOR_EACH_AXIS(k)
        {
            const int low = position->c[k] - reach + 1;
            is_inside &= (uint)(points->c[k * points->capacity + entry] - low) << UNIT_SHIFT < limit;
        }
        count += is_inside;
    }
    window->count = count;
}

/// Lists the points in a box for gather_listed: their number, then the points. Too many: NO_LIST.
void list_box(const TorusPoints* points, const Position* position, int reach, global ushort* list)
{
    uint count = 0;
    for (uint from = 0; from < points->count; from += POINTS_A_MASK) {
        uint mask = mask_inside(points, from, position, reach);
        if (count + popcount(mask) > MAX_LISTED) {
            list[0] = NO_LIST;
            return;
        }
        for (; mask != 0; mask &= mask - 1) list[++count] = (ushort)(from + lowest_bit(mask));
    }
    list[0] = (ushort)count;
}

/// The squared distance of the nearest point of a window but the site.
uint nearest_of_window(const Window* window, const Position* position, uint site)
{
    uint nearest = UINT_MAX;
    for (uint i = 0; i < window->count; ++i) {
        const int x = torus_difference_of((window->x[i] >> UNIT_SHIFT) - position->c[0]);
        const int y = torus_difference_of((window->y[i] >> UNIT_SHIFT) - position->c[1]);
        const uint a = min(abs(x), (uint)FAR_LENGTH);
        const uint b = min(abs(y), (uint)FAR_LENGTH);
        uint squared = a * a + b * b;
#if DIMENSION == 3
        const int z = torus_difference_of((window->z[i] >> UNIT_SHIFT) - position->c[2]);
        const uint c = min(abs(z), (uint)FAR_LENGTH);
        squared += c * c;
#endif
        nearest = min(nearest, window->index[i] == site ? UINT_MAX : squared);
    }
    return nearest;
}

/// Finds the displacement, in units, from the site to the centroid of its cell among the points of a window; returns
/// false if a larger window is needed.
bool find_centroid(const Window* window, const Position* position, uint site, int reach, double spacing,
                   global const double* doubles, double* displacement)
{
    VoronoiCell cell;
#if DIMENSION == 2
    const double2 at = (double2)(position->c[0], position->c[1]) * UNIT_LENGTH;
    Differences differences;
    Vertices vertices;
    const uint vectors = subtract_site(window, site, position->c[0] << UNIT_SHIFT, position->c[1] << UNIT_SHIFT,
                                       &differences);
    if (!cell_among(&differences, vectors, window, at, (global const double2*)doubles, &cell, &vertices)) return false;
    const float margin = (float)reach * (1 << UNIT_SHIFT) * (1 - 0x1p-16f);
    const Margins margins = {margin, margin, margin, margin};
    if (!is_complete(&vertices, margins) || !(cell.area > 0)) return false;
    displacement[0] = cell.moment.x / cell.area / UNIT_LENGTH;
    displacement[1] = cell.moment.y / cell.area / UNIT_LENGTH;
#else
    const double3 at = (double3)(position->c[0], position->c[1], position->c[2]) * UNIT_LENGTH;
    const double3 margin = reach * (UNIT_LENGTH * (1 - 0x1p-16));
    const double near_radius = min(1.8 * spacing, (double)reach) * UNIT_LENGTH * (1 - 0x1p-16);
    if (cell_in_window(window, position->c[0] << UNIT_SHIFT, position->c[1] << UNIT_SHIFT, position->c[2] << UNIT_SHIFT,
                       at, margin, margin, near_radius, doubles, &cell) != 0)
        return false;
    if (!(cell.volume > 0)) return false;
    displacement[0] = cell.moment.x / cell.volume / UNIT_LENGTH;
    displacement[1] = cell.moment.y / cell.volume / UNIT_LENGTH;
    displacement[2] = cell.moment.z / cell.volume / UNIT_LENGTH;
#endif
    return true;
}

void put_double(global double* doubles, const TorusPoints* points, uint number)
{
    for (uint entry = number * points->copies; entry < (number + 1) * points->copies; ++entry) {
        for (int k = 0; k < DIMENSION; ++k) {
            doubles[entry * DIMENSION + k] = points->c[k * points->capacity + entry] * UNIT_LENGTH;
        }
    }
}

/// Lloyd iterations. Work-group g owns problem problems[g]: `capacity` entries for each axis in all_points and others.
/// Keeps the last iterate or, without `keeps_last`, the last one whose active points have the wanted squared distance
/// from all points or, where none has, the best one. Where no reach is enough, a point stays. For the first box, each
/// point has a list of LIST_WORDS of the points in a box that is `slack` larger, for as long as movements cannot have
/// brought in others. Points themselves end as the last iterate; surroundings that move are kept as well.
kernel void relax_tiles(struct Relaxation relaxation, global const uint* problems, global const uint* counts,
                        global const uint* held_counts, global const uint* active_counts, global ushort* all_lists,
                        global int* all_points, global double* all_doubles, global int* all_moved,
                        global int* all_kept, global uint* squared_kept)
{
    const uint capacity = relaxation.tori.capacity;
    const uint copies = relaxation.tori.copies;
    const uint iterations = relaxation.iterations;
    const uint wanted = relaxation.wanted;
    const int slack = relaxation.slack;
    const uint item = get_local_id(0);
    const uint items = get_local_size(0);
    const uint problem = problems[get_group_id(0)];
    const TorusPoints points = points_of(all_points, problem, capacity, counts[problem], copies);
    const TorusPoints moved = points_of(all_moved, problem, capacity, 0, 1);
    const TorusPoints kept = points_of(all_kept, problem, capacity, 0, 1);
    global double* doubles = all_doubles + (ulong)problem * DIMENSION * capacity;
    const uint first = held_counts[problem];
    const uint end = first + active_counts[problem];
    const uint moving_end = relaxation.surrounding_cells == 0 ? end : counts[problem];
    const Zone zone = zone_of(&relaxation.tori, points.c, first);
    Zone surrounding_zone = zone;
    surrounding_zone.cells = relaxation.surrounding_cells;
    local uint values[MAX_ITEMS];

    global ushort* lists = all_lists + (ulong)problem * relaxation.max_moving * LIST_WORDS;

    for (uint i = item; i < counts[problem]; i += items) put_double(doubles, &points, i);
    barrier(CLK_GLOBAL_MEM_FENCE);
    uint best = 0;
    int moved_by = slack; // at most, along any axis, since points were listed
    for (uint iteration = 0; iteration <= iterations; ++iteration) {
        if (2 * moved_by >= slack) {
            for (uint i = first + item; i < moving_end; i += items) {
                const Position position = point_at(&points, i * copies);
                list_box(&points, &position, relaxation.reaches[0] + slack, lists + (i - first) * LIST_WORDS);
            }
            moved_by = 0;
        }
        uint nearest = UINT_MAX;
        uint longest = 0;
        for (uint i = first + item; i < moving_end; i += items) {
            const uint site = i * copies;
            const Position position = point_at(&points, site);
            global const ushort* list = lists + (i - first) * LIST_WORDS;
            Window window;
            double displacement[3] = {0, 0, 0};
            bool is_found = false;
            for (uint r = 0; r < relaxation.reach_count && !is_found; ++r) {
                if (r == 0 && list[0] != NO_LIST) {
                    gather_listed(&window, &points, &position, relaxation.reaches[0], list);
                } else {
                    gather_box(&window, &points, &position, relaxation.reaches[r]);
                }
                if (r == 0 && i < end) nearest = min(nearest, nearest_of_window(&window, &position, site));
                if (iteration == iterations || window.count > MAX_POINTS) break;
                if (window.count == 0) continue;
                is_found = find_centroid(&window, &position, site, relaxation.reaches[r], relaxation.spacing, doubles, displacement);
            }
            Position movement;
            for (int k = 0; k < DIMENSION; ++k) movement.c[k] = is_found ? rounded(displacement[k]) : 0;
            const Position target = allowed_end(&position, &movement, i < end ? &zone : &surrounding_zone, false);
            for (int k = 0; k < DIMENSION; ++k) {
                longest = max(longest, abs(torus_difference_of(target.c[k] - position.c[k])));
            }
            put_point(&moved, i, target);
        }
        nearest = smallest_of_group(nearest, values);
        moved_by += (int)(UINT_MAX - smallest_of_group(UINT_MAX - longest, values));
        if (relaxation.keeps_last ? iteration == iterations : nearest >= wanted || nearest > best || iteration == 0) {
            best = min(nearest, wanted);
            for (uint i = first + item; i < moving_end; i += items) put_point(&kept, i, point_at(&points, i * copies));
            if (item == 0) squared_kept[problem] = nearest;
        }
        if (iteration == iterations) break;
        for (uint i = first + item; i < moving_end; i += items) {
            put_point(&points, i, point_at(&moved, i));
            put_double(doubles, &points, i);
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}

#include "kernels/common/tiles/moment_step.clh"

/// The movement of a point by repulsion: away from all that are closer than `distance`, by what they lack of it, half
/// of it where the other moves as well. Lowers `nearest` to the squared distance of the nearest point.
Position repelled(const TorusPoints* points, const Position* position, uint site, uint first, uint end, double distance,
                  uint* nearest)
{
    double sum[DIMENSION];
    for (int k = 0; k < DIMENSION; ++k) sum[k] = 0;
    const uint limit = (uint)(distance * distance);
    uint8 nearest_of_lane = UINT_MAX;
    for (uint v = 0; v < points->count; v += 8) {
        const uint8 entry = (uint8)(0, 1, 2, 3, 4, 5, 6, 7) + v;
        const uint8 squared = select(squared_distances(points->c, points->capacity, points->count, v, position), (uint8)UINT_MAX, entry == site);
        nearest_of_lane = min(nearest_of_lane, squared);
        if (!any_of(squared <= limit)) continue;
        uint lanes[8];
        vstore8(squared, 0, lanes);
        for (uint i = 0; i < 8; ++i) {
            const uint other = v + i;
            if (lanes[i] > limit) continue;
            const double length = sqrt((double)lanes[i]);
            const uint number = other / points->copies;
            const double part = number >= first && number < end ? 0.5 : 1;
            const double push = part * (distance - length);
            if (lanes[i] == 0) {
                sum[0] += site < other ? -push : push;
                continue;
            }
            for (int k = 0; k < DIMENSION; ++k) {
                const int difference = torus_difference_of(points->c[k * points->capacity + other] - position->c[k]);
                sum[k] -= difference / length * push;
            }
        }
    }
    *nearest = min(*nearest, smallest_lane(nearest_of_lane));
    return limited_movement(sum, distance);
}

/// Repulsion, from what relax_tiles kept: until the wanted squared distance and the wanted moments are there, or for so
/// many passes; then the best is kept that has the moments, with its squared distance, or 0 where none has.
kernel void repel_tiles(struct Repulsion repulsion, global const uint* problems, global const uint* counts,
                        global const uint* held_counts, global const uint* active_counts,
                        global const uchar* exponents, global const long* wanted_moments, global int* all_points,
                        global int* all_moved, global int* all_kept, global uint* squared_kept)
{
    const uint capacity = repulsion.tori.capacity;
    const uint copies = repulsion.tori.copies;
    const uint passes = repulsion.passes;
    const uint item = get_local_id(0);
    const uint items = get_local_size(0);
    const uint problem = problems[get_group_id(0)];
    const TorusPoints points = points_of(all_points, problem, capacity, counts[problem], copies);
    const TorusPoints moved = points_of(all_moved, problem, capacity, 0, 1);
    const TorusPoints kept = points_of(all_kept, problem, capacity, 0, 1);
    const uint first = held_counts[problem];
    const uint end = first + active_counts[problem];
    const Zone zone = zone_of(&repulsion.tori, points.c, first);
    const Moments moments = {exponents, wanted_moments + (ulong)problem * repulsion.monomials, repulsion.monomials};
    local uint values[MAX_ITEMS];
    local MomentStep step;

    const uint moved_end = repulsion.surroundings_moved ? counts[problem] : end;
    for (uint i = first + item; i < moved_end; i += items) put_point(&points, i, point_at(&kept, i));
    barrier(CLK_GLOBAL_MEM_FENCE);
    uint best = 0;
    for (uint pass = 0; pass <= passes; ++pass) {
        uint nearest = UINT_MAX;
        for (uint i = first + item; i < end; i += items) {
            const Position position = point_at(&points, i * copies);
            const Position movement =
                repelled(&points, &position, i * copies, first, end, repulsion.distance, &nearest);
            put_point(&moved, i, allowed_end(&position, &movement, &zone, true));
        }
        nearest = smallest_of_group(nearest, values);
        if (!are_moments_near(&moments, &points, first, end, &step)) nearest = 0;
        if (pass == 0 || nearest > best) {
            best = nearest;
            for (uint i = first + item; i < end; i += items) put_point(&kept, i, point_at(&points, i * copies));
            if (item == 0) squared_kept[problem] = nearest;
        }
        if (nearest >= repulsion.wanted || pass == passes) break;
        for (uint i = first + item; i < end; i += items) put_point(&points, i, point_at(&moved, i));
        barrier(CLK_GLOBAL_MEM_FENCE);
        if (moments.count == 0) continue;
        find_moment_step(&moments, &points, first, end, &step);
        for (uint i = first + item; i < end; i += items) {
            const Position position = point_at(&points, i * copies);
            const Position movement = moment_movement(&moments, &position, &step, repulsion.distance);
            put_point(&points, i, allowed_end(&position, &movement, &zone, true));
        }
        barrier(CLK_GLOBAL_MEM_FENCE);
    }
}
