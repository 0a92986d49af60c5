// Dart throwing on the torus in parallel, with the result of the sequential algorithm in dart order.
//
// Dissertation, section 4.2.4.1; the list of open cells after Ebeida et al. 2012. The plain twin of these kernels is
// host/sampling/reference/dart_throwing.cpp; host/sampling/dart_throwing.cpp runs them, batch after batch:
//   throw_darts  split the open cells, drop covered ones, draw darts in the others, keep those that no point of earlier
//                batches rejects
// and then those of darts_in_order.cl or of darts_in_rounds.cl, which settle the darts of the batch among themselves.
// Lists are filled through atomic counters, so their order may differ from run to run; no result depends on it.
//
// With REGION darts fall into a region of the plane or of space, whose coordinates are below half of the torus' along
// each axis: cells outside are closed, and darts outside are dropped.
//
// Cells of the grid are those of the torus, of a cube, or of bricks: see common/darts/dart_grid.clh.
//
// Needs what common/darts/dart_grid.clh needs, and REGION (1 or 0; see common/regions/region.clh).

#include "kernels/common/darts/dart_grid.clh"
#include "kernels/common/philox.clh"
#include "kernels/common/regions/region.clh"

#define CHILDREN (1 << DIMENSION)

#if BRICKS
#define IS_INSIDE (1u << 31) // of the last word of an open cell
#endif

// Points that can matter to a cell, padded so that they fill vectors of eight.
#define NEAR_ROOM ((MAX_NEAR + 7) / 8 * 8)

/// Points that can matter to the parents of a work-item. (The axes are not a power of two apart, which caches dislike.)
typedef struct
{
    uint c[DIMENSION][THROW_RUN * NEAR_ROOM + 16];
} Near;

/// An open cell that darts are thrown into, or whose children they are thrown into. Child c takes half (c >> k & 1)
/// along axis k. A cell that is not split is its own and only child, number 0.
typedef struct
{
    Cell cell;
    uint base;                 // the index of its level 0 cell
    uint near_begin, near_end; // the points that can matter to it
    uint open;                 // children, as bits
    uint crossed;              // children that lie partly outside the region, as bits
    bool is_inside;            // is known to be, and so its children
} Parent;

/// The box of a parent in two halves along each axis, or in one, number 0.
typedef struct
{
    uint low[DIMENSION][2];
    uint extent[DIMENSION][2]; // the box holds low, low + 1, ..., low + extent
} Halves;

ALWAYS_INLINE void halve(const Cell* cell, const struct Batch* batch, Halves* halves)
{
    const int level = batch->level - (int)batch->is_split;
    FOR_EACH_AXIS(k)
    {
        const ulong low = lower_bound(cell->c[k], level, batch->step);
        const ulong high = lower_bound((ulong)cell->c[k] + 1, level, batch->step);
        const ulong middle = batch->is_split ? lower_bound(2 * (ulong)cell->c[k] + 1, batch->level, batch->step) : high;
        halves->low[k][0] = (uint)low;
        halves->extent[k][0] = (uint)(middle - low - 1);
        halves->low[k][1] = (uint)middle;
        halves->extent[k][1] = (uint)(high - middle - 1);
    }
}

/// Is the position nearer to one of the points that can matter to the parent than the minimum distance?
ALWAYS_INLINE bool conflicts(const Position* position, const Parent* parent, const Near* near,
                             ulong squared_min_distance)
{
    for (uint i = parent->near_begin; i < parent->near_end; i += 8) {
        ulong8 sum = 0;
        FOR_EACH_AXIS(k)
        {
            const long8 difference = convert_long8(as_int8(vload8(0, &near->c[k][i]) - position->c[k]));
            sum += as_ulong8(difference * difference);
        }
        if (any(sum < squared_min_distance)) return true;
    }
    return false;
}

