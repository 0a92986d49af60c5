// Settles a batch of dart throwing among its darts one after the other: for processors, whose few threads are faster so
// than with rounds.
//
//   settle_darts  takes the darts of a slab in the order of their times: a dart is rejected when an accepted one is too
//                 near, else accepted
//   mark_points   tells the cells around accepted darts of them
//
// A slab is a run of layers of level 0 cells along the last axis, and a work-item's own. It takes the darts of REACH
// layers on either side as well, without deciding about them: those that none of its own darts rejects wait, and so
// does every later dart that is too near to one that waits. What was decided is then what throwing all darts one by one
// would give, and a second launch, of one slab that is the whole torus, settles the rest.
//
// Beside the arrays of common/darts/dart_grid.clh, each row of level 0 cells has a bit in `accepted` for each of its cells:
// set where a dart of this batch was accepted. The first REACH cells come again after the last, and the last before the
// first, so that a window around any cell is a run of bits.
//
// Needs what common/darts/dart_grid.clh needs.

#include "kernels/common/darts/dart_grid.clh"

#define ROWS (MAX_NEAR / WINDOW) // of a window

// Rows of a window that a ulong has bits for.
#define ROWS_A_WORD (64 / WINDOW)
#define WINDOW_WORDS ((ROWS + ROWS_A_WORD - 1) / ROWS_A_WORD)

typedef struct
{
    uint first, layers; // that it owns
    uint ghosts;        // layers on either side that it looks at
    uint layer_cells;
    uint grid_size;
    uint row_words; // of `accepted`
} Slab;

Slab slab_at(uint id, uint slabs, uint grid_size, uint row_words)
{
    Slab slab;
    slab.first = (uint)((ulong)id * grid_size / slabs);
    slab.layers = (uint)(((ulong)id + 1) * grid_size / slabs) - slab.first;
    slab.ghosts = slabs == 1 ? 0 : REACH;
    slab.layer_cells = DIMENSION == 2 ? grid_size : grid_size * grid_size;
    slab.grid_size = grid_size;
    slab.row_words = row_words;
    return slab;
}

/// The number of a level 0 cell in the slab, whose ghosts come first; no less than slab_cells() for cells elsewhere.
uint number_in(const Slab* slab, uint cell)
{
    const uint ghosts = (slab->first >= slab->ghosts ? 0 : slab->grid_size) + slab->first - slab->ghosts;
    const uint begin = ghosts * slab->layer_cells;
    return cell - begin + (cell < begin ? slab->grid_size * slab->layer_cells : 0);
}

uint slab_cells(const Slab* slab) { return (slab->layers + 2 * slab->ghosts) * slab->layer_cells; }

/// Finds layer `layer` + `offset`, both counted from the slab's first own, among its own layers: in a slab that is the
/// whole torus, around it. Returns whether the slab owns it.
bool own_layer(const Slab* slab, int layer, int offset, uint* found)
{
    if (slab->ghosts == 0) {
        *found = wrapped((uint)layer, offset, slab->grid_size);
        return true;
    }
    const bool owns = (uint)(layer + offset) < slab->layers;
    *found = owns ? slab->first + (uint)(layer + offset) : slab->first;
    return owns;
}

/// A dart as the slab sees it: its layer is counted from the first that the slab owns.
typedef struct
{
    Position position;
    int layer;
    uint c[2]; // x and, in 3D, y of its cell
} Seen;

Seen seen_from(const Slab* slab, global const uint* darts, uint id)
{
    Seen dart;
    dart.position = position_of(darts, id);
    const uint number = number_in(slab, darts[id * DART_WORDS + CELL_WORD]);
    const uint layer = number / slab->layer_cells;
    const uint in_layer = number - layer * slab->layer_cells;
    dart.layer = (int)layer - (int)slab->ghosts;
    dart.c[1] = DIMENSION == 2 ? 0 : in_layer / slab->grid_size;
    dart.c[0] = in_layer - dart.c[1] * slab->grid_size;
    return dart;
}

