// Relaxation dart throwing on the torus in parallel, with the result of the sequential algorithm in dart
// order.
//
// McCool and Fiume 1992; dissertation, sections 4.2.4.2 and 6.4. The plain twin of these kernels is
// host/sampling/reference/relaxation_dart_throwing.cpp; host/sampling/relaxation_dart_throwing.cpp runs them,
// a batch of consecutive darts a round:
// - throw_darts: flag the darts that no single disk is known to reject, by a look into a table
// - find_candidates: of those, keep the darts that no point of earlier batches rejects at the lowest radius
//   that the batch may reach
// - settle_candidates (one work-item): take the candidates in dart order; accept or reject them, count
//   failures, and reduce the radius
// - cover_cells: enter the disks of new points into the table
//
// Where disks are large or most darts find room, batches come out so small that their launches cost more than their
// darts. There, on CPUs, throw_in_order (one work-item) does what the sequential algorithm does.
//
// The radius only falls, so a dart that is rejected at the lowest radius ahead is rejected at whatever radius
// holds when its turn comes. Where a batch begins and how far ahead it looks decide about the cost only,
// never about the result.
//
// There are two grids. Points are in chains in that of grid_size cells along each axis, which are at least as wide as the
// minimum distance and become narrower with it, so that points in conflict are at most one cell apart and cells have few
// of them. The table has a grid of 2^grid_bits such cells along each axis, each with 2^COVER_BITS parts along each axis:
// for each part the squared distance within which one point has all of it. That does not depend on the radius, so the
// table holds until the host makes its grid finer.
//
// With REGION darts fall into the least box around a region of the plane or of space, whose coordinates are below half of
// the torus' along each axis: parts of the table outside count as covered, and darts outside fail. Where the region is
// long, REGION 2, they fall into squares that cover it (host/sampling/regions/region_candidates.hpp), and the table has
// only blocks of cells around these squares (host/sampling/relaxing_grids.hpp).
//
// Needs DIMENSION (2 or 3), COVER_BITS (2 or 3) and REGION (2, 1 or 0; see common/regions/region.clh).

#include "kernels/common/darts/relaxation_dart_throwing.h"
#include "kernels/common/darts/relaxing_grid.clh"
#include "kernels/common/philox.clh"
#include "kernels/common/regions/region.clh"

// Arguments of kernels, and what becomes of them. PLACE_IN_BOX turns random words into a position, and finds its square.
#if REGION == 2
#define BOX_PARAMETER , struct DartSquares squares, global const uint *corners
#define TABLE_PARAMETER , struct DartSquares squares, global const uint *first_parts
#define PLACE_IN_BOX(position, square_of_it) square_of_it = place_in_square(&(position), squares, corners)
#elif REGION
#define BOX_PARAMETER , struct DartBox box
#define TABLE_PARAMETER BOX_PARAMETER
// The coordinate that a random word stands for; of lanes of 64 bits as well.
#define PLACED(k, word) (box.low[k] + (((word)&0xffffffffu) * box.size[k] >> 32))
#define PLACE_IN_BOX(position, square_of_it)                                                                           \
    FOR_EACH_AXIS(k)(position).c[k] = (uint)PLACED(k, (ulong)(position).c[k])
#else
#define BOX_PARAMETER
#define TABLE_PARAMETER
#define PLACED(k, word) (word)
#define PLACE_IN_BOX(position, square_of_it)
#endif

#if REGION == 2
/// Turns random words into a position in a square, and returns the square's number: the first word says which, and where
/// along x.
ALWAYS_INLINE uint place_in_square(Position* position, struct DartSquares squares, global const uint* corners)
{
    const ulong place = (ulong)position->c[0] * squares.count;
    global const uint* corner = &corners[(uint)(place >> 32) * DIMENSION];
    position->c[0] = (uint)place;
    FOR_EACH_AXIS(k) position->c[k] = corner[k] + (uint)((ulong)position->c[k] << squares.shift >> 32);
    return (uint)(place >> 32);
}
#endif

/// Notes the square of a point, where there are any.
ALWAYS_INLINE void set_square(global uint* points, uint number, uint square_of_it)
{
#if REGION == 2
    points[number * POINT_WORDS + SQUARE_WORD] = square_of_it;
#endif
}

#include "kernels/common/darts/cover_table.clh"

#define BLOCKS_A_WORD (DARTS_A_WORD / DARTS_A_BLOCK)

ALWAYS_INLINE uint4 random_block(ulong block, uint2 key)
{
    return philox((uint4)((uint)block, (uint)(block >> 32), 0, 0), key);
}

