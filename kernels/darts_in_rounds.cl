// Settles a batch of dart throwing among its darts, a work-item each: for devices with many of them.
//
//   link_darts         chain the darts that share a level 0 cell
//   resolve_conflicts  (in rounds) a dart is rejected when a rival, an earlier dart in conflict with it, is accepted,
//   and
//                      accepted when all its rivals are rejected: exactly what throwing them one by one would give
//   insert_points      put the accepted darts into the grid and into the output
//
// Beside the arrays of common/darts/dart_grid.clh, each level 0 cell has in `slots` 1 + the number of the first dart in its
// chain. Darts are numbered through all batches, so that numbers of earlier batches stand for an empty chain, and
// nothing needs clearing.
//
// Needs what common/darts/dart_grid.clh needs.

#include "kernels/common/darts/dart_grid.clh"

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

/// Lists the chains of this batch in the window around a cell, and returns how many there are.
ALWAYS_INLINE uint list_chains(const Cells* cells, uint cell, uint first, global const uint* slots, uint* chains)
{
    Spot spot;
    find_spot(cells, cell, &spot);
    uint count = 0;
#if BRICKS
    for (uint b = 0; b < MAX_NEAR; ++b) {
        const uint other = cell_of_window(cells, &spot, b);
        if (other == NO_CELL) continue;
        chains[count] = slots[other];
        count += chains[count] > first;
    }
#else
    uint column[WINDOW];
    for (int i = 0; i < WINDOW; ++i) column[i] = wrapped(spot.c[0], i - REACH, cells->size);
    // Without branches: which cells have one is hard to predict.
    for (uint j = 0; j < MAX_NEAR / WINDOW; ++j) {
        const uint row = window_row(&spot, j, cells->size);
        for (int i = 0; i < WINDOW; ++i) {
            chains[count] = slots[row + column[i]];
            count += chains[count] > first;
        }
    }
#endif
    return count;
}

/// Lists the rivals of dart `id` that are not rejected, as far as there is room, and returns how many there are. In
/// small grids a chain is met more than once; a rival that is listed twice does no harm.
ALWAYS_INLINE uint list_rivals(uint id, global const uint* darts, uint first, global const uint* slots,
                               global const uint* next, const Cells* cells, ulong squared_min_distance,
                               global const uint* states, global uint* list)
{
    const Position position = position_of(darts, id);
    const uint time = darts[id * DART_WORDS + TIME_WORD];
    uint chains[MAX_NEAR];
    const uint chain_count = list_chains(cells, darts[id * DART_WORDS + CELL_WORD], first, slots, chains);

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
                              global uint* next_states, global uint* counters, struct GridPart part CELLS_PARAMETERS)
{
    CELLS_OF_PARAMETERS(grid_size, part)
    const uint id = get_global_id(0);
    if (id >= dart_count) return;
    uint state = states[id];
    if (state == UNDECIDED) {
        global uint* list = &rivals[id * RIVAL_WORDS + 1];
        uint count = round == 0 ? MAX_RIVALS + 1 : rivals[id * RIVAL_WORDS];
        if (count > MAX_RIVALS) {
            count = list_rivals(id, darts, first, slots, next, &cells, squared_min_distance, states, list);
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

/// Sets the mask bits that stand for the point in a cell, in all cells that its disk reaches.
ALWAYS_INLINE void mark_disk(const Position* point, uint index, const Cells* cells, uint torus_size, ulong step,
                             ulong squared_min_distance, global volatile uint* masks)
{
    Spot spot;
    find_spot(cells, index, &spot);
    // Squared distances to the columns, rows and slices of the window.
    ulong squared_gap[DIMENSION][WINDOW];
    FOR_EACH_AXIS(k)
    {
        for (int i = 0; i < WINDOW; ++i) {
            const uint other = wrapped(torus_coordinate(cells, &spot, k), i - REACH, torus_size);
            const uint low = (uint)lower_bound(other, 0, step);
            const uint extent = (uint)(lower_bound((ulong)other + 1, 0, step) - low - 1);
            squared_gap[k][i] = square(axis_nearest(point->c[k], low, extent));
        }
    }
    for (uint b = 0; b < MAX_NEAR; ++b) {
        ulong gap = squared_gap[0][b % WINDOW] + squared_gap[1][b / WINDOW % WINDOW];
#if DIMENSION == 3
        gap += squared_gap[2][b / WINDOW / WINDOW];
#endif
        if (gap >= squared_min_distance) continue;
#if BRICKS
        const uint cell = cell_of_window(cells, &spot, b);
        if (cell == NO_CELL) continue;
#else
        const uint cell = window_cell(&spot, b, cells->size);
#endif
        const uint seen_from_there = MAX_NEAR - 1 - b;
        atomic_or(&masks[cell * MASK_WORDS + seen_from_there / 32], 1u << seen_from_there % 32);
    }
}

/// One work-item owns `run` darts in a row. Accepted darts become points: in the grid, and appended to `points`
/// (POINT_WORDS).
kernel void insert_points(global const uint* darts, uint dart_count, uint run, global const uint* states,
                          struct GridPart part, uint grid_size, ulong step, ulong squared_min_distance,
                          global volatile uint* masks, global uint* positions, global uint* points,
                          global uint* counters CELLS_PARAMETERS)
{
    CELLS_OF_PARAMETERS(grid_size, part)
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
        mark_disk(&position, index, &cells, part.torus_size, step, squared_min_distance, masks);
        FOR_EACH_AXIS(k) points[at * POINT_WORDS + k] = position.c[k];
        points[at * POINT_WORDS + TIME_WORD] = darts[i * DART_WORDS + TIME_WORD];
        ++at;
    }
}