/// Squares of axis_farthest() of eight points.
ALWAYS_INLINE void squared_farthest(const uint* coordinates, uint low, uint extent, ulong8* squares)
{
    const uint8 forward = vload8(0, coordinates) - low;
    const uint8 back = forward - extent;
    uint8 farthest = max(min(forward, -forward), min(back, -back));
#if LARGE_DISKS
    const uint8 antipode = 0x80000000u;
    farthest = select(farthest, antipode, (forward ^ antipode) <= extent);
#endif
    *squares = convert_ulong8(farthest) * convert_ulong8(farthest);
}

/// Closes the children that one of the parent's points covers. Distances to the halves serve all children at once.
ALWAYS_INLINE void close_covered(Parent* parent, const Halves* halves, const Near* near, uint is_split,
                                 ulong squared_min_distance)
{
    for (uint i = parent->near_begin; i < parent->near_end && parent->open != 0; i += 8) {
        ulong8 squares[DIMENSION][2];
        FOR_EACH_AXIS(k) squared_farthest(&near->c[k][i], halves->low[k][0], halves->extent[k][0], &squares[k][0]);
        if (!is_split) {
            ulong8 sum = 0;
            FOR_EACH_AXIS(k) sum += squares[k][0];
            if (any(sum < squared_min_distance)) parent->open = 0;
            continue;
        }
        FOR_EACH_AXIS(k) squared_farthest(&near->c[k][i], halves->low[k][1], halves->extent[k][1], &squares[k][1]);
        long8 covered = 0;
        UNROLLED(uint c = 0; c < CHILDREN; ++c)
        {
            ulong8 sum = 0;
            FOR_EACH_AXIS(k) sum += squares[k][c >> k & 1];
            covered |= (sum < squared_min_distance) & (long)(1 << c);
        }
        const long4 folded = covered.lo | covered.hi;
        const long2 twice = folded.lo | folded.hi;
        parent->open &= ~(uint)(twice.lo | twice.hi);
    }
}

/// At the last level a box has one or two coordinates along each axis, and each is looked at, so that saturation is
/// exact.
bool has_room(const Parent* parent, const Halves* halves, const Near* near, const Region* region,
              ulong squared_min_distance)
{
    for (int corner = 0; corner < CHILDREN; ++corner) {
        Position position;
        FOR_EACH_AXIS(k) position.c[k] = halves->low[k][0] + ((corner >> k & 1) ? halves->extent[k][0] : 0u);
        if (!conflicts(&position, parent, near, squared_min_distance) && is_allowed_position(region, &position))
            return true;
    }
    return false;
}

/// Closes the children that lie outside the region, and finds those that are crossed by its edges.
ALWAYS_INLINE void close_outside(Parent* parent, const Halves* halves, const Region* region)
{
    parent->crossed = 0;
    if (parent->is_inside) return;
    for (uint open = parent->open; open != 0; open &= open - 1) {
        const uint c = 31 - clz(open & (0u - open));
        Position low, extent;
        FOR_EACH_AXIS(k)
        {
            low.c[k] = halves->low[k][c >> k & 1];
            extent.c[k] = halves->extent[k][c >> k & 1];
        }
        const uint side = side_of_positions(region, &low, &extent);
        if (side == REGION_OUTSIDE) parent->open &= ~(1u << c);
        if (side == REGION_CROSSED) parent->crossed |= 1u << c;
    }
}

/// The mask of a cell from word `w` on, as far as 64 bits hold it.
ALWAYS_INLINE ulong mask_part(global const uint* mask, uint w)
{
    return w + 1 < MASK_WORDS ? mask[w] | (ulong)mask[w + 1] << 32 : mask[w];
}

#if BRICKS

/// The cells of the window around a cell, for look_around(): each is looked for among the bricks.
typedef struct
{
    Spot spot;
} Window;

ALWAYS_INLINE void find_window(Parent* parent, const struct Batch* batch, const Cells* cells, Window* window)
{
    find_spot(cells, parent->base, &window->spot);
}

ALWAYS_INLINE uint cell_in_window(const Cells* cells, const Window* window, uint b)
{
    return cell_of_window(cells, &window->spot, b);
}

#else

/// The cells of the window around a cell, for look_around(): numbers follow from that of the window's first one where
/// the window does not leave the grid.
typedef struct
{
    Cell base;
    bool is_inside;
    uint corner;
} Window;

