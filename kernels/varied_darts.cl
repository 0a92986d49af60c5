// Dart throwing with distances that vary from place to place.
//
// Mitchell, Rand, Ebeida, Bajaj, Variable radii Poisson-disk sampling, CCCG 2012 (the smaller of both distances). Slot i
// is the place of the point that comes as number i. Each slot has darts of its own, and the first of them that keeps its
// distance from all points of slots before becomes its point:
//
//   look_at_cells         a work-item a cell: the least distance in it, and whether it may have room
//   find_varied_darts     a work-item a slot: its first dart that no point of former batches rejects
//   settle_varied_darts   a work-item: slot after slot, the first dart from there on that no point of this batch rejects
//
// Darts fall into the cells that may have room, with a density of 1 / distance^2. When a slot's tries failed, the batch
// ends there, and the host takes finer cells, or smaller distances.
//
// Points lie in squares that are as wide as twice the power of two below their distance, and these in buckets by a hash.

#define DIMENSION 2
#define LARGE_DISKS 1
#define REGION 1

#include "kernels/common/darts/varied_darts.h"
#include "kernels/common/philox.clh"
#include "kernels/common/torus.clh"
#include "kernels/common/darts/distance_field.clh"
#include "kernels/common/regions/inside_region.clh"

#define REGION_VALUES(region)                                                                                          \
    Region region;                                                                                                     \
    region.grid = region_grid;                                                                                         \
    region.cells = region_cells;                                                                                       \
    region.edges = region_edges;                                                                                       \
    region.filled = region_filled;

/// All that darts are held against.
typedef struct
{
    Field field;
    global const uint* heads;
    global const uint* points;
} Thrown;

ALWAYS_INLINE uint octave_of(uint distance) { return 31 - clz(max(distance, 1u)); }

/// The bucket of the square of an octave's points: squares have sides of 2^(octave + 1) positions.
ALWAYS_INLINE uint bucket_of(uint octave, uint column, uint row, uint buckets)
{
    uint hash = column * 0x9E3779B1u ^ row * 0x85EBCA77u ^ octave * 0xC2B2AE3Du;
    hash ^= hash >> 15;
    hash *= 0x2C1B3C6Du;
    return (hash ^ hash >> 13) & buckets;
}

/// The squared distance from a point to the farthest of low, low + 1, ..., low + extent along each axis.
ALWAYS_INLINE ulong squared_farthest(uint x, uint y, uint low_x, uint low_y, uint extent)
{
    return square(axis_farthest(x, low_x, extent)) + square(axis_farthest(y, low_y, extent));
}

/// Is a box, whose least distance is known, nearer than what is kept to one point of an octave, from number `from` on,
/// all of it? Buckets have the latest points first.
bool is_covered_by_octave(const Thrown* all, uint octave, uint from, uint x, uint y, uint extent, uint scaled)
{
    const Field* field = &all->field;
    const ulong reach = (twice_kept(field, scaled, scaled_distance(field, 2u << octave)) + 1) / 2;
    const uint middle_x = x + extent / 2, middle_y = y + extent / 2, last = 0xffffffffu >> (octave + 1);
    const uint first_x = (uint)(middle_x - reach) >> (octave + 1), first_y = (uint)(middle_y - reach) >> (octave + 1);
    const ulong most = min(2 * reach, (1ul << 32) - 1);
    const uint count_x = (uint)min((((middle_x - (uint)reach) & ((2u << octave) - 1)) + most) >> (octave + 1), (ulong)last);
    const uint count_y = (uint)min((((middle_y - (uint)reach) & ((2u << octave) - 1)) + most) >> (octave + 1), (ulong)last);
    for (uint j = 0; j <= count_y; ++j) {
        for (uint i = 0; i <= count_x; ++i) {
            uint link = all->heads[bucket_of(octave, (first_x + i) & last, (first_y + j) & last, field->rule.buckets)];
            while (link > from) {
                const uint4 point = vload4(link - 1, all->points);
                const ulong squared = squared_farthest(point.x, point.y, x, y, extent);
                if (is_nearer(squared, twice_kept(field, scaled, scaled_distance(field, point.z)))) return true;
                link = point.w;
            }
        }
    }
    return false;
}

/// Is a box nearer than what is kept to one point of any octave, from number `from` on, all of it?
bool is_covered(const Thrown* all, uint from, uint x, uint y, uint extent, uint distance)
{
    const struct DistanceRule* rule = &all->field.rule;
    const uint scaled = scaled_distance(&all->field, distance);
    const ulong below = (ulong)distance * rule->below >> 16, above = ((ulong)distance * rule->above >> 16) + SPARE;
    const uint least = max(rule->least, (uint)(below > SPARE ? below - SPARE : 0));
    const uint most = (uint)min((ulong)rule->most, above);
    const uint last = octave_of(most);
    for (uint octave = octave_of(least); octave <= last; ++octave)
        if (is_covered_by_octave(all, octave, from, x, y, extent, scaled)) return true;
    return false;
}

/// A cell's side over a distance, in units of 2^-(QUOTIENT_BITS + fineness): at most 2^QUOTIENT_BITS, as no distance in
/// the cell is less than its side, but for single positions. The square is the part of darts that count.
ALWAYS_INLINE ulong quotient_of(uint bits, uint fineness, uint distance)
{
    return min((1ul << (bits + QUOTIENT_BITS + fineness)) / distance, 1ul << QUOTIENT_BITS);
}