ALWAYS_INLINE Position dart_position(ulong dart, uint2 key)
{
    const uint4 words = random_block(dart / DARTS_A_BLOCK, key);
    Position position;
#if DIMENSION == 2
    position.c[0] = dart & 1 ? words.z : words.x;
    position.c[1] = dart & 1 ? words.w : words.y;
#else
    position.c[0] = words.x;
    position.c[1] = words.y;
    position.c[2] = words.z;
#endif
    return position;
}

/// The uppermost `bits` of the lower 32 of each lane, 0 < bits < 32. (A macro: PoCL warns of functions that
/// take vectors wider than registers.)
#define UPPERMOST(lanes, bits) (((lanes)&0xffffffffu) >> (32 - (bits)))

/// One work-item owns eight blocks of darts. Needs `flags` to have room for all work-items, padded to whole
/// groups.
kernel void throw_darts(global const ulong* restrict state, global const ushort* restrict table, uint grid_bits,
                        uint key_x, uint key_y, global uchar* restrict flags TABLE_PARAMETER)
{
    const uint id = get_global_id(0);
    const ushort8 low = (ushort)((state[LOW_THRESHOLD] - 1) >> UNIT_BITS(grid_bits));
    const ulong8 block = state[NEXT_DART] / DARTS_A_BLOCK + 8 * (ulong)id + (ulong8)(0, 1, 2, 3, 4, 5, 6, 7);
    EightBlocks words;
    words.word[0] = block;
    words.word[1] = block >> 32;
    words.word[2] = words.word[3] = 0;
    philox8(&words, (uint2)(key_x, key_y));

    // Parts as vectors, then looks into the table that do not wait for each other.
    ulong8 parts[DARTS_A_BLOCK];
#if REGION == 2
    ulong8 numbers[DARTS_A_BLOCK]; // of squares
    const ulong bits_of_square = parts_of_square(squares.shift, grid_bits);
    _Pragma("unroll") for (uint i = 0; i < DARTS_A_BLOCK; ++i)
    {
        const ulong8 place = (words.word[DIMENSION * i] & 0xffffffffu) * squares.count;
        numbers[i] = place >> 32;
        words.word[DIMENSION * i] = place;
        parts[i] = 0;
        _Pragma("unroll") for (int k = DIMENSION - 1; k >= 0; --k)
        {
            parts[i] = parts[i] << squares.block_bits |
                       (words.word[DIMENSION * i + k] & 0xffffffffu) << bits_of_square >> 32;
        }
    }
#define FIRST_PART(i) first_parts[((const ulong*)numbers)[i]]
#else
    const uint bits = grid_bits + COVER_BITS;
    _Pragma("unroll") for (uint i = 0; i < DARTS_A_BLOCK; ++i)
    {
        parts[i] = UPPERMOST(PLACED(DIMENSION - 1, words.word[DIMENSION * i + DIMENSION - 1]), bits);
        _Pragma("unroll") for (int k = DIMENSION - 2; k >= 0; --k)
        {
            parts[i] = parts[i] << bits | UPPERMOST(PLACED(k, words.word[DIMENSION * i + k]), bits);
        }
    }
#define FIRST_PART(i) 0
#endif
    ushort farthest[DARTS_A_BLOCK * 8];
    _Pragma("unroll") for (uint i = 0; i < DARTS_A_BLOCK * 8; ++i)
    {
        farthest[i] = table[FIRST_PART(i) + ((const ulong*)parts)[i]];
    }
    // The sign of low - farthest says that the part is not covered: neither exceeds 2^15. (oclgrind 21.10
    // takes a vector comparison for 255 where it is widened to 1.)
    ushort8 result = (low - vload8(0, farthest)) >> (ushort8)15;
#if DIMENSION == 2
    result |= (low - vload8(1, farthest)) >> (ushort8)15 << (ushort8)1;
#endif
    vstore8(convert_uchar8(result), id, flags);
}

/// Is a position inside the region, and no point too near to it? Nearly half of the darts fall beside a long region,
/// far from all points. For these a search of all cells around would be wasted, so the region is tested before the full
/// search.
ALWAYS_INLINE bool may_be_point(const Position* position, global const uint* cells, global const uint* points,
                                const struct PointCells* grid, ulong threshold, const Region* region)
{
    if (REGION != 2)
        return is_free(position, cells, points, grid, threshold) && is_allowed_position(region, position);
    const ulong part = part_of_cell(grid, threshold);
    Reach reach[DIMENSION];
    FOR_EACH_AXIS(k) reach[k] = reach_of(position->c[k], grid->size, part);
    return !conflicts_at_corner(position, reach, cells, grid, threshold) && is_allowed_position(region, position) &&
           is_free(position, cells, points, grid, threshold);
}