/// Finds the parent's level 0 cell as well.
ALWAYS_INLINE void find_window(Parent* parent, const struct Batch* batch, const Cells* cells, Window* window)
{
    const uint size = cells->size;
    window->is_inside = size > 2 * REACH;
    FOR_EACH_AXIS(k)
    {
        window->base.c[k] = cell_in_grid(parent->cell.c[k] >> (batch->level - (int)batch->is_split), k, &batch->part);
        window->is_inside &= window->base.c[k] - REACH < size - 2 * REACH;
    }
    parent->base = cell_index(&window->base, size);
    window->corner = parent->base - REACH * (DIMENSION == 2 ? size + 1 : (size + 1) * size + 1);
}

ALWAYS_INLINE uint cell_in_window(const Cells* cells, const Window* window, uint b)
{
    const uint row = b / WINDOW;
    const uint slice = DIMENSION == 2 ? 0 : row / WINDOW * (cells->size - WINDOW); // rows before it
    return window->is_inside ? window->corner + (slice + row) * cells->size + b % WINDOW
                             : window_cell(&window->base, b, cells->size);
}

#endif

/// Lists the points that can matter to the parent from number `begin` on, a multiple of eight. To fill the last eight,
/// the last point comes again.
ALWAYS_INLINE void look_around(Parent* parent, const struct Batch* batch, const Cells* cells, global const uint* masks,
                               global const uint* positions, uint begin, Near* near)
{
    Window window;
    find_window(parent, batch, cells, &window);
    uint end = begin;
    UNROLLED(uint w = 0; w < MASK_WORDS; w += 2)
    {
        for (ulong mask = mask_part(&masks[parent->base * MASK_WORDS], w); mask != 0; mask &= mask - 1) {
            const uint cell = cell_in_window(cells, &window, 32 * w + (63 - (uint)clz(mask & (0ul - mask))));
            FOR_EACH_AXIS(k) near->c[k][end] = positions[cell * DIMENSION + k];
            ++end;
        }
    }
    parent->near_begin = begin;
    parent->near_end = end;
    for (; end % 8 != 0; ++end) FOR_EACH_AXIS(k) near->c[k][end] = near->c[k][end - 1];
}

/// A list that throw_darts appends to: a part is staged in local memory, so that global counters are touched once a
/// work-group; when the staging area is full, entries go to global memory directly.
typedef struct
{
    local uint* staged;
    uint staged_capacity;
    local volatile uint* staged_count;
    global uint* target;
    uint target_capacity;
    global volatile uint* target_count;
    uint words;
} List;

/// The places of `count` entries of a list.
typedef struct
{
    uint staged, direct; // the first entry's number in either area
} Place;

Place reserve(const List* list, uint count)
{
    Place place;
    place.staged = atomic_add(list->staged_count, count);
    place.direct = 0;
    if (place.staged + count > list->staged_capacity) {
        // Entries beyond the staging area's end; the host sees the count and repeats the batch where they do not fit.
        place.direct = atomic_add(list->target_count, place.staged + count - max(place.staged, list->staged_capacity));
    }
    return place;
}

/// Writes entry number `number` of a place.
void put(const List* list, const Place* place, uint number, const uint* entry)
{
    const uint at = place->staged + number;
    if (at < list->staged_capacity) {
        for (uint w = 0; w < list->words; ++w) list->staged[at * list->words + w] = entry[w];
        return;
    }
    const uint direct = place->direct + (at - max(place->staged, list->staged_capacity));
    if (direct >= list->target_capacity) return;
    for (uint w = 0; w < list->words; ++w) list->target[direct * list->words + w] = entry[w];
}

/// Writes the cell that is a child of a parent.
ALWAYS_INLINE void put_cell(const List* list, const Place* place, uint number, const Cell* cell, const Parent* parent,
                            uint child)
{
#if BRICKS
    uint entry[PARENT_WORDS];
    FOR_EACH_AXIS(k) entry[k] = cell->c[k];
    entry[DIMENSION] = parent->base | (parent->crossed >> child & 1 ? 0 : IS_INSIDE);
    put(list, place, number, entry);
#else
    put(list, place, number, cell->c);
#endif
}

