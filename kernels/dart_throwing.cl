// Dart throwing on the torus in parallel, with the result of the sequential algorithm in dart order.
//
// Dissertation, section 4.2.4.1; the list of open cells after Ebeida et al. 2012. The plain twin of these kernels is
// host/sampling/reference/dart_throwing.cpp; host/sampling/dart_throwing.cpp runs them, batch after batch:
//   throw_darts        split the open cells, drop covered ones, draw darts in the others, keep those that no point of
//                      earlier batches rejects
//   link_darts         chain the darts that share a level 0 cell
//   resolve_conflicts  (in rounds) a dart is rejected when a rival, an earlier dart in conflict with it, is accepted, and
//                      accepted when all its rivals are rejected: exactly what throwing them one by one would give
//   insert_points      put the accepted darts into the grid and into the output
// Lists are filled through atomic counters, so their order may differ from run to run; no result depends on it.
//
// Needs DIMENSION (2 or 3), REACH (points in conflict are at most so many level 0 cells apart), and LARGE_DISKS (see
// common/torus.clh).

#include "kernels/common/dart_throwing.h"
#include "kernels/common/philox.clh"
#include "kernels/common/torus.clh"

#define CHILDREN (1 << DIMENSION)
#define WINDOW (2 * REACH + 1)
#if DIMENSION == 2
#define MAX_NEAR (WINDOW * WINDOW)
#else
#define MAX_NEAR (WINDOW * WINDOW * WINDOW)
#endif

// The numbers of a dart.
#define TIME_WORD DIMENSION
#define CELL_WORD (DIMENSION + 1)

// Three arrays hold the state of each level 0 cell:
//   masks      MASK_WORDS words: bit b is set when the point in cell b of the window around this cell is near enough
//              to matter here; cells are numbered x fastest, the cell itself is in the middle
//   positions  DIMENSION words: the point in the cell (a cell has room for one); undefined when there is none
//   slots      1 + the number of the first dart in the cell's chain. Darts are numbered through all batches, so that
//              numbers of earlier batches stand for an empty chain, and nothing needs clearing.

// States of a dart.
#define UNDECIDED 0u
#define ACCEPTED 1u
#define REJECTED 2u

typedef struct { uint c[DIMENSION]; } Cell;

uint cell_index(const Cell* cell, uint grid_size)
{
    uint index = cell->c[DIMENSION - 1];
    for (int k = DIMENSION - 2; k >= 0; --k) index = index * grid_size + cell->c[k];
    return index;
}

Cell cell_at(uint index, uint grid_size)
{
    Cell cell;
    FOR_EACH_AXIS(k) {
        cell.c[k] = index % grid_size;
        index /= grid_size;
    }
    return cell;
}

/// (cell + offset) modulo grid_size, for |offset| <= REACH, which never exceeds grid_size.
uint wrapped(uint cell, int offset, uint grid_size)
{
    const int c = (int)cell + offset;
    return (uint)(c < 0 ? c + (int)grid_size : c >= (int)grid_size ? c - (int)grid_size : c);
}

/// The index of the first cell of the grid row that is row number `row` of the window around `cell`.
uint window_row(const Cell* cell, uint row, uint grid_size)
{
    uint index = wrapped(cell->c[1], (int)(row % WINDOW) - REACH, grid_size);
#if DIMENSION == 3
    index += wrapped(cell->c[2], (int)(row / WINDOW) - REACH, grid_size) * grid_size;
#endif
    return index * grid_size;
}

/// The index of cell number `b` of the window around `cell`.
uint window_cell(const Cell* cell, uint b, uint grid_size)
{
    return window_row(cell, b / WINDOW, grid_size) + wrapped(cell->c[0], (int)(b % WINDOW) - REACH, grid_size);
}

/// The lowest coordinate of a cell of a level, as CellHierarchy::lower_bound: cell * step / 2^(32 + level).
ulong lower_bound(ulong cell, int level, ulong step)
{
    return (cell * (step >> 32) + ((cell * (step & 0xffffffffu)) >> 32)) >> level;
}