/// The number of the lowest bit that is set.
uint lowest_bit(ulong bits) { return 63 - (uint)clz(bits & (0ul - bits)); }

/// One work-item owns one word of candidates and its darts' flags: bytes of blocks, eight at a time.
kernel void find_candidates(global const ulong* state, global const ulong* flags, uint word_count,
                            global const uint* cells, global const uint* points, struct PointCells grid, uint key_x,
                            uint key_y, global ulong* candidates BOX_PARAMETER REGION_PARAMETERS)
{
    REGION_OF_PARAMETERS
    const uint id = get_global_id(0);
    if (id >= word_count) return;
    const ulong threshold = state[LOW_THRESHOLD];
    const ulong first = state[NEXT_DART] / DARTS_A_BLOCK * DARTS_A_BLOCK + (ulong)id * DARTS_A_WORD;
    ulong word = 0;
    for (uint i = 0; i < BLOCKS_A_WORD / 8; ++i) {
        for (ulong bits = flags[id * (BLOCKS_A_WORD / 8) + i]; bits != 0; bits &= bits - 1) {
            const uint bit = lowest_bit(bits);
            const uint dart = (i * 8 + bit / 8) * DARTS_A_BLOCK + bit % 8;
            Position position = dart_position(first + dart, (uint2)(key_x, key_y));
            __attribute__((unused)) uint square_of_it;
            PLACE_IN_BOX(position, square_of_it);
            if (may_be_point(&position, cells, points, &grid, threshold, &region)) word |= 1ul << dart;
        }
    }
    candidates[id] = word;
}

/// The state of the algorithm while candidates are settled.
typedef struct
{
    ulong dart;
    ulong level;
    ulong failures;
} Progress;

/// Lets up to `count` darts fail, but none beyond the first that takes the radius below what the batch was
/// looked at for. Returns whether all of them did fail.
ALWAYS_INLINE bool fail(Progress* progress, ulong count, ulong attempts, ulong low_level)
{
    if (progress->level > low_level) return count == 0;
    const ulong most = (low_level + 1 - progress->level) * attempts - progress->failures;
    const ulong failing = min(count, most);
    progress->dart += failing;
    progress->failures += failing;
    if (progress->failures >= attempts) {
        progress->level += progress->failures / attempts;
        progress->failures %= attempts;
    }
    return failing == count;
}

/// The first work-item owns everything. Settles darts until the batch ends, or the radius falls below what
/// its darts were looked at for, or there are `target` points; then allows the next batch `levels_ahead`
/// levels.
///
/// `thresholds` the squared minimum distances of levels from `first_level` on.
kernel void settle_candidates(struct Settling settling, global ulong* state, global const ulong* candidates,
                              global const ulong* thresholds, global uint* cells, global uint* points BOX_PARAMETER)
{
    if (get_global_id(0) != 0) return;
    const ulong attempts = settling.attempts;
    const struct PointCells grid = settling.cells;
    const ulong low_level = state[LOW_LEVEL];
    const ulong skipped = state[NEXT_DART] % DARTS_A_BLOCK;
    const ulong first = state[NEXT_DART] - skipped;
    Progress progress = {state[NEXT_DART], state[LEVEL], state[FAILURES]};
    uint count = (uint)state[POINTS];
    ulong looked_at = 0;
    bool goes_on = count < settling.target;
    state[FIRST_NEW] = count;

    for (uint w = 0; w < settling.words && goes_on; ++w) {
        ulong word = candidates[w];
        if (w == 0) word &= ~0ul << skipped;
        for (; word != 0 && goes_on; word &= word - 1) {
            const ulong dart = first + (ulong)w * DARTS_A_WORD + lowest_bit(word);
            goes_on = fail(&progress, dart - progress.dart, attempts, low_level) && progress.level <= low_level;
            if (!goes_on) break;
            ++looked_at;
            Position position = dart_position(dart, (uint2)(settling.key_x, settling.key_y));
            uint square_of_it = 0;
            PLACE_IN_BOX(position, square_of_it);
            if (is_free(&position, cells, points, &grid, thresholds[progress.level - settling.first_level])) {
                insert_point(&position, count, cells, points, &grid);
                set_square(points, count, square_of_it);
                ++count;
                ++progress.dart;
                progress.failures = 0;
                goes_on = count < settling.target;
            } else {
                fail(&progress, 1, attempts, low_level);
            }
        }
    }
    if (goes_on) fail(&progress, first + (ulong)settling.words * DARTS_A_WORD - progress.dart, attempts, low_level);

    state[NEXT_DART] = progress.dart;
    state[LEVEL] = progress.level;
    state[FAILURES] = progress.failures;
    state[POINTS] = count;
    state[LOW_LEVEL] = progress.level + settling.levels_ahead;
    state[LOW_THRESHOLD] = thresholds[progress.level + settling.levels_ahead - settling.first_level];
    state[CANDIDATES] += looked_at;
}