/// One word of the work-group's staged entries after the other, by all its work-items.
void copy_staged(const List* list, uint begin)
{
    const uint count = min(*list->staged_count, list->staged_capacity);
    if (begin + count > list->target_capacity) return;
    for (uint i = get_local_id(0); i < count * list->words; i += get_local_size(0)) {
        list->target[begin * list->words + i] = list->staged[i];
    }
}

/// Darts to draw, at most eight, then all at once.
typedef struct
{
    uint count;
    uint parent[8], number[8];
    ulong cell[DIMENSION][8];
} Pending;

/// Eight Philox blocks of the cells and the last counter words.
ALWAYS_INLINE void random_blocks(ulong cells[DIMENSION][8], const ulong8* last, const struct Batch* batch,
                                 EightBlocks* blocks)
{
    blocks->word[2] = 0;
    FOR_EACH_AXIS(k) blocks->word[k] = vload8(0, cells[k]);
    blocks->word[3] = *last;
    philox8(blocks, (uint2)(batch->key_x, batch->key_y));
}

/// lower_bound() of eight cells. (A macro: PoCL warns of functions that take vectors wider than registers.)
#define LOWER_BOUNDS(cells, batch)                                                                                     \
    (((cells) * ((batch)->step >> 32) + ((cells) * ((batch)->step & 0xffffffffu) >> 32)) >> (ulong)(batch)->level)

/// Draws the darts, and lists those that no point rejects.
ALWAYS_INLINE void draw(Pending* pending, const struct Batch* batch, const Parent* parents, const Near* near,
                        const Region* region, const List* darts)
{
    const ulong8 last = convert_ulong8(vload8(0, pending->number)) | (ulong)batch->number << 16;
    EightBlocks blocks;
    random_blocks(pending->cell, &last, batch, &blocks);
    uint times[8], places[DIMENSION][8];
    vstore8(convert_uint8(blocks.word[0]), 0, times);
    FOR_EACH_AXIS(k)
    {
        const ulong8 cells = vload8(0, pending->cell[k]);
        const ulong8 low = LOWER_BOUNDS(cells, batch);
        const ulong8 width = LOWER_BOUNDS(cells + 1, batch) - low;
        vstore8(convert_uint8(low + ((blocks.word[k + 1] & 0xffffffffu) * width >> 32)), 0, places[k]);
    }
    for (uint i = 0; i < pending->count; ++i) {
        const Parent* parent = &parents[pending->parent[i]];
        Position position;
        FOR_EACH_AXIS(k) position.c[k] = places[k][i];
        if (conflicts(&position, parent, near, batch->squared_min_distance)) continue;
        if (parent->crossed != 0 && !is_allowed_position(region, &position)) continue;
        uint dart[DART_WORDS];
        FOR_EACH_AXIS(k) dart[k] = position.c[k];
        dart[TIME_WORD] = times[i];
        dart[CELL_WORD] = parent->base;
        const Place place = reserve(darts, 1);
        put(darts, &place, 0, dart);
    }
    pending->count = 0;
}

/// Counts the darts of the children of eight parents: of child c, in counts[c % 4] of block c / 4. A uniform word of
/// theirs stands for as many as there are thresholds that it reaches.
ALWAYS_INLINE void count_darts(const struct Batch* batch, const Parent* parents, uint block,
                               constant const uint* thresholds, uint counts[4][8])
{
    ulong cells[DIMENSION][8];
    UNROLLED(uint i = 0; i < 8; ++i) FOR_EACH_AXIS(k) cells[k][i] = parents[i].cell.c[k];
    const ulong8 last = batch->number << 16 | (0xfffc + block);
    EightBlocks blocks;
    random_blocks(cells, &last, batch, &blocks);
    UNROLLED(uint w = 0; w < 4; ++w)
    {
        if (w > 0 && !batch->is_split) break;
        const uint8 word = convert_uint8(blocks.word[w]);
        int8 count = 0;
        for (uint t = 0; t < batch->thresholds; ++t) count -= word >= thresholds[t];
        vstore8(as_uint8(count), 0, counts[w]);
    }
}

