// Lloyd relaxation and repulsion of the free points of a batch of tiles at once.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 to 4.6: each work-group relaxes the points of one
// torus of two tiles a side. Points come in three runs: held ones (of pieces that are there already), active ones, and
// surroundings, which are held as well or, in Lloyd relaxation, move in cells of their own. Movements end where they
// would leave the allowed cells; with repulsion they slide along them. The plain twin is host/tile_construction/reference/tile_filling.cpp.
//
// Needs DIMENSION (2 or 3).

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/tiles/smallest_of_group.clh"
#include "kernels/common/tiles/tile_torus.clh"
#include "kernels/common/tiles/coarse_points.clh"
#include "kernels/common/tiles/limited_movement.clh"
#if DIMENSION == 2
#define DOUBLES 1
#include "kernels/common/reals.clh"
#include "kernels/common/voronoi/voronoi_2d.clh"
#include "kernels/common/voronoi/voronoi_2d_window.clh"
#include "kernels/common/voronoi/voronoi_2d_around.clh"
#include "kernels/common/voronoi/voronoi_2d_blocks.clh"
#else
#include "kernels/common/voronoi/voronoi_3d_window.clh"
#endif
#include "kernels/common/tiles/torus_windows.clh"
#include "kernels/common/tiles/whole_torus.clh"
#include "kernels/common/tiles/site_step.clh"
#if DIMENSION == 2
#include "kernels/common/tiles/batch_of_tile.clh"
#define SITES_TOGETHER BATCH_SITES
#else
#define SITES_TOGETHER 1
#endif

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
/// from all points or, where none has, the best one. Each point has a list of LIST_WORDS of those around it, `slack` farther than is needed, for
/// as long as movements cannot have brought in others. Points themselves end as the last iterate; surroundings that move
/// are kept as well.
kernel void relax_tiles(struct Relaxation relaxation, global const uint* problems, global const uint* counts,
                        global const uint* held_counts, global const uint* active_counts, global ushort* all_lists,
                        global int* all_points, global short* all_coarse, global double* all_doubles,
                        global int* all_moved, global int* all_kept, global uint* squared_kept)
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
    const CoarsePoints coarse = coarse_points_of(all_coarse, problem, capacity);
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
#if DIMENSION == 2
    const NearLimits limits = limits_of_ball(relaxation.listed + slack);
#else
    const NearLimits limits = limits_of_box(relaxation.listed + slack);
#endif
    const uint listed_end = (moving_end - first + SITES_TOGETHER - 1) / SITES_TOGETHER * SITES_TOGETHER;
    int moved_by = slack; // at most, since points were listed
    for (uint iteration = 0; iteration <= iterations; ++iteration) {
        if (2 * moved_by >= slack) {
            for (uint entry = item; entry < points.count; entry += items) {
                FOR_EACH_AXIS(k) put_coarse(&coarse, entry, points.c[k * capacity + entry], k);
            }
            barrier(CLK_GLOBAL_MEM_FENCE);
            for (uint i = item; i < listed_end; i += items) {
                const uint number = min(first + i, moving_end - 1); // the last one fills up a batch
                list_near(&points, &coarse, number * copies, limits, lists + i * LIST_WORDS);
            }
            barrier(CLK_GLOBAL_MEM_FENCE);
        }
        uint nearest = UINT_MAX;
        uint longest = 0;
        const bool finds = iteration < iterations;
        for (uint from = first + item * SITES_TOGETHER; from < moving_end; from += items * SITES_TOGETHER) {
            SiteStep steps[SITES_TOGETHER];
            global const ushort* own_lists = lists + (from - first) * LIST_WORDS;
            const uint count = min(moving_end - from, (uint)SITES_TOGETHER);
            for (uint k = 0; k < count; ++k) steps[k].is_found = steps[k].is_counted = steps[k].is_allowed = false;
#if DIMENSION == 2
            find_batch_steps(steps, from, count, &points, own_lists, relaxation.listed, end, finds, &zone,
                             &surrounding_zone, &nearest);
#endif
            for (uint k = 0; k < count; ++k) {
                const uint i = from + k;
                SiteStep* step = &steps[k];
                if (finds ? !step->is_found : !step->is_counted) {
                    find_step(step, i, &points, own_lists + k * LIST_WORDS, doubles, &relaxation, end, finds, &nearest);
                }
                if (!finds) continue;
                const Position position = point_at(&points, i * copies);
                const Zone* own_zone = i < end ? &zone : &surrounding_zone;
                const Position target = step->is_allowed
                                            ? end_of(&position, &step->movement)
                                            : allowed_end(&position, &step->movement, own_zone, false);
                const Position listed_at = coarse_position(&coarse, i * copies);
                longest = max(longest, squared_between(&target, &listed_at));
                put_point(&moved, i, target);
            }
        }
        nearest = smallest_of_group(nearest, values);
        longest = UINT_MAX - smallest_of_group(UINT_MAX - longest, values);
        moved_by = (int)sqrt((float)longest) + 4; // as coarse positions lack a bit
        if (relaxation.keeps_last ? iteration == iterations : nearest >= wanted || nearest > best || iteration == 0) {
            best = min(nearest, wanted);
            copy_points(&kept, &points, first, moving_end);
            if (item == 0) squared_kept[problem] = nearest;
        }
        if (iteration == iterations) break;
        copy_points(&points, &moved, first, moving_end);
        barrier(CLK_GLOBAL_MEM_FENCE);
        for (uint i = first + item; i < moving_end; i += items) put_double(doubles, &points, i);
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
