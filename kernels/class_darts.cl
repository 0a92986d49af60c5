// Dart throwing with classes: a distance for each pair of them.
//
// Wei, Multi-class blue noise sampling, 2010. The order in which classes get points is known beforehand: slot i is the
// place of the point that comes as number i, and its class. Each slot has darts of its own, and the first of them that
// is far enough from all points of slots before becomes its point:
//
//   find_darts          a work-item a slot: its first dart that no point of former batches rejects
//   settle_class_darts  a work-item: slot after slot, that dart if no point of this batch rejects it, else the first one
//                       after it that no point rejects
//   mark_cells          a work-item a slot: the small cells that its point covers get their bits
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
#include "kernels/common/darts/covered_cells.clh"
#include "kernels/common/regions/region.clh"

/// All points, with the grids of their classes.
typedef struct
{
    global const struct ClassPair* pairs; ///< of the class that is asked for, with all others
    global const struct ClassGrid* grids;
    global const uint* heads;
    global const uint* points;
    global const uint* covered; ///< bits of the cells that points cover, but for those of the batch
    struct CoveredCells covered_cells; ///< of the class that is asked for
    uint classes;
} ClassedPoints;

/// Cells of a grid along an axis.
typedef struct
{
    uint first;
    uint count;
    uint own; ///< the one of `low`, counted from the first
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
    range.own = (uint)min((((ulong)low + (1ul << 32)) >> (32 - bits)) - from, (ulong)range.count - 1);
    return range;
}

