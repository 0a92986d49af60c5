// Settles a batch of dart throwing among its darts one after the other, as darts_in_order.cl does, where the grid consists
// of bricks.
//
//   settle_darts  takes the darts of a slab in the order of their times: a dart is rejected when an accepted one is too
//                 near, else accepted, and the cells around it are told of it
//
// A slab is a run of bricks, and a work-item's own. It knows nothing of darts in other bricks: its own darts whose windows
// reach these wait, unless one of its own darts rejects them, and so does every later dart that is too near to one that
// waits. What was decided is then what throwing all darts one by one would give, and a second launch, of one slab that has
// all bricks, settles the rest.
//
// Each brick has a word in `accepted` and one in `waiting`, with a bit for each of its cells: set where a dart of this
// batch was accepted, or waits.
//
// Needs what common/darts/dart_grid.clh needs, with BRICKS.

#include "kernels/common/darts/dart_grid.clh"

typedef struct
{
    uint first, end; // of its bricks
} Slab;

ALWAYS_INLINE bool has_brick(const Slab* slab, uint brick) { return slab->first <= brick && brick < slab->end; }
ALWAYS_INLINE bool sees(const Slab* slab, uint cell) { return has_brick(slab, cell / BRICK_CELLS); }

#include "kernels/common/darts/dart_order.clh"

#if DIMENSION == 2
// Bits of the cells of a brick along each axis.
constant ulong BITS_ALONG[2] = {0xff, 0x0101010101010101};
#else
constant ulong BITS_ALONG[3] = {0xf, 0x1111, 0x0001000100010001};
#endif

/// The bits of the cells low, ..., high of a brick along axis `k`, where the others are 0.
ALWAYS_INLINE ulong bits_between(int k, uint low, uint high)
{
    const uint step = 1u << (k * BRICK_BITS);
    return BITS_ALONG[k] >> step * (BRICK_SIDE - 1 - (high - low)) << step * low;
}

/// The parts of a window along an axis: in one brick, or in two.
typedef struct
{
    uint first, count; // from the brick before on
    ulong bits[2];
} Stretch;

ALWAYS_INLINE void find_stretch(int k, uint c, Stretch* stretch)
{
    // From the brick before on.
    const uint begin = c + BRICK_SIDE - REACH, end = c + BRICK_SIDE + REACH;
    stretch->first = begin >> BRICK_BITS;
    stretch->count = (end >> BRICK_BITS) - stretch->first + 1;
    const uint low = begin & (BRICK_SIDE - 1), high = end & (BRICK_SIDE - 1);
    stretch->bits[0] = bits_between(k, low, stretch->count == 1 ? high : BRICK_SIDE - 1);
    stretch->bits[1] = bits_between(k, 0, high);
}

/// The parts of the window around a dart's cell that bricks have, as bits.
typedef struct
{
    uint count;
    uint brick[1 << DIMENSION];
    ulong cells[1 << DIMENSION];
    bool leaves; // the slab
} Parts;

ALWAYS_INLINE void add_part(Parts* parts, const Slab* slab, uint brick, ulong bits)
{
    if (brick == NO_BRICK) return;
    parts->leaves |= !has_brick(slab, brick);
    parts->brick[parts->count] = brick;
    parts->cells[parts->count] = bits;
    parts->count += has_brick(slab, brick);
}