/// Is the position nearer to one of the points than the minimum distance?
bool conflicts(const Position* position, const Position* near, uint near_count, ulong squared_min_distance)
{
    for (uint i = 0; i < near_count; ++i) {
        if (squared_distance(&near[i], position) < squared_min_distance) return true;
    }
    return false;
}

/// The box of a cell and its two halves along each axis: child c takes half (c >> k & 1) along axis k. A cell that is
/// not split is its own and only child, number 0.
typedef struct
{
    uint low[DIMENSION][2];
    uint extent[DIMENSION][2]; // the box holds low, low + 1, ..., low + extent
} Halves;

Halves halves_of(const Cell* cell, int level, bool split, ulong step)
{
    Halves halves;
    FOR_EACH_AXIS(k) {
        const ulong low = lower_bound(cell->c[k], level, step);
        const ulong high = lower_bound((ulong)cell->c[k] + 1, level, step);
        const ulong middle = split ? lower_bound(2 * (ulong)cell->c[k] + 1, level + 1, step) : high;
        halves.low[k][0] = (uint)low;
        halves.extent[k][0] = (uint)(middle - low - 1);
        halves.low[k][1] = (uint)middle;
        halves.extent[k][1] = (uint)(high - middle - 1);
    }
    return halves;
}

/// The children that the disk of a point covers, as bits. Distances to the halves serve all children at once.
ALWAYS_INLINE uint covered_by(const Position* point, const Halves* halves, ulong squared_min_distance)
{
    ulong farthest[DIMENSION][2];
    FOR_EACH_AXIS(k) {
        farthest[k][0] = square(axis_farthest(point->c[k], halves->low[k][0], halves->extent[k][0]));
        farthest[k][1] = square(axis_farthest(point->c[k], halves->low[k][1], halves->extent[k][1]));
    }
    uint covered = 0;
    _Pragma("unroll") for (uint c = 0; c < CHILDREN; ++c) {
        ulong sum = 0;
        FOR_EACH_AXIS(k) sum += farthest[k][c >> k & 1];
        covered |= (uint)(sum < squared_min_distance) << c;
    }
    return covered;
}

/// At the last level a box has one or two coordinates along each axis, and each is looked at, so that saturation is
/// exact.
bool has_room(const Halves* halves, const Position* near, uint near_count, ulong squared_min_distance)
{
    for (int corner = 0; corner < CHILDREN; ++corner) {
        Position position;
        FOR_EACH_AXIS(k) position.c[k] = halves->low[k][0] + ((corner >> k & 1) ? halves->extent[k][0] : 0u);
        if (!conflicts(&position, near, near_count, squared_min_distance)) return true;
    }
    return false;
}

/// The number of darts for a uniform word: how many thresholds it reaches.
uint dart_count(uint word, constant const uint* thresholds, uint threshold_count)
{
    uint count = 0;
    while (count < threshold_count && word >= thresholds[count]) ++count;
    return count;
}