uint row_of(const Slab* slab, uint layer, uint y) { return DIMENSION == 2 ? layer : layer * slab->grid_size + y; }

/// Is the dart too near to one of this batch that was accepted in the slab's own layers?
ALWAYS_INLINE bool is_hit(const Seen* dart, const Slab* slab, ulong squared_min_distance, global const uint* accepted,
                          global const uint* positions)
{
    // All bits of the window first, without branches: which rows have any is hard to predict.
    uint rows[ROWS];
    ulong bits[WINDOW_WORDS];
    UNROLLED(uint w = 0; w < WINDOW_WORDS; ++w) bits[w] = 0;
    uint y[WINDOW];
    UNROLLED(int i = 0; i < WINDOW; ++i) y[i] = wrapped(dart->c[1], i - REACH, slab->grid_size);
    UNROLLED(int l = 0; l < WINDOW; ++l)
    {
        uint layer;
        const ulong kept = own_layer(slab, dart->layer, l - REACH, &layer) ? (1u << WINDOW) - 1 : 0;
        UNROLLED(int i = 0; i < ROWS / WINDOW; ++i)
        {
            const int j = l * (ROWS / WINDOW) + i;
            rows[j] = row_of(slab, layer, y[i]);
            global const uint* words = &accepted[rows[j] * slab->row_words + dart->c[0] / 32];
            const ulong word = words[0] | (ulong)words[1] << 32;
            bits[j / ROWS_A_WORD] |= (word >> dart->c[0] % 32 & kept) << j % ROWS_A_WORD * WINDOW;
        }
    }
    UNROLLED(uint w = 0; w < WINDOW_WORDS; ++w)
    {
        for (ulong rest = bits[w]; rest != 0; rest &= rest - 1) {
            const uint bit = 63 - (uint)clz(rest & (0ul - rest));
            const uint column = wrapped(dart->c[0], (int)(bit % WINDOW) - REACH, slab->grid_size);
            const uint cell = rows[w * ROWS_A_WORD + bit / WINDOW] * slab->grid_size + column;
            Position other;
            FOR_EACH_AXIS(k) other.c[k] = positions[cell * DIMENSION + k];
            if (squared_distance(&other, &dart->position) < squared_min_distance) return true;
        }
    }
    return false;
}

void accept(const Seen* dart, const Slab* slab, uint time, global uint* accepted, global uint* positions,
            global uint* point)
{
    const uint layer = slab->first + (uint)dart->layer;
    const uint row = row_of(slab, layer, dart->c[1]);
    global uint* words = &accepted[row * slab->row_words];
    UNROLLED(int turn = -1; turn <= 1; ++turn)
    {
        const int bit = (int)dart->c[0] + REACH + turn * (int)slab->grid_size;
        if (bit >= 0 && bit < (int)slab->grid_size + 2 * REACH) words[bit / 32] |= 1u << bit % 32;
    }
    FOR_EACH_AXIS(k) positions[(row * slab->grid_size + dart->c[0]) * DIMENSION + k] = dart->position.c[k];
    FOR_EACH_AXIS(k) point[k] = dart->position.c[k];
    point[TIME_WORD] = time;
}

/// The darts that wait in a slab: chains of them, one for each of its cells, ghosts included. None waits in a layer
/// between `below` and `above`: most darts are there.
typedef struct
{
    global uint* heads;
    global uint* next;
    global const ulong* keys;
    int below, above;
} Waiting;