/// The part of the grid that a work-item reads.
typedef struct
{
    global const uint* masks;
    global const uint* positions;
    Region region;
    Cells cells;
} Grid;

/// Takes open cell number `number` of the list. Bricks have the level 0 cell that it lies in there as well.
ALWAYS_INLINE void take_listed(Parent* parent, global const uint* listed, uint number)
{
    FOR_EACH_AXIS(k) parent->cell.c[k] = listed[number * PARENT_WORDS + k];
#if BRICKS
    parent->base = listed[number * PARENT_WORDS + DIMENSION] & ~IS_INSIDE;
    parent->is_inside = (listed[number * PARENT_WORDS + DIMENSION] & IS_INSIDE) != 0;
#endif
}

/// Finds the points around the parent, and which of its children are open.
ALWAYS_INLINE void look_at(Parent* parent, const struct Batch* batch, const Grid* grid, uint near_begin, Near* near)
{
    parent->open = batch->is_split ? (1u << CHILDREN) - 1 : 1u;
    look_around(parent, batch, &grid->cells, grid->masks, grid->positions, near_begin, near);
    Halves halves;
    halve(&parent->cell, batch, &halves);
    close_covered(parent, &halves, near, batch->is_split, batch->squared_min_distance);
    close_outside(parent, &halves, &grid->region);
    if (batch->is_last_level && parent->open != 0 &&
        !has_room(parent, &halves, near, &grid->region, batch->squared_min_distance)) {
        parent->open = 0;
    }
}

/// The side of all cells of level 0 of a work-item, which are a part of a brick.
ALWAYS_INLINE uint side_of_run(uint first, const struct Batch* batch, const Grid* grid)
{
    Spot spot, last_spot;
    find_spot(&grid->cells, first, &spot);
    find_spot(&grid->cells, first + THROW_RUN - 1, &last_spot);
    Position low, extent;
    FOR_EACH_AXIS(k)
    {
        const ulong begin = lower_bound(torus_coordinate(&grid->cells, &spot, k), 0, batch->step);
        const ulong end = lower_bound((ulong)torus_coordinate(&grid->cells, &last_spot, k) + 1, 0, batch->step);
        low.c[k] = (uint)begin;
        extent.c[k] = (uint)(end - begin - 1);
    }
    return side_of_positions(&grid->region, &low, &extent);
}

/// The lists that throw_darts makes.
typedef struct
{
    List cells, darts;
} Lists;

/// Lists the open children of the parents, whose number is `open_count`, and throws darts into them. Parents come in
/// eights; those beyond the last have no open children.
ALWAYS_INLINE void throw_into(const Parent* parents, uint count, uint open_count, const Near* near,
                              const Region* region, const struct Batch* batch, constant const uint* thresholds,
                              const Lists* lists)
{
    const bool lists_cells = BRICKS || batch->number > 0;
    const Place place = reserve(&lists->cells, lists_cells ? open_count : 0);
    uint listed = 0;
    Pending pending;
    pending.count = 0;
    UNROLLED(uint i = 0; i < 8; ++i)
    {
        pending.number[i] = 0;
        FOR_EACH_AXIS(k) pending.cell[k][i] = 0;
    }
    for (uint p = 0; p < count; p += 8) {
        for (uint block = 0; block < (DIMENSION == 3 && batch->is_split ? 2 : 1); ++block) {
            uint counts[4][8];
            count_darts(batch, &parents[p], block, thresholds, counts);
            for (uint q = 0; q < 8; ++q) {
                for (uint open = parents[p + q].open >> 4 * block & 15; open != 0; open &= open - 1) {
                    const uint in_block = 31 - clz(open & (0u - open));
                    const uint child = 4 * block + in_block;
                    Cell cell;
                    FOR_EACH_AXIS(k) cell.c[k] = (parents[p + q].cell.c[k] << batch->is_split) + (child >> k & 1);
                    if (lists_cells) put_cell(&lists->cells, &place, listed++, &cell, &parents[p + q], child);
                    for (uint number = 0; number < counts[in_block][q]; ++number) {
                        pending.parent[pending.count] = p + q;
                        pending.number[pending.count] = number;
                        FOR_EACH_AXIS(k) pending.cell[k][pending.count] = cell.c[k];
                        if (++pending.count == 8) draw(&pending, batch, parents, near, region, &lists->darts);
                    }
                }
            }
        }
    }
    if (pending.count > 0) draw(&pending, batch, parents, near, region, &lists->darts);
}

