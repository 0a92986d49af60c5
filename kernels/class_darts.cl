// Dart throwing with classes: a distance for each pair of them.
//
// Wei, Multi-class blue noise sampling, 2010. The order in which classes get points is known beforehand: slot i is the
// place of the point that comes as number i, and its class. Each slot has darts of its own, and the first of them that
// is far enough from all points of slots before becomes its point:
//
//   find_darts          a work-item a slot: its first dart that no point of former batches rejects
//   settle_class_darts  a work-item: slot after slot, that dart if no point of this batch rejects it, else the first one
//                       after it that no point rejects
//   cover_cells         a work-item a cell: which of its children no single point's disk covers
//
// Darts fall into cells that may have room for their class, uniformly. When TRIES darts of a slot failed, the batch
// ends there, and the host refines these cells. With REGION darts that fall outside of a region of the plane are
// rejected, and so are cells that lie outside.
//
// Needs DIMENSION (2 or 3) and REGION (1 or 0; 1 in the plane alone; see common/regions/region.clh).

#define LARGE_DISKS 1

#include "kernels/common/darts/class_darts.h"
#include "kernels/common/philox.clh"
#include "kernels/common/torus.clh"
#include "kernels/common/regions/region.clh"

/// All points, with the grids of their classes.
typedef struct
{
    global const struct ClassPair* pairs; ///< of the class that is asked for, with all others
    global const struct ClassGrid* grids;
    global const uint* heads;
    global const uint* points;
    uint classes;
} ClassedPoints;

/// Cells of a grid along an axis.
typedef struct
{
    uint first;
    uint count;
} CellRange;

/// The cells in which coordinates from `low` - `reach` to `low` + `extent` + `reach` lie.
CellRange cells_around(uint low, uint extent, ulong reach, uint bits)
{
    const ulong cells = 1ul << bits;
    const ulong from = ((ulong)low + (1ul << 32) - reach) >> (32 - bits);
    const ulong to = ((ulong)low + (1ul << 32) + extent + reach) >> (32 - bits);
    CellRange range;
    range.count = (uint)min(to - from + 1, cells);
    range.first = (uint)(from & (cells - 1));
    return range;
}

Position point_at(global const uint* points, uint number)
{
    Position position;
    FOR_EACH_AXIS(k) position.c[k] = points[number * POINT_WORDS + k];
    return position;
}

/// The squared distance from a point to the farthest of low, low + 1, ..., low + extent along each axis.
ulong squared_farthest(const Position* point, const Position* low, uint extent)
{
    ulong sum = 0;
    FOR_EACH_AXIS(k) sum += square(axis_farthest(point->c[k], low->c[k], extent));
    return sum;
}