/// Is the dart too near to one that waits?
bool meets_waiting(const Seen* dart, const Slab* slab, const Waiting* waiting, ulong squared_min_distance,
                   global const uint* darts)
{
    if (dart->layer - waiting->below > REACH && waiting->above - dart->layer > REACH) return false;
    const int end = (int)(slab->layers + 2 * slab->ghosts);
    for (int j = 0; j < ROWS; ++j) {
        const int layer = dart->layer + (int)slab->ghosts + (DIMENSION == 2 ? j : j / WINDOW) - REACH;
        if (layer < 0 || layer >= end) continue;
        const uint y = DIMENSION == 2 ? 0 : wrapped(dart->c[1], j % WINDOW - REACH, slab->grid_size);
        global const uint* row = &waiting->heads[row_of(slab, (uint)layer, y) * slab->grid_size];
        for (int i = -REACH; i <= REACH; ++i) {
            for (uint link = row[wrapped(dart->c[0], i, slab->grid_size)]; link != 0; link = waiting->next[link - 1]) {
                const Position other = position_of(darts, (uint)waiting->keys[link - 1]);
                if (squared_distance(&other, &dart->position) < squared_min_distance) return true;
            }
        }
    }
    return false;
}

void let_wait(const Seen* dart, const Slab* slab, Waiting* waiting, uint at)
{
    const uint layer = (uint)(dart->layer + (int)slab->ghosts);
    const uint cell = row_of(slab, layer, dart->c[1]) * slab->grid_size + dart->c[0];
    waiting->next[at] = waiting->heads[cell];
    waiting->heads[cell] = at + 1;
    if (2 * dart->layer < (int)slab->layers) {
        waiting->below = max(waiting->below, dart->layer);
    } else {
        waiting->above = min(waiting->above, dart->layer);
    }
}

/// Does the slab look at darts in this cell?
ALWAYS_INLINE bool sees(const Slab* slab, uint cell) { return number_in(slab, cell) < slab_cells(slab); }

#include "kernels/common/darts/dart_order.clh"

/// One work-item owns one slab. Of the rest, `slabs.is_rest`, there is one slab, and its darts are undecided.
kernel void settle_darts(struct Slabs slabs, global const uint* darts, global uint* states, global uint* buckets,
                         global ulong* keys, global uint* next, global uint* heads, global uint* accepted,
                         global uint* positions, global uint* points, global uint* counters)
{
    const uint id = get_global_id(0);
    if (id >= slabs.slabs) return;
    const Slab slab = slab_at(id, slabs.slabs, slabs.grid_size, slabs.row_words);
    if (!slabs.is_rest) {
        const uint row_words = slab.row_words * (DIMENSION == 2 ? 1 : slabs.grid_size);
        for (uint w = 0; w < slab.layers * row_words; ++w) accepted[slab.first * row_words + w] = 0;
    }
    Waiting waiting = {&heads[(slab.first + 2 * id * slab.ghosts) * slab.layer_cells], next, keys, -2 * REACH - 1,
                       (int)slab.layers + 2 * REACH};
    if (slab.ghosts > 0)
        for (uint c = 0; c < slab_cells(&slab); ++c) waiting.heads[c] = 0;

    uint begin;
    const uint count =
        sort_darts(&slab, slabs, darts, states, &buckets[id << slabs.bucket_bits], keys, counters, &begin);
    for (uint at = begin; at < begin + count; ++at) {
        const uint dart_id = (uint)keys[at];
        const Seen dart = seen_from(&slab, darts, dart_id);
        const bool owns = (uint)dart.layer < slab.layers;
        uint state = REJECTED;
        if (!is_hit(&dart, &slab, slabs.squared_min_distance, accepted, positions)) {
            const bool waits =
                slab.ghosts > 0 && (!owns || meets_waiting(&dart, &slab, &waiting, slabs.squared_min_distance, darts));
            state = waits ? UNDECIDED : ACCEPTED;
            if (waits) {
                let_wait(&dart, &slab, &waiting, at);
            } else {
                const uint point = atomic_inc(&counters[POINTS]);
                accept(&dart, &slab, (uint)(keys[at] >> 32), accepted, positions, &points[point * POINT_WORDS]);
            }
        }
        if (owns) states[dart_id] = state;
    }
    if (slabs.slabs == 1) counters[OPEN_CELLS] = counters[DARTS] = counters[KEYS] = 0; // the last launch of the batch
}