/// The cell that is looked at as number `visit`: that of `low` is first, as its points are the most likely to be near.
uint cell_of_visit(CellRange range, uint visit, uint last)
{
    const uint at = range.own + visit;
    return (range.first + (at < range.count ? at : at - range.count)) & last;
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
        const uint slice = cell_of_visit(ranges[2], z, last) << grid.bits;
#else
    {
        const uint slice = 0;
#endif
        for (uint y = 0; y < ranges[1].count; ++y) {
            const uint row = (slice | cell_of_visit(ranges[1], y, last)) << grid.bits;
            for (uint x = 0; x < ranges[0].count; ++x) {
                const uint cell = row | cell_of_visit(ranges[0], x, last);
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

/// The dart of a slot that four random words make: somewhere in the cells of its class. Where these have a density,
/// cells are in an order in which neighbours are near each other, and the first darts fall into the interval of that
/// order, of 2^spread units, that has the slot's target, the next ones into intervals around it that are 4, 16, ... times
/// as long, and the last ones anywhere. Targets are evenly spread, so that the numbers of points follow the density
/// although points reject each other. When twice TRIES darts failed, the following ones fall uniformly.
Position dart_of(const SlotDarts* darts, uint number, const uint words[4], const ListedCells* cells)
{
    const struct ClassCells list = darts->list;
    uint chosen = (uint)((ulong)words[0] * list.count >> 32);
    if (list.spread > 0 && number < 2 * TRIES) {
        const uint bits = number < TRIES - TRIES_BEFORE ? min(32u, list.spread + 2 * (number / TRIES_BEFORE)) : 32;
        const uint random = (uint)((1ul << bits) - 1);
        chosen = cell_of_part(list, cells->starts, (darts->target & ~random) | (words[0] & random));
    }
    chosen += list.first;
    Position dart;
    FOR_EACH_AXIS(k)
    {
        const ulong low = (ulong)cells->places[chosen * DIMENSION + k] << (32 - list.level);
        dart.c[k] = (uint)(low + ((ulong)words[k + 1] >> list.level));
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

enum
{
    DRAWN = 8 ///< darts that are drawn together, so that vectors hold them and memory answers for all of them at once
};

/// Draws the darts of a slot from `tried` on. Returns a bit for each that no bit of cells rejects.
uint draw_darts(const SlotDarts* darts, uint tried, const ClassedPoints* all, const ListedCells* cells,
                Position drawn[DRAWN])
{
    const uint number = darts->skipped + tried;
    const ulong8 lanes = (ulong8)(0, 1, 2, 3, 4, 5, 6, 7);
    EightBlocks blocks = {{(ulong8)(darts->slot), number + lanes, (ulong8)(darts->own), (ulong8)(0)}};
    philox8(&blocks, darts->key);
    uint words[4][DRAWN];
    for (int word = 0; word < 4; ++word) vstore8(convert_uint8(blocks.word[word] & 0xffffffffu), 0, words[word]);
    uint open = 0;
    for (uint i = 0; i < DRAWN; ++i) {
        const uint of_dart[4] = {words[0][i], words[1][i], words[2][i], words[3][i]};
        drawn[i] = dart_of(darts, number + i, of_dart, cells);
        open |= (uint)(state_of_cell(all->covered_cells, all->covered, &drawn[i]) != COVERED) << i;
    }
    return open;
}

/// Finds the first dart from `number` on that lies in the region and that no point rejects; returns its number, or TRIES
/// where there is none.
uint first_free(const SlotDarts* darts, uint number, const ClassedPoints* all, const ListedCells* cells,
                const Region* region, Position* found)
{
    Position drawn[DRAWN];
    for (; number < TRIES; number += DRAWN) {
        const uint open = draw_darts(darts, number, all, cells, drawn);
        for (uint i = 0; i < DRAWN && number + i < TRIES; ++i) {
            if (!(open >> i & 1) || is_outside(region, &drawn[i], 0) || is_covered(all, &drawn[i], 0, 0)) continue;
            *found = drawn[i];
            return number + i;
        }
    }
    return TRIES;
}

ClassedPoints points_for(uint own, struct SlotBatch batch, global const struct ClassPair* pairs,
                         global const struct ClassGrid* grids, global const uint* heads, global const uint* points,
                         global const struct CoveredCells* covered_cells, global const uint* covered)
{
    ClassedPoints all;
    all.pairs = &pairs[own * batch.classes];
    all.grids = grids;
    all.heads = heads;
    all.points = points;
    all.covered = covered;
    all.covered_cells = covered_cells[own];
    all.classes = batch.classes;
    return all;
}

/// candidates: of each slot, the number of its dart and the dart's coordinates.
kernel void find_darts(struct SlotBatch batch, global const struct ClassSlot* slots,
                       global const struct ClassPair* pairs,
                       global const struct ClassGrid* grids, global const struct ClassCells* lists,
                       global const uint* places, global const uint* starts, global const uint* heads,
                       global const uint* points, global const struct CoveredCells* covered_cells,
                       global const uint* covered, global uint* candidates REGION_PARAMETERS)
{
    const uint id = get_global_id(0);
    if (id >= batch.slots) return;
    REGION_OF_PARAMETERS
    const SlotDarts darts = darts_of(batch, id, slots, lists);
    const ClassedPoints all = points_for(darts.own, batch, pairs, grids, heads, points, covered_cells, covered);
    const ListedCells cells = {places, starts};
    Position dart;
    const uint number = first_free(&darts, 0, &all, &cells, &region, &dart);
    candidates[id * CANDIDATE_WORDS] = number;
    if (number < TRIES) FOR_EACH_AXIS(k) candidates[id * CANDIDATE_WORDS + 1 + k] = dart.c[k];
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
                               global uint* points, global const struct CoveredCells* covered_cells,
                               global const uint* covered, global const uint* candidates,
                               global uint* counters REGION_PARAMETERS)
{
    if (get_global_id(0) != 0) return;
    REGION_OF_PARAMETERS
    const ListedCells cells = {places, starts};
    counters[REDRAWN] = 0;
    uint id = 0;
    for (; id < batch.slots; ++id) {
        const SlotDarts darts = darts_of(batch, id, slots, lists);
        const ClassedPoints all = points_for(darts.own, batch, pairs, grids, heads, points, covered_cells, covered);
        uint number = candidates[id * CANDIDATE_WORDS];
        if (number == TRIES) break;
        Position dart;
        FOR_EACH_AXIS(k) dart.c[k] = candidates[id * CANDIDATE_WORDS + 1 + k];
        if (is_covered(&all, &dart, 0, batch.first)) {
            ++counters[REDRAWN];
            number = first_free(&darts, number + 1, &all, &cells, &region, &dart);
            if (number == TRIES) break;
        }
        insert(&dart, darts.slot, darts.own, grids[darts.own], heads, points);
    }
    counters[SETTLED] = id;
}

/// Marks the cells that the points of slots cover, those of the batch.
kernel void mark_cells(struct SlotBatch batch, global const struct ClassPair* pairs, global const uint* points,
                       global const struct CoveredCells* covered_cells, volatile global uint* covered)
{
    const uint id = get_global_id(0);
    if (id >= batch.slots) return;
    const uint number = batch.first + id;
    const Position point = point_at(points, number);
    global const struct ClassPair* of_point = &pairs[points[number * POINT_WORDS + CLASS_WORD] * batch.classes];
    for (uint i = 0; i < batch.classes; ++i) {
        const struct CoveredCells grid = covered_cells[of_point[i].other];
        if (grid.level > 0) mark_cells_of(grid, covered, &point, of_point[i].squared);
    }
}

/// kept: for each cell of a list, a bit for each of its children at `level` that is neither covered nor outside of the
/// region; where they have that level already, for itself. Children are counted with bit k for the upper half along axis k.
kernel void cover_cells(struct SlotBatch batch, uint own, struct ClassCells list, uint level,
                        global const struct ClassPair* pairs, global const struct ClassGrid* grids,
                        global const uint* cells, global const uint* heads, global const uint* points,
                        global const struct CoveredCells* covered_cells, global const uint* covered,
                        global uint* kept REGION_PARAMETERS)
{
    const uint id = get_global_id(0);
    if (id >= list.count) return;
    REGION_OF_PARAMETERS
    const ClassedPoints all = points_for(own, batch, pairs, grids, heads, points, covered_cells, covered);
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
        const uint state = state_of_box(all.covered_cells, covered, &low, extent, level);
        if (state == COVERED || is_outside(&region, &low, extent)) continue;
        if (state == NOT_COVERED || !is_covered(&all, &low, extent, 0)) bits |= 1u << child;
    }
    kept[id] = bits;
}
