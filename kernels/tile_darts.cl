// Relaxation dart throwing around points that are there already, for a batch of tiles at once.
//
// McCool and Fiume 1992; Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3 to 4.6. Each work-group
// fills one torus of two tiles a side: darts that are in the allowed cells and not too near to any point become
// points; after `attempts` failures in a row the squared distance becomes the next of a list, `thresholds`. The
// work-items look at BATCH darts at once, at the least distance that may hold for any of them; the first then settles
// them in order, so the result is that of throwing them one after the other. The plain twin is
// host/tile_construction/reference/tile_filling.cpp.
//
// Needs DIMENSION (2 or 3).

#include "kernels/common/philox.clh"
#include "kernels/common/tiles/tile_torus.clh"
#include "kernels/common/tiles/coarse_points.clh"

#define DARTS_AT_ONCE 8 // that are drawn as vectors

/// Draws darts `dart` to dart + DARTS_AT_ONCE - 1 of a stream: coordinates axis after axis, BATCH apart.
void draw_darts(uint dart, uint stream, const struct Darts* darts, local int* positions)
{
    EightBlocks random;
    random.word[0] = dart + (ulong8)(0, 1, 2, 3, 4, 5, 6, 7);
    random.word[1] = stream;
    random.word[2] = darts->attempt;
    random.word[3] = darts->zone;
    philox8(&random, (uint2)(darts->key_x, darts->key_y));
    for (int k = 0; k < DIMENSION; ++k) {
        const ulong8 offset = (random.word[k] & 0xffffffffu) * (ulong)darts->extent >> 32;
        vstore8((darts->low + convert_int8(offset)) & TORUS_MASK, 0, positions + k * BATCH);
    }
}

Position dart_at(local const int* positions, uint number)
{
    Position position;
    for (int k = 0; k < DIMENSION; ++k) position.c[k] = positions[k * BATCH + number];
    return position;
}

/// Sets `is_candidate` of darts that are drawn as vectors to 2 where they are not in the domain, else to 1.
void find_allowed(local const int* positions, const Zone* zone, local uchar* is_candidate)
{
#if DIMENSION == 2
    if (zone->corners == 0) {
        const int8 is_in = are_allowed(vload8(0, positions), vload8(0, positions + BATCH), (uint8)(uint)zone->cells,
                                       &zone->regions);
        vstore8(convert_uchar8(2 + is_in), 0, is_candidate);
        return;
    }
#endif
    for (uint i = 0; i < DARTS_AT_ONCE; ++i) {
        const Position position = dart_at(positions, i);
        is_candidate[i] = is_allowed(&position, zone) ? 1 : 2;
    }
}

/// The points of a torus, with images.
typedef struct
{
    global int* c; // axis after axis, `capacity` apart
    uint capacity;
    CoarsePoints coarse;
} DartPoints;

Position point_at(const DartPoints* points, uint entry)
{
    Position position;
    FOR_EACH_AXIS(k) position.c[k] = points->c[k * points->capacity + entry];
    return position;
}

/// All points at smaller squared distances are within these limits.
NearLimits limits_of_squared(uint squared) { return limits_of_ball((int)sqrt((float)squared) + 2); }

/// Is none of `count` points at a smaller squared distance? `limits`: limits_of_squared of it.
bool is_free(const DartPoints* points, uint count, const Position* position, uint squared, NearLimits limits)
{
    for (uint from = 0; from < count; from += POINTS_A_MASK) {
        for (uint mask = mask_near(&points->coarse, from, count, position, limits); mask != 0; mask &= mask - 1) {
            const Position other = point_at(points, from + lowest_bit(mask));
            if (squared_between(&other, position) < squared) return false;
        }
    }
    return true;
}

/// The state of a filling.
typedef struct
{
    uint points;
    uint level; // the squared distance's number in the list
    uint failures;
    uint darts;
} Filling;

/// Work-group g fills problem problems[g]. A problem has capacity ints for each axis in `points`; images of a point come
/// one after the other. counts: points there are, without images, before and after. levels: the level that was reached;
/// darts.levels: given up. all_coarse: room for coarse coordinates.
kernel void throw_tile_darts(struct Darts darts, global const uint* problems, global const uint* streams,
                             global const uint* thresholds, global const uint* targets,
                             global const uint* held_counts, global int* all_points, global short* all_coarse,
                             global uint* counts, global uint* levels)
{
    const uint capacity = darts.tori.capacity;
    const uint copies = darts.tori.copies;
    const uint level_count = darts.levels;
    const uint item = get_local_id(0);
    const uint items = get_local_size(0);
    const uint problem = problems[get_group_id(0)];
    const DartPoints points = {all_points + (ulong)problem * DIMENSION * capacity, capacity,
                               coarse_points_of(all_coarse, problem, capacity)};
    const Zone zone = zone_of(&darts.tori, points.c, held_counts[problem]);
    const uint stream = streams[problem];
    const uint target = targets[problem];

    local Filling filling;
    local uchar is_candidate[BATCH]; // 0: too near to a point; 1: may be free; 2: not in the domain
    local int positions[DIMENSION * BATCH];
    if (item == 0) {
        filling.points = counts[problem];
        filling.level = filling.failures = filling.darts = 0;
    }
    for (uint entry = item; entry < counts[problem] * copies; entry += items) {
        FOR_EACH_AXIS(k) put_coarse(&points.coarse, entry, points.c[k * capacity + entry], k);
    }
    barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    while (filling.points < target && filling.level < level_count && filling.darts < MAX_DARTS) {
        const uint first = filling.darts;
        const uint reachable = filling.level + (filling.failures + BATCH - 1) / darts.attempts;
        const uint least = thresholds[min(reachable, level_count - 1)];
        for (uint i = item * DARTS_AT_ONCE; i < BATCH; i += items * DARTS_AT_ONCE) {
            draw_darts(first + i, stream, &darts, positions + i);
            find_allowed(positions + i, &zone, is_candidate + i);
        }
        barrier(CLK_LOCAL_MEM_FENCE);
        const NearLimits limits = limits_of_squared(least);
        for (uint i = item; i < BATCH; i += items) {
            const Position position = dart_at(positions, i);
            if (is_candidate[i] == 2) continue;
            is_candidate[i] = is_free(&points, filling.points * copies, &position, least, limits);
        }
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
        if (item == 0) {
            Filling f = filling;
            for (uint i = 0; i < BATCH && f.points < target && f.level < level_count; ++i) {
                ++f.darts;
                if (is_candidate[i] == 2) continue; // not in the domain
                const Position position = dart_at(positions, i);
                if (is_candidate[i] == 1 &&
                    is_free(&points, f.points * copies, &position, thresholds[f.level],
                            limits_of_squared(thresholds[f.level]))) {
                    for (uint image = 0; image < copies; ++image) {
                        for (int k = 0; k < DIMENSION; ++k) {
                            const uint entry = f.points * copies + image;
                            points.c[k * capacity + entry] =
                                (position.c[k] + (int)(image >> k & 1) * TILE_UNITS) & TORUS_MASK;
                            put_coarse(&points.coarse, entry, points.c[k * capacity + entry], k);
                        }
                    }
                    ++f.points;
                    f.failures = 0;
                } else if (++f.failures == darts.attempts) {
                    f.failures = 0;
                    ++f.level;
                }
            }
            filling = f;
        }
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
    }
    if (item == 0) {
        counts[problem] = filling.points;
        levels[problem] = filling.points < target ? level_count : filling.level;
    }
}