/// Squared distances from a coordinate to the cells around cell `c` of the torus along an axis.
ALWAYS_INLINE void squared_gaps(uint coordinate, uint c, uint torus_size, ulong step, ulong* gaps)
{
    uint low = (uint)lower_bound(wrapped(c, -REACH, torus_size), 0, step);
    UNROLLED(int i = 0; i < WINDOW; ++i)
    {
        const uint high = (uint)lower_bound((ulong)wrapped(c, i - REACH, torus_size) + 1, 0, step);
        gaps[i] = square(axis_nearest(coordinate, low, high - low - 1));
        low = high;
    }
}

/// Sets the mask bits that stand for the point of a cell, in all cells of the slab that its disk reaches.
ALWAYS_INLINE void mark_disk(const Position* point, const Slab* slab, const struct GridPart* part, int layer, uint x,
                             uint y, ulong step, ulong squared_min_distance, global uint* masks)
{
    const uint grid_size = slab->grid_size, torus_size = part->torus_size;
    const uint in_grid = wrapped(slab->first, layer, grid_size);
    ulong along_x[WINDOW], along_y[WINDOW], along_layers[WINDOW];
    squared_gaps(point->c[0], torus_cell(x, 0, part), torus_size, step, along_x);
    if (DIMENSION == 3) squared_gaps(point->c[1], torus_cell(y, 1, part), torus_size, step, along_y);
    squared_gaps(point->c[DIMENSION - 1], torus_cell(in_grid, DIMENSION - 1, part), torus_size, step, along_layers);
    uint column[WINDOW];
    UNROLLED(int i = 0; i < WINDOW; ++i) column[i] = wrapped(x, i - REACH, grid_size);
    UNROLLED(int j = 0; j < ROWS; ++j)
    {
        const int l = DIMENSION == 2 ? j : j / WINDOW;
        uint to_layer;
        if (!own_layer(slab, layer, l - REACH, &to_layer)) continue;
        const ulong row_gap = along_layers[l] + (DIMENSION == 2 ? 0 : along_y[j % WINDOW]);
        if (row_gap >= squared_min_distance) continue;
        const uint to_y = DIMENSION == 2 ? 0 : wrapped(y, j % WINDOW - REACH, grid_size);
        global uint* row = &masks[row_of(slab, to_layer, to_y) * grid_size * MASK_WORDS];
        UNROLLED(int i = 0; i < WINDOW; ++i)
        {
            const uint seen_from_there = MAX_NEAR - 1 - (j * WINDOW + i);
            row[column[i] * MASK_WORDS + seen_from_there / 32] |= (uint)(row_gap + along_x[i] < squared_min_distance)
                                                                  << seen_from_there % 32;
        }
    }
}

/// One work-item owns one slab, and sets mask bits there for the points of this batch that are near.
kernel void mark_points(uint slab_count, struct GridPart part, uint grid_size, uint row_words, ulong step,
                        ulong squared_min_distance, global const uint* accepted, global const uint* positions,
                        global uint* masks)
{
    const uint id = get_global_id(0);
    if (id >= slab_count) return;
    const Slab slab = slab_at(id, slab_count, grid_size, row_words);
    const uint layer_rows = slab.layer_cells / grid_size;
    for (int layer = -(int)slab.ghosts; layer < (int)(slab.layers + slab.ghosts); ++layer) {
        const uint global_layer = wrapped(slab.first, layer, grid_size);
        for (uint y = 0; y < layer_rows; ++y) {
            const uint row = global_layer * layer_rows + y;
            for (uint w = 0; w < slab.row_words; ++w) {
                for (uint word = accepted[row * slab.row_words + w]; word != 0; word &= word - 1) {
                    const uint x = 32 * w + (31 - clz(word & (0u - word))) - REACH;
                    if (x >= grid_size) continue;
                    Position point;
                    FOR_EACH_AXIS(k) point.c[k] = positions[(row * grid_size + x) * DIMENSION + k];
                    mark_disk(&point, &slab, &part, layer, x, y, step, squared_min_distance, masks);
                }
            }
        }
    }
}