ALWAYS_INLINE void find_parts(const Cells* cells, const Spot* spot, const Slab* slab, Parts* parts)
{
    parts->count = 0;
    parts->leaves = false;
    Stretch along[DIMENSION];
    FOR_EACH_AXIS(k) find_stretch(k, spot->c[k], &along[k]);
    global const uint* around = &cells->around[spot->brick * BRICKS_AROUND];
    // Products of bits that differ along each axis have no carries.
#if DIMENSION == 3
    for (uint z = 0; z < along[2].count; ++z) {
        global const uint* layer = &around[9 * (along[2].first + z)];
        const ulong of_layer = along[2].bits[z];
#else
    {
        global const uint* layer = around;
        const ulong of_layer = 1;
#endif
        for (uint y = 0; y < along[1].count; ++y) {
            for (uint x = 0; x < along[0].count; ++x) {
                add_part(parts, slab, layer[3 * (along[1].first + y) + along[0].first + x],
                         along[0].bits[x] * along[1].bits[y] * of_layer);
            }
        }
    }
}

/// The number of the lowest bit that is set.
ALWAYS_INLINE uint lowest_bit(ulong bits) { return 63 - (uint)clz(bits & (0ul - bits)); }

/// Is the dart too near to one of this batch that was accepted in the slab?
ALWAYS_INLINE bool is_hit(const Position* dart, const Parts* parts, ulong squared_min_distance,
                          global const ulong* accepted, global const uint* positions)
{
    for (uint p = 0; p < parts->count; ++p) {
        for (ulong bits = accepted[parts->brick[p]] & parts->cells[p]; bits != 0; bits &= bits - 1) {
            const uint cell = parts->brick[p] * BRICK_CELLS + lowest_bit(bits);
            Position other;
            FOR_EACH_AXIS(k) other.c[k] = positions[cell * DIMENSION + k];
            if (squared_distance(&other, dart) < squared_min_distance) return true;
        }
    }
    return false;
}

/// The darts that wait in a slab: chains of them, one for each cell that has any.
typedef struct
{
    global ulong* bits;
    global uint* heads;
    global uint* next;
    global const ulong* keys;
} Waiting;

/// Is the dart too near to one that waits?
bool meets_waiting(const Position* dart, const Parts* parts, const Waiting* waiting, ulong squared_min_distance,
                   global const uint* darts)
{
    for (uint p = 0; p < parts->count; ++p) {
        for (ulong bits = waiting->bits[parts->brick[p]] & parts->cells[p]; bits != 0; bits &= bits - 1) {
            uint link = waiting->heads[parts->brick[p] * BRICK_CELLS + lowest_bit(bits)];
            for (; link != 0; link = waiting->next[link - 1]) {
                const Position other = position_of(darts, (uint)waiting->keys[link - 1]);
                if (squared_distance(&other, dart) < squared_min_distance) return true;
            }
        }
    }
    return false;
}

void let_wait(uint cell, const Waiting* waiting, uint at)
{
    global ulong* bits = &waiting->bits[cell / BRICK_CELLS];
    const ulong bit = 1ul << cell % BRICK_CELLS;
    waiting->next[at] = *bits & bit ? waiting->heads[cell] : 0;
    waiting->heads[cell] = at + 1;
    *bits |= bit;
}

/// Sets the mask bits that stand for the point in a cell, in all cells that its disk reaches. These are the slab's own:
/// the dart would wait otherwise.
ALWAYS_INLINE void mark_disk(const Position* point, const Spot* spot, const Cells* cells, uint torus_size, ulong step,
                             ulong squared_min_distance, global uint* masks)
{
    ulong gaps[DIMENSION][WINDOW];
    uint bricks[DIMENSION][WINDOW], in_brick[DIMENSION][WINDOW];
    uint power = 1;
    FOR_EACH_AXIS(k)
    {
        uint low = (uint)lower_bound(wrapped(torus_coordinate(cells, spot, k), -REACH, torus_size), 0, step);
        UNROLLED(int i = 0; i < WINDOW; ++i)
        {
            const uint c = torus_coordinate(cells, spot, k);
            const uint high = (uint)lower_bound((ulong)wrapped(c, i - REACH, torus_size) + 1, 0, step);
            gaps[k][i] = square(axis_nearest(point->c[k], low, high - low - 1));
            low = high;
            const uint from_before = spot->c[k] + BRICK_SIDE + i - REACH;
            bricks[k][i] = power * (from_before >> BRICK_BITS);
            in_brick[k][i] = (from_before & (BRICK_SIDE - 1)) << (k * BRICK_BITS);
        }
        power *= 3;
    }
    global const uint* around = &cells->around[spot->brick * BRICKS_AROUND];
    for (uint row = 0; row < MAX_NEAR / WINDOW; ++row) {
        const uint y = row % WINDOW;
        ulong gap = gaps[1][y];
        uint of_row = bricks[1][y], cells_of_row = in_brick[1][y];
#if DIMENSION == 3
        const uint z = row / WINDOW;
        gap += gaps[2][z];
        of_row += bricks[2][z];
        cells_of_row |= in_brick[2][z];
#endif
        if (gap >= squared_min_distance) continue;
        UNROLLED(int x = 0; x < WINDOW; ++x)
        {
            const uint brick = around[of_row + bricks[0][x]];
            if (brick == NO_BRICK || gap + gaps[0][x] >= squared_min_distance) continue;
            const uint cell = brick * BRICK_CELLS + (cells_of_row | in_brick[0][x]);
            const uint seen_from_there = MAX_NEAR - 1 - (row * WINDOW + x);
            masks[cell * MASK_WORDS + seen_from_there / 32] |= 1u << seen_from_there % 32;
        }
    }
}

/// One work-item owns one slab. Of the rest, `slabs.is_rest`, there is one slab, and its darts are undecided.
kernel void settle_darts(struct Slabs slabs, global const uint* darts, global uint* states, global uint* buckets,
                         global ulong* keys, global uint* next, global uint* heads, global ulong* accepted,
                         global ulong* waiting_bits, global uint* positions, global uint* points, global uint* counters,
                         struct GridPart part, ulong step, global uint* masks CELLS_PARAMETERS)
{
    CELLS_OF_PARAMETERS(0, part)
    const uint id = get_global_id(0);
    if (id >= slabs.slabs) return;
    const Slab slab = {(uint)((ulong)id * slabs.grid_size / slabs.slabs),
                       (uint)(((ulong)id + 1) * slabs.grid_size / slabs.slabs)};
    if (!slabs.is_rest) {
        for (uint brick = slab.first; brick < slab.end; ++brick) accepted[brick] = waiting_bits[brick] = 0;
    }
    const Waiting waiting = {waiting_bits, heads, next, keys};

    uint begin;
    const uint count =
        sort_darts(&slab, slabs, darts, states, &buckets[id << slabs.bucket_bits], keys, counters, &begin);
    for (uint at = begin; at < begin + count; ++at) {
        const uint dart = (uint)keys[at];
        const Position position = position_of(darts, dart);
        const uint cell = darts[dart * DART_WORDS + CELL_WORD];
        Spot spot;
        find_spot(&cells, cell, &spot);
        Parts parts;
        find_parts(&cells, &spot, &slab, &parts);
        uint state = REJECTED;
        if (!is_hit(&position, &parts, slabs.squared_min_distance, accepted, positions)) {
            const bool waits = slabs.slabs > 1 && (parts.leaves || meets_waiting(&position, &parts, &waiting,
                                                                                 slabs.squared_min_distance, darts));
            state = waits ? UNDECIDED : ACCEPTED;
            if (waits) {
                let_wait(cell, &waiting, at);
            } else {
                accepted[cell / BRICK_CELLS] |= 1ul << cell % BRICK_CELLS;
                const uint point = atomic_inc(&counters[POINTS]);
                FOR_EACH_AXIS(k) positions[cell * DIMENSION + k] = points[point * POINT_WORDS + k] = position.c[k];
                points[point * POINT_WORDS + TIME_WORD] = (uint)(keys[at] >> 32);
                mark_disk(&position, &spot, &cells, part.torus_size, step, slabs.squared_min_distance, masks);
            }
        }
        states[dart] = state;
    }
    if (slabs.slabs == 1) counters[OPEN_CELLS] = counters[DARTS] = counters[KEYS] = 0; // the last launch of the batch
}