uint4 random_words(const Cell* cell, uint batch, uint number, uint2 key)
{
#if DIMENSION == 2
    const uint4 counter = (uint4)(cell->c[0], cell->c[1], 0, batch << 16 | number);
#else
    const uint4 counter = (uint4)(cell->c[0], cell->c[1], cell->c[2], batch << 16 | number);
#endif
    return philox(counter, key);
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

void append(const List* list, const uint* entry)
{
    const uint at = atomic_inc(list->staged_count);
    if (at < list->staged_capacity) {
        for (uint w = 0; w < list->words; ++w) list->staged[at * list->words + w] = entry[w];
        return;
    }
    const uint direct = atomic_inc(list->target_count);
    if (direct >= list->target_capacity) return; // the host sees the count and repeats the batch with more room
    for (uint w = 0; w < list->words; ++w) list->target[direct * list->words + w] = entry[w];
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

/// One work-item owns one open cell ("parent"). Needs: masks and positions for all points of earlier batches; counters
/// OPEN_CELLS and DARTS zero.
///
/// `parents` DIMENSION words each; in batches 0 and 1 not used: all cells of level 0. Batch 0 also clears their slots
/// and masks, and does not list them as open. Local memory: staged_cells for DIMENSION words each, staged_darts for
/// DART_WORDS each, group for GROUP_WORDS.
kernel void throw_darts(struct Batch batch, global const uint* parents, global uint* masks, global uint* slots,
                        global const uint* positions, constant const uint* thresholds, global uint* open_cells,
                        global uint* darts, global uint* counters, local uint* staged_cells, local uint* staged_darts,
                        local uint* group)
{
    const uint grid_size = batch.grid_size;
    const ulong squared_min_distance = batch.squared_min_distance;
    const List cells_list = {staged_cells, batch.staged_capacity, &group[0],
                             open_cells,   batch.open_capacity,   &counters[OPEN_CELLS], DIMENSION};
    const List darts_list = {staged_darts, batch.staged_capacity, &group[1],
                             darts,        batch.dart_capacity,   &counters[DARTS], DART_WORDS};
    if (get_local_id(0) == 0) group[0] = group[1] = 0;
    barrier(CLK_LOCAL_MEM_FENCE);

    const uint id = get_global_id(0);
    if (id < batch.parents) {
        Cell parent;
        if (batch.number <= 1) {
            parent = cell_at(id, grid_size);
        } else {
            FOR_EACH_AXIS(k) parent.c[k] = parents[id * DIMENSION + k];
        }
        const int parent_level = batch.level - (int)batch.is_split;
        Cell base;
        FOR_EACH_AXIS(k) base.c[k] = parent.c[k] >> parent_level;
        const uint base_index = cell_index(&base, grid_size);
        if (batch.number == 0) {
            slots[base_index] = 0;
            for (uint w = 0; w < MASK_WORDS; ++w) masks[base_index * MASK_WORDS + w] = 0;
        }

        const Halves halves = halves_of(&parent, parent_level, batch.is_split, batch.step);

        // The points that can matter to it, and the children that they cover.
        Position near[MAX_NEAR];
        uint near_count = 0;
        uint open = batch.is_split ? (1u << CHILDREN) - 1 : 1u;
        for (uint w = 0; w < MASK_WORDS; ++w) {
            for (uint mask = masks[base_index * MASK_WORDS + w]; mask != 0 && open != 0; mask &= mask - 1) {
                const uint lowest_bit = 31 - clz(mask & (0u - mask));
                const uint cell = window_cell(&base, 32 * w + lowest_bit, grid_size);
                FOR_EACH_AXIS(k) near[near_count].c[k] = positions[cell * DIMENSION + k];
                open &= ~covered_by(&near[near_count], &halves, squared_min_distance);
                ++near_count;
            }
        }
        if (batch.is_last_level && open != 0 && !has_room(&halves, near, near_count, squared_min_distance)) open = 0;

        // The open children, and the darts in each.
        if (open != 0) {
            const uint2 key = (uint2)(batch.key_x, batch.key_y);
            uint count_words[CHILDREN];
            for (int c = 0; c < CHILDREN; c += 4) {
                vstore4(random_words(&parent, batch.number, 0xfffc + c / 4, key), 0, &count_words[c]);
            }
            for (; open != 0; open &= open - 1) {
                const uint c = 31 - clz(open & (0u - open));
                Cell child = parent;
                if (batch.is_split) FOR_EACH_AXIS(k) child.c[k] = 2 * parent.c[k] + (c >> k & 1);
                if (batch.number > 0) append(&cells_list, child.c);
                const uint count = dart_count(count_words[c], thresholds, batch.thresholds);
                for (uint number = 0; number < count; ++number) {
                    const uint4 words = random_words(&child, batch.number, number, key);
                    const uint offsets[3] = {words.y, words.z, words.w};
                    Position position;
                    FOR_EACH_AXIS(k) {
                        const uint side = c >> k & 1;
                        const ulong width = (ulong)halves.extent[k][side] + 1;
                        position.c[k] = halves.low[k][side] + (uint)((offsets[k] * width) >> 32);
                    }
                    if (conflicts(&position, near, near_count, squared_min_distance)) continue;
                    uint dart[DART_WORDS];
                    FOR_EACH_AXIS(k) dart[k] = position.c[k];
                    dart[TIME_WORD] = words.x;
                    dart[CELL_WORD] = base_index;
                    append(&darts_list, dart);
                }
            }
        }
    }

    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) == 0) {
        group[2] = atomic_add(&counters[OPEN_CELLS], min(group[0], batch.staged_capacity));
        group[3] = atomic_add(&counters[DARTS], min(group[1], batch.staged_capacity));
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    copy_staged(&cells_list, group[2]);
    copy_staged(&darts_list, group[3]);
}

/// One work-item owns one dart. `first` is the number of the batch's first dart. Also clears the counters of the batch,
/// which the host has read.
kernel void link_darts(global const uint* darts, uint dart_count, uint first, global uint* slots, global uint* next,
                       global uint* states, global uint* counters)
{
    const uint id = get_global_id(0);
    if (id == 0) counters[OPEN_CELLS] = counters[DARTS] = counters[WAITING_ROUND] = 0;
    if (id >= dart_count) return;
    next[id] = atomic_xchg(&slots[darts[id * DART_WORDS + CELL_WORD]], first + id + 1);
    states[id] = UNDECIDED;
}

Position position_of(global const uint* darts, uint dart)
{
    Position position;
    FOR_EACH_AXIS(k) position.c[k] = darts[dart * DART_WORDS + k];
    return position;
}

/// The order of darts of equal time: by position.
bool is_earlier_twin(global const uint* darts, uint a, uint b)
{
    FOR_EACH_AXIS(k) {
        const uint a_k = darts[a * DART_WORDS + k];
        const uint b_k = darts[b * DART_WORDS + k];
        if (a_k != b_k) return a_k < b_k;
    }
    return a < b; // the same dart twice: whichever is taken, the result is the same
}

/// Lists the rivals of dart `id` that are not rejected, as far as there is room, and returns how many there are. In
/// small grids a chain is met more than once; a rival that is listed twice does no harm.
ALWAYS_INLINE uint list_rivals(uint id, global const uint* darts, uint first, global const uint* slots, global const uint* next,
                 uint grid_size, ulong squared_min_distance, global const uint* states, global uint* list)
{
    const Position position = position_of(darts, id);
    const uint time = darts[id * DART_WORDS + TIME_WORD];
    const Cell cell = cell_at(darts[id * DART_WORDS + CELL_WORD], grid_size);
    uint column[WINDOW];
    for (int i = 0; i < WINDOW; ++i) column[i] = wrapped(cell.c[0], i - REACH, grid_size);

    // The chains around, without branches: which cells have one is hard to predict.
    uint chains[MAX_NEAR];
    uint chain_count = 0;
    for (uint j = 0; j < MAX_NEAR / WINDOW; ++j) {
        const uint row = window_row(&cell, j, grid_size);
        for (int i = 0; i < WINDOW; ++i) {
            chains[chain_count] = slots[row + column[i]];
            chain_count += chains[chain_count] > first;
        }
    }

    uint count = 0;
    for (uint c = 0; c < chain_count; ++c) {
        for (uint link = chains[c]; link > first; link = next[link - 1 - first]) {
            const uint other = link - 1 - first;
            const Position other_position = position_of(darts, other);
            const uint other_time = darts[other * DART_WORDS + TIME_WORD];
            const bool in_conflict = squared_distance(&other_position, &position) < squared_min_distance;
            if (!(in_conflict & (other_time <= time))) continue;
            if (other_time == time && !is_earlier_twin(darts, other, id)) continue;
            if (states[other] == REJECTED) continue;
            if (count < MAX_RIVALS) list[count] = other;
            ++count;
        }
    }
    return count;
}

/// One work-item owns one dart, its next state and its list of rivals. The states that the round before left are only
/// read, so rounds need no atomics. Needs: link_darts is done. Rounds count from 0.
kernel void resolve_conflicts(global const uint* darts, uint dart_count, uint first, uint round,
                              global const uint* slots, global const uint* next, uint grid_size,
                              ulong squared_min_distance, global uint* rivals, global const uint* states,
                              global uint* next_states, global uint* counters)
{
    const uint id = get_global_id(0);
    if (id >= dart_count) return;
    uint state = states[id];
    if (state == UNDECIDED) {
        global uint* list = &rivals[id * RIVAL_WORDS + 1];
        uint count = round == 0 ? MAX_RIVALS + 1 : rivals[id * RIVAL_WORDS];
        if (count > MAX_RIVALS) {
            count = list_rivals(id, darts, first, slots, next, grid_size, squared_min_distance, states, list);
            rivals[id * RIVAL_WORDS] = count;
        }
        bool waits = count > MAX_RIVALS;
        for (uint i = 0; i < min(count, (uint)MAX_RIVALS) && state == UNDECIDED; ++i) {
            const uint rival = states[list[i]];
            if (rival == ACCEPTED) state = REJECTED;
            waits = waits || rival == UNDECIDED;
        }
        if (state == UNDECIDED && !waits) state = ACCEPTED;
        if (state == UNDECIDED) counters[WAITING_ROUND] = round + 1;
    }
    next_states[id] = state;
}

/// Sets the mask bits that stand for the point in `cell`, in all cells that its disk reaches.
ALWAYS_INLINE void mark_disk(const Position* point, const Cell* cell, uint grid_size, ulong step, ulong squared_min_distance,
               global volatile uint* masks)
{
    // Squared distances to the columns, rows and slices of the window.
    uint column[WINDOW];
    for (int i = 0; i < WINDOW; ++i) column[i] = wrapped(cell->c[0], i - REACH, grid_size);
    ulong squared_gap[DIMENSION][WINDOW];
    FOR_EACH_AXIS(k) {
        for (int i = 0; i < WINDOW; ++i) {
            const uint other = wrapped(cell->c[k], i - REACH, grid_size);
            const uint low = (uint)lower_bound(other, 0, step);
            const uint extent = (uint)(lower_bound((ulong)other + 1, 0, step) - low - 1);
            squared_gap[k][i] = square(axis_nearest(point->c[k], low, extent));
        }
    }
    for (uint j = 0; j < MAX_NEAR / WINDOW; ++j) {
        const uint row = window_row(cell, j, grid_size);
        ulong row_gap = squared_gap[1][j % WINDOW];
#if DIMENSION == 3
        row_gap += squared_gap[2][j / WINDOW];
#endif
        for (uint i = 0; i < WINDOW; ++i) {
            if (row_gap + squared_gap[0][i] >= squared_min_distance) continue;
            const uint seen_from_there = MAX_NEAR - 1 - (j * WINDOW + i);
            global volatile uint* mask = &masks[(row + column[i]) * MASK_WORDS];
            atomic_or(&mask[seen_from_there / 32], 1u << seen_from_there % 32);
        }
    }
}

/// One work-item owns `run` darts in a row. Accepted darts become points: in the grid, and appended to `points`
/// (POINT_WORDS).
kernel void insert_points(global const uint* darts, uint dart_count, uint run, global const uint* states,
                          uint grid_size, ulong step, ulong squared_min_distance, global volatile uint* masks,
                          global uint* positions, global uint* points, global uint* counters)
{
    const uint begin = min((uint)get_global_id(0) * run, dart_count);
    const uint end = min(begin + run, dart_count);
    uint count = 0;
    for (uint i = begin; i < end; ++i) count += states[i] == ACCEPTED;
    if (count == 0) return;

    uint at = atomic_add(&counters[POINTS], count);
    for (uint i = begin; i < end; ++i) {
        if (states[i] != ACCEPTED) continue;
        const Position position = position_of(darts, i);
        const uint index = darts[i * DART_WORDS + CELL_WORD];
        FOR_EACH_AXIS(k) positions[index * DIMENSION + k] = position.c[k];
        const Cell cell = cell_at(index, grid_size);
        mark_disk(&position, &cell, grid_size, step, squared_min_distance, masks);
        FOR_EACH_AXIS(k) points[at * POINT_WORDS + k] = position.c[k];
        points[at * POINT_WORDS + TIME_WORD] = darts[i * DART_WORDS + TIME_WORD];
        ++at;
    }
}