/// Returns true if the whole box is nearer to one point of a class than `pair` says. Points before number `since` do
/// not count; the points of a cell are linked from the last to the first.
bool is_covered_by(const ClassedPoints* all, struct ClassPair pair, const Position* low, uint extent, uint since)
{
    const struct ClassGrid grid = all->grids[pair.other];
    CellRange ranges[DIMENSION];
    FOR_EACH_AXIS(k) ranges[k] = cells_around(low->c[k], extent, pair.reach, grid.bits);
    const uint last = (1u << grid.bits) - 1;
#if DIMENSION == 3
    for (uint z = 0; z < ranges[2].count; ++z) {
        const uint slice = ((ranges[2].first + z) & last) << grid.bits;
#else
    {
        const uint slice = 0;
#endif
        for (uint y = 0; y < ranges[1].count; ++y) {
            const uint row = (slice | ((ranges[1].first + y) & last)) << grid.bits;
            for (uint x = 0; x < ranges[0].count; ++x) {
                const uint cell = row | ((ranges[0].first + x) & last);
                for (uint link = all->heads[grid.first + cell]; link > since;
                     link = all->points[(link - 1) * POINT_WORDS + NEXT_WORD]) {
                    const Position point = point_at(all->points, link - 1);
                    if (squared_farthest(&point, low, extent) < pair.squared) return true;
                }
            }
        }
    }
    return false;
}

/// Is the box nearer to one point of any class than the class's pair says, all of it?
bool is_covered(const ClassedPoints* all, const Position* low, uint extent, uint since)
{
    for (uint pair = 0; pair < all->classes; ++pair)
        if (is_covered_by(all, all->pairs[pair], low, extent, since)) return true;
    return false;
}

/// Is all of the box outside of the region? A position is known to be, a larger box that may cross it is not.
bool is_outside(const Region* region, const Position* low, uint extent)
{
    if (extent == 0) return !is_allowed_position(region, low);
    Position extents;
    FOR_EACH_AXIS(k) extents.c[k] = extent;
    return side_of_positions(region, low, &extents) == REGION_OUTSIDE;
}

/// Cells that may have room for classes, those of all lists.
typedef struct
{
    global const uint* places;
    global const uint* starts; ///< of each cell, the part of the density that cells before it have, in units of 2^-32
} ListedCells;

/// The cell of a list that has this part of the density.
uint cell_of_part(struct ClassCells list, global const uint* starts, uint part)
{
    uint low = 0, high = list.count;
    while (high - low > 1) {
        const uint middle = low + (high - low) / 2;
        if (starts[list.first + middle] <= part)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/// The darts of a slot of the batch.
typedef struct
{
    uint slot;
    uint own; ///< its class
    uint target;
    uint skipped;
    struct ClassCells list;
    uint2 key;
} SlotDarts;

/// A dart of a slot: somewhere in the cells of its class. Where these have a density, cells are in an order in which
/// neighbours are near each other, and the first darts fall into the interval of that order, of 2^spread units, that
/// has the slot's target, the next ones into intervals around it that are 4, 16, ... times as long, and the last ones
/// anywhere. Targets are evenly spread, so that the numbers of points follow the density although points reject each
/// other. When twice TRIES darts failed, the following ones fall uniformly.
Position dart_of(const SlotDarts* darts, uint tried, const ListedCells* cells)
{
    const struct ClassCells list = darts->list;
    const uint number = darts->skipped + tried;
    const uint4 words = philox((uint4)(darts->slot, number, darts->own, 0), darts->key);
    const uint offset[3] = {words.y, words.z, words.w};
    uint chosen = (uint)((ulong)words.x * list.count >> 32);
    if (list.spread > 0 && number < 2 * TRIES) {
        const uint bits = number < TRIES - TRIES_BEFORE ? min(32u, list.spread + 2 * (number / TRIES_BEFORE)) : 32;
        const uint random = (uint)((1ul << bits) - 1);
        chosen = cell_of_part(list, cells->starts, (darts->target & ~random) | (words.x & random));
    }
    chosen += list.first;
    Position dart;
    FOR_EACH_AXIS(k)
    {
        const ulong low = (ulong)cells->places[chosen * DIMENSION + k] << (32 - list.level);
        dart.c[k] = (uint)(low + ((ulong)offset[k] >> list.level));
    }
    return dart;
}

SlotDarts darts_of(struct SlotBatch batch, uint id, global const struct ClassSlot* slots,
                   global const struct ClassCells* lists)
{
    SlotDarts darts;
    darts.slot = batch.first + id;
    darts.own = slots[id].own;
    darts.target = slots[id].target;
    darts.skipped = id == 0 ? batch.skipped : 0;
    darts.list = lists[darts.own];
    darts.key = (uint2)(batch.key_x, batch.key_y);
    return darts;
}

/// The first dart from `number` on that lies in the region and that no point rejects; TRIES where there is none.
uint first_free(const SlotDarts* darts, uint number, const ClassedPoints* all, const ListedCells* cells,
                const Region* region)
{
    for (; number < TRIES; ++number) {
        const Position dart = dart_of(darts, number, cells);
        if (!is_outside(region, &dart, 0) && !is_covered(all, &dart, 0, 0)) break;
    }
    return number;
}

ClassedPoints points_for(uint own, struct SlotBatch batch, global const struct ClassPair* pairs,
                         global const struct ClassGrid* grids, global const uint* heads, global const uint* points)
{
    ClassedPoints all;
    all.pairs = &pairs[own * batch.classes];
    all.grids = grids;
    all.heads = heads;
    all.points = points;
    all.classes = batch.classes;
    return all;
}

/// candidates: the number of the dart.
kernel void find_darts(struct SlotBatch batch, global const struct ClassSlot* slots,
                       global const struct ClassPair* pairs,
                       global const struct ClassGrid* grids, global const struct ClassCells* lists,
                       global const uint* places, global const uint* starts, global const uint* heads,
                       global const uint* points, global uint* candidates REGION_PARAMETERS)
{
    const uint id = get_global_id(0);
    if (id >= batch.slots) return;
    REGION_OF_PARAMETERS
    const SlotDarts darts = darts_of(batch, id, slots, lists);
    const ClassedPoints all = points_for(darts.own, batch, pairs, grids, heads, points);
    const ListedCells cells = {places, starts};
    candidates[id] = first_free(&darts, 0, &all, &cells, &region);
}

void insert(const Position* position, uint number, uint own, struct ClassGrid grid, global uint* heads,
            global uint* points)
{
    uint cell = 0;
    for (int k = DIMENSION - 1; k >= 0; --k)
        cell = cell << grid.bits | (uint)((ulong)position->c[k] >> (32 - grid.bits));
    global uint* point = &points[number * POINT_WORDS];
    FOR_EACH_AXIS(k) point[k] = position->c[k];
    point[CLASS_WORD] = own;
    point[NEXT_WORD] = heads[grid.first + cell];
    heads[grid.first + cell] = number + 1;
}

/// One work-item.
kernel void settle_class_darts(struct SlotBatch batch, global const struct ClassSlot* slots,
                               global const struct ClassPair* pairs, global const struct ClassGrid* grids,
                               global const struct ClassCells* lists, global const uint* places,
                               global const uint* starts, global uint* heads,
                               global uint* points, global const uint* candidates,
                               global uint* counters REGION_PARAMETERS)
{
    if (get_global_id(0) != 0) return;
    REGION_OF_PARAMETERS
    const ListedCells cells = {places, starts};
    counters[REDRAWN] = 0;
    uint id = 0;
    for (; id < batch.slots; ++id) {
        const SlotDarts darts = darts_of(batch, id, slots, lists);
        const ClassedPoints all = points_for(darts.own, batch, pairs, grids, heads, points);
        uint number = candidates[id];
        if (number == TRIES) break;
        Position dart = dart_of(&darts, number, &cells);
        if (is_covered(&all, &dart, 0, batch.first)) {
            ++counters[REDRAWN];
            number = first_free(&darts, number + 1, &all, &cells, &region);
            if (number == TRIES) break;
            dart = dart_of(&darts, number, &cells);
        }
        insert(&dart, darts.slot, darts.own, grids[darts.own], heads, points);
    }
    counters[SETTLED] = id;
}

/// kept: for each cell of a list, a bit for each of its children at `level` that is neither covered nor outside of the
/// region; where they have that level already, for itself. Children are counted with bit k for the upper half along axis k.
kernel void cover_cells(struct SlotBatch batch, uint own, struct ClassCells list, uint level,
                        global const struct ClassPair* pairs, global const struct ClassGrid* grids,
                        global const uint* cells, global const uint* heads, global const uint* points,
                        global uint* kept REGION_PARAMETERS)
{
    const uint id = get_global_id(0);
    if (id >= list.count) return;
    REGION_OF_PARAMETERS
    const ClassedPoints all = points_for(own, batch, pairs, grids, heads, points);
    const bool is_split = level > list.level;
    const uint extent = (uint)((1ul << (32 - level)) - 1);
    uint bits = 0;
    for (uint child = 0; child < (is_split ? 1u << DIMENSION : 1u); ++child) {
        Position low;
        FOR_EACH_AXIS(k)
        {
            const ulong cell = cells[(list.first + id) * DIMENSION + k];
            low.c[k] = (uint)((is_split ? 2 * cell + (child >> k & 1) : cell) << (32 - level));
        }
        if (!is_outside(&region, &low, extent) && !is_covered(&all, &low, extent, 0)) bits |= 1u << child;
    }
    kept[id] = bits;
}
