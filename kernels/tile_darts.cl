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
#include "kernels/common/tile_torus.clh"

#define BATCH 32
#define MAX_DARTS (1u << 22)

/// Dart number `dart` of a stream, in the box from `low` on, `extent` wide along each axis.
Position dart_at(uint dart, uint stream, uint attempt, uint zone, uint2 key, int low, uint extent)
{
    const uint4 words = philox((uint4)(dart, stream, attempt, zone), key);
    const uint word[3] = {words.x, words.y, words.z};
    Position position;
    for (int k = 0; k < DIMENSION; ++k) {
        position.c[k] = (low + (int)((ulong)word[k] * extent >> 32)) & TORUS_MASK;
    }
    return position;
}

/// Is no point at a smaller squared distance?
bool is_free(global const int* points, uint capacity, uint count, const Position* position, uint squared_distance)
{
    for (uint from = 0; from < count; from += LANES_OF_DISTANCES) {
        if (any(squared_distances(points, capacity, count, from, position) < squared_distance)) return false;
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

/// Work-group g fills problem problems[g]. A problem has capacity ints for each axis in `points`; images of a point
/// (see `copies`: 1, or 2^DIMENSION for the torus of one tile) come one after the other. counts: points there are,
/// without images, before and after. levels: the level that was reached; level_count: given up.
kernel void throw_tile_darts(global const uint* problems, global const uint* streams, uint attempt, uint zone,
                             uint key_x, uint key_y, uint capacity, uint copies, global const int* region_values,
                             ulong cells, int low, uint extent, global const uint* thresholds,
                             uint level_count, uint attempts, global const uint* targets, global int* all_points,
                             global uint* counts, global uint* levels)
{
    const uint item = get_local_id(0);
    const uint items = get_local_size(0);
    const uint problem = problems[get_group_id(0)];
    global int* points = all_points + (ulong)problem * DIMENSION * capacity;
    const Regions regions = regions_at(region_values);
    const uint2 key = (uint2)(key_x, key_y);
    const uint stream = streams[problem];
    const uint target = targets[problem];

    local Filling filling;
    local uchar is_candidate[BATCH];
    if (item == 0) {
        filling.points = counts[problem];
        filling.level = filling.failures = filling.darts = 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    while (filling.points < target && filling.level < level_count && filling.darts < MAX_DARTS) {
        const uint first = filling.darts;
        const uint reachable = filling.level + (filling.failures + BATCH - 1) / attempts;
        const uint least = thresholds[min(reachable, level_count - 1)];
        for (uint i = item; i < BATCH; i += items) {
            const Position position = dart_at(first + i, stream, attempt, zone, key, low, extent);
            is_candidate[i] = !is_allowed(&position, &regions, cells)                               ? 2
                              : is_free(points, capacity, filling.points * copies, &position, least) ? 1
                                                                                                     : 0;
        }
        barrier(CLK_LOCAL_MEM_FENCE | CLK_GLOBAL_MEM_FENCE);
        if (item == 0) {
            Filling f = filling;
            for (uint i = 0; i < BATCH && f.points < target && f.level < level_count; ++i) {
                ++f.darts;
                if (is_candidate[i] == 2) continue; // not in the domain
                const Position position = dart_at(first + i, stream, attempt, zone, key, low, extent);
                if (is_candidate[i] == 1 &&
                    is_free(points, capacity, f.points * copies, &position, thresholds[f.level])) {
                    for (uint image = 0; image < copies; ++image) {
                        for (int k = 0; k < DIMENSION; ++k) {
                            points[k * capacity + f.points * copies + image] =
                                (position.c[k] + (int)(image >> k & 1) * TILE_UNITS) & TORUS_MASK;
                        }
                    }
                    ++f.points;
                    f.failures = 0;
                } else if (++f.failures == attempts) {
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