/// Does a dart of a cell count, at a place with this distance?
ALWAYS_INLINE bool counts(uint random, uint bits, uint fineness, uint distance)
{
    const ulong quotient = quotient_of(bits, fineness, distance);
    return random < quotient * quotient >> (2 * QUOTIENT_BITS - 32);
}

/// The darts of a batch.
typedef struct
{
    struct VariedBatch batch;
    Region region;
    global const struct OpenCell* cells;
} Darts;

/// A dart: x, y, its distance; that is 0 where it does not count. All cells have as many darts, and those that count have
/// a density of 1 / distance^2.
uint4 draw_dart(const Darts* darts, const Field* field, uint slot, ulong number)
{
    const uint4 words = philox((uint4)(slot, (uint)number, (uint)(number >> 32), 0),
                               (uint2)(darts->batch.key_x, darts->batch.key_y));
    const struct OpenCell cell = darts->cells[(uint)((ulong)words.x * darts->batch.cells >> 32)];
    uint4 dart;
    dart.x = cell.x + (uint)((ulong)words.z >> (32 - cell.bits));
    dart.y = cell.y + (uint)((ulong)words.w >> (32 - cell.bits));
    dart.z = 0;
    dart.w = 0;
    // Most that do not count are known by the least distance in the cell.
    if (!counts(words.y, cell.bits, darts->batch.fineness, cell.least)) return dart;
    const uint distance = distance_at(field, dart.x, dart.y);
    if (counts(words.y, cell.bits, darts->batch.fineness, distance) && is_in_region(&darts->region, dart.xy))
        dart.z = distance;
    return dart;
}

/// The first dart of a slot from `number` on that no point rejects; `tries` where there is none.
uint first_free(const Darts* darts, const Thrown* all, uint slot, ulong skipped, uint number)
{
    for (; number < darts->batch.tries; ++number) {
        const uint4 dart = draw_dart(darts, &all->field, slot, skipped + number);
        if (dart.z != 0 && !is_covered(all, 0, dart.x, dart.y, 0, dart.z)) break;
    }
    return number;
}

#define THROWN_VALUES(all)                                                                                             \
    Thrown all;                                                                                                        \
    all.field.rule = rule;                                                                                             \
    all.field.nodes = nodes;                                                                                           \
    all.field.bounds = bounds;                                                                                         \
    all.heads = heads;                                                                                                 \
    all.points = points;

#define DART_VALUES(darts)                                                                                             \
    Darts darts;                                                                                                       \
    darts.batch = batch;                                                                                               \
    darts.region = region;                                                                                             \
    darts.cells = cells;

kernel void look_at_cells(struct DistanceRule rule, uint count, global const uint* nodes, global const uint* bounds,
                          global const uint* heads, global const uint* points,
                          global struct OpenCell* cells REGION_PARAMETERS)
{
    const uint id = get_global_id(0);
    if (id >= count) return;
    REGION_VALUES(region)
    THROWN_VALUES(all)
    const struct OpenCell cell = cells[id];
    const uint extent = (uint)((1ul << cell.bits) - 1);
    uint least = 0;
    if (region_side(&region, (uint2)(cell.x, cell.y), (uint2)(extent, extent)) != REGION_OUTSIDE) {
        least = least_distance_in(&all.field, cell.x, cell.y, cell.bits);
        if (is_covered(&all, 0, cell.x, cell.y, extent, least)) least = 0;
    }
    cells[id].least = least;
}

/// candidates: the number of the dart.
kernel void find_varied_darts(struct DistanceRule rule, struct VariedBatch batch, global const uint* nodes,
                              global const uint* bounds, global const uint* heads, global const uint* points,
                              global const struct OpenCell* cells, global uint* candidates REGION_PARAMETERS)
{
    const uint id = get_global_id(0);
    if (id >= batch.slots) return;
    REGION_VALUES(region)
    THROWN_VALUES(all)
    DART_VALUES(darts)
    candidates[id] = first_free(&darts, &all, batch.first + id, id == 0 ? batch.skipped : 0, 0);
}

/// One work-item.
kernel void settle_varied_darts(struct DistanceRule rule, struct VariedBatch batch, global const uint* nodes,
                                global const uint* bounds, global uint* heads, global uint* points,
                                global const struct OpenCell* cells, global const uint* candidates,
                                global uint* counters REGION_PARAMETERS)
{
    if (get_global_id(0) != 0) return;
    REGION_VALUES(region)
    THROWN_VALUES(all)
    DART_VALUES(darts)
    uint id = 0, redrawn = 0;
    for (; id < batch.slots; ++id) {
        const uint slot = batch.first + id;
        const ulong skipped = id == 0 ? batch.skipped : 0;
        uint number = candidates[id];
        if (number == batch.tries) break;
        uint4 dart = draw_dart(&darts, &all.field, slot, skipped + number);
        if (is_covered(&all, batch.first, dart.x, dart.y, 0, dart.z)) {
            ++redrawn;
            number = first_free(&darts, &all, slot, skipped, number + 1);
            if (number == batch.tries) break;
            dart = draw_dart(&darts, &all.field, slot, skipped + number);
        }
        const uint octave = octave_of(dart.z);
        const uint bucket = bucket_of(octave, dart.x >> (octave + 1), dart.y >> (octave + 1), rule.buckets);
        dart.w = heads[bucket];
        vstore4(dart, slot, points);
        heads[bucket] = slot + 1;
    }
    counters[SETTLED] = id;
    counters[REDRAWN] = redrawn;
}