/// One work-item owns THROW_RUN open cells ("parents") in a row. Needs: masks and positions for all points of earlier
/// batches; counters OPEN_CELLS and DARTS zero.
///
/// `parent_cells` PARENT_WORDS words each, of the torus; in batch 0, and in batch 1 without bricks, not used: all cells
/// of the grid. Batch 0 also clears their slots and masks, and lists none as open, but for bricks, of which many are
/// outside. Local memory: staged_cells for PARENT_WORDS words each, staged_darts for DART_WORDS each, group for
/// GROUP_WORDS.
kernel void throw_darts(struct Batch batch, global const uint* parent_cells, global uint* masks, global uint* slots,
                        global const uint* positions, constant const uint* thresholds, global uint* open_cells,
                        global uint* darts, global uint* counters, local uint* staged_cells, local uint* staged_darts,
                        local uint* group REGION_PARAMETERS CELLS_PARAMETERS)
{
    REGION_OF_PARAMETERS
    CELLS_OF_PARAMETERS(batch.grid_size, batch.part)
    const Lists lists = {
        {staged_cells, batch.staged_capacity, &group[0], open_cells, batch.open_capacity, &counters[OPEN_CELLS],
         PARENT_WORDS},
        {staged_darts, batch.staged_capacity, &group[1], darts, batch.dart_capacity, &counters[DARTS], DART_WORDS}};
    if (get_local_id(0) == 0) group[0] = group[1] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);

    const uint first = min((uint)get_global_id(0) * THROW_RUN, batch.parents);
    const uint count = min((uint)THROW_RUN, batch.parents - first);
    const Grid grid = {masks, positions, region, cells};
    Parent parents[THROW_RUN];
    Near near;
    // Nearly all bricks have many cells outside.
    const uint side = BRICKS && batch.number == 0 && count > 0 ? side_of_run(first, &batch, &grid) : REGION_CROSSED;
    uint near_end = 0;
    uint open_count = 0;
    for (uint p = 0; p < count; ++p) {
        Parent* parent = &parents[p];
        parent->is_inside = side == REGION_INSIDE;
        if (batch.number < (BRICKS ? 1 : 2)) {
            parent->base = first + p;
            Spot spot;
            find_spot(&grid.cells, first + p, &spot);
            FOR_EACH_AXIS(k) parent->cell.c[k] = torus_coordinate(&grid.cells, &spot, k);
        } else {
            take_listed(parent, parent_cells, first + p);
        }
        if (batch.number == 0) {
            parent->near_begin = parent->near_end = 0;
            parent->open = side != REGION_OUTSIDE;
            Halves halves;
            halve(&parent->cell, &batch, &halves);
            close_outside(parent, &halves, &grid.region);
            slots[first + p] = 0;
            UNROLLED(uint w = 0; w < MASK_WORDS; ++w) masks[(first + p) * MASK_WORDS + w] = 0;
        } else {
            look_at(parent, &batch, &grid, near_end, &near);
            near_end = (parent->near_end + 7) / 8 * 8;
        }
        open_count += popcount(parent->open);
    }
    for (uint p = count; p % 8 != 0; ++p) {
        parents[p] = parents[0];
        parents[p].open = 0;
    }
    if (open_count > 0) throw_into(parents, count, open_count, &near, &grid.region, &batch, thresholds, &lists);

    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) {
        group[2] = atomic_add(&counters[OPEN_CELLS], min(group[0], batch.staged_capacity));
        group[3] = atomic_add(&counters[DARTS], min(group[1], batch.staged_capacity));
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    copy_staged(&lists.cells, group[2]);
    copy_staged(&lists.darts, group[3]);
}