/// The first work-item owns everything. Throws 8 blocks of darts `settling.words` times, one dart after the other, or
/// until the level comes to `end_level`, or there are `target` points. Points since FIRST_NEW stay out of the table.
kernel void throw_in_order(struct Settling settling, ulong end_level, global ulong* state,
                           global const ulong* thresholds, global uint* cells,
                           global uint* points BOX_PARAMETER REGION_PARAMETERS)
{
    if (get_global_id(0) != 0) return;
    REGION_OF_PARAMETERS
    const struct PointCells grid = settling.cells;
    ulong dart = state[NEXT_DART];
    ulong level = state[LEVEL];
    ulong failures = state[FAILURES];
    uint count = (uint)state[POINTS];
    ulong threshold = thresholds[level - settling.first_level];
    ulong block = dart / DARTS_A_BLOCK;
    bool goes_on = count < settling.target && level < end_level;
    for (uint i = 0; i < settling.words && goes_on; ++i, block += 8) {
        const ulong8 numbers = block + (ulong8)(0, 1, 2, 3, 4, 5, 6, 7);
        EightBlocks random;
        random.word[0] = numbers;
        random.word[1] = numbers >> 32;
        random.word[2] = random.word[3] = 0;
        philox8(&random, (uint2)(settling.key_x, settling.key_y));
        ulong words[4][8];
        for (uint w = 0; w < 4; ++w) vstore8(random.word[w], 0, words[w]);
        for (; dart < (block + 8) * DARTS_A_BLOCK && goes_on; ++dart) {
            const uint lane = (uint)(dart / DARTS_A_BLOCK - block);
            const uint first = (uint)(dart % DARTS_A_BLOCK) * DIMENSION;
            Position position;
            FOR_EACH_AXIS(k) position.c[k] = (uint)words[first + k][lane];
            uint square_of_it = 0;
            PLACE_IN_BOX(position, square_of_it);
            if (may_be_point(&position, cells, points, &grid, threshold, &region)) {
                insert_point(&position, count, cells, points, &grid);
                set_square(points, count, square_of_it);
                ++count;
                failures = 0;
                goes_on = count < settling.target;
            } else if (++failures == settling.attempts) {
                failures = 0;
                ++level;
                threshold = thresholds[level - settling.first_level];
                goes_on = level < end_level;
            }
        }
    }
    state[NEXT_DART] = dart;
    state[LEVEL] = level;
    state[FAILURES] = failures;
    state[POINTS] = count;
    state[LOW_LEVEL] = level + settling.levels_ahead;
    state[LOW_THRESHOLD] = thresholds[level + settling.levels_ahead - settling.first_level];
}

/// One work-item owns one cell, and makes it empty.
kernel void clear_cells(global uint* cells, uint cell_count)
{
    const uint id = get_global_id(0);
    if (id < cell_count) cells[id * CELL_WORDS + LINK_WORD] = 0;
}

/// One work-item owns one point, and chains it to its cell.
kernel void link_points(global const ulong* state, global uint* cells, global uint* points, struct PointCells grid)
{
    const uint id = get_global_id(0);
    if (id >= state[POINTS]) return;
    Position position;
    FOR_EACH_AXIS(k) position.c[k] = points[id * POINT_WORDS + k];
    global uint* link = &cells[cell_of(&position, &grid) * CELL_WORDS + LINK_WORD];
    points[id * POINT_WORDS + NEXT_WORD] = atomic_xchg(link, id + 1);
}

/// One work-item owns one cell, and takes the first point of its chain into it.
kernel void fill_cells(global uint* cells, uint cell_count, global const uint* points)
{
    const uint id = get_global_id(0);
    if (id >= cell_count) return;
    global uint* cell = &cells[id * CELL_WORDS];
    if (cell[LINK_WORD] == 0) return;
    global const uint* point = &points[(cell[LINK_WORD] - 1) * POINT_WORDS];
    FOR_EACH_AXIS(k) cell[k] = point[k];
    if (point[NEXT_WORD] != 0) cell[LINK_WORD] |= HAS_MORE;
}
