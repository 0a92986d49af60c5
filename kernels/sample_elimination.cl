// Sample elimination side by side, with the result of the sequential algorithm: the heaviest point is removed, again and
// again.
//
// Yuksel, Sample elimination for generating Poisson disk sample sets, Computer Graphics Forum 34(2), 2015. Weights only
// fall, so a point that is heavier than all within its reach is removed before any of them, and at the weight that it
// has, whatever happens elsewhere. The order of removal is that of weights at removal. The plain twin, with a heap, is
// host/sampling/optimized/reference/sample_elimination.cpp.
//   weigh_points     the weights before the first removal
//   eliminate_tiles  (again and again, for one colour after the other) removes what can be removed in a tile
//
// Tiles are blocks of grid cells, coloured like a chessboard: between two of a colour lies one that is two cells wide or
// wider. A point's removal changes no weight farther away than a cell, so that tiles of a colour never meet, and the
// order does not depend on how many tiles there are, nor on which of them are done at once.
//
// With FACTORS the weights of a point's pairs are multiplied by a number of its own, which makes up for what lies beyond a
// boundary: pairs then have two weights, one for either point.
//
// Points are sorted by grid cells, see point_grid.cl. Of equal weights, that of the lower id counts as the heavier.
//
// With LISTED only cells that have points are there, sorted by colours, tiles and cells, see
// host/sampling/optimized/listed_cells.hpp: those of a tile follow each other, and each cell has a list of the runs of
// points in the cells around it.
//
// Needs DIMENSION (2 or 3), FACTORS (1 or 0) and LISTED (1 or 0).

#pragma OPENCL FP_CONTRACT OFF

#define LARGE_DISKS 0

#include "kernels/common/optimized/sample_elimination.h"
#include "kernels/common/torus.clh"

// The last argument of kernels and functions, and what it makes of the weight that a pair has for a point.
#if FACTORS
#define FACTORS_PARAMETER , global const uint* factors
#define FACTORS_ARGUMENT , factors
#define TIMES_FACTOR(weight, item) ((weight) * (long)factors[item])
#else
#define FACTORS_PARAMETER
#define FACTORS_ARGUMENT
#define TIMES_FACTOR(weight, item) (weight)
#endif

// The grid, as arguments of kernels and functions; those that only kernels take begin with a comma.
#if LISTED
#define GRID_PARAMETERS global const uint *cells, global const uint *runs
#define GRID_ARGUMENTS cells, runs
#define TILES_PARAMETERS , global const uint *tile_starts, global const uint *tiles_around
#define TILES_ARGUMENTS , tile_starts, tiles_around
#else
#define GRID_PARAMETERS global const uint* starts
#define GRID_ARGUMENTS starts
#define TILES_PARAMETERS
#define TILES_ARGUMENTS
#endif

typedef struct Elimination Elimination;
typedef struct EliminationCounts EliminationCounts;

/// Structs are filled in: Oclgrind 21.10 lacks an intrinsic that inlining of returned ones brings in.
ALWAYS_INLINE void find_position(global const uint* coordinates, uint stride, uint item, Position* position)
{
    FOR_EACH_AXIS(k) position->c[k] = coordinates[k * stride + item];
}

/// (1 - d / d_max)^8 in units.
ALWAYS_INLINE long weight_of(const Elimination* e, ulong squared)
{
    const double distance = sqrt((double)squared);
    const double rest = 1 - (distance < e->least ? e->least : distance) / e->reach;
    const double squared_rest = rest * rest;
    const double fourth = squared_rest * squared_rest;
    return (long)(fourth * fourth * WEIGHT_UNITS + 0.5);
}

/// The points of a run, from `begin` up to `end`, in FOR_EACH_WITHIN_REACH().
#define FOR_EACH_OF_RUN(e, item, coordinates, begin, end, WHERE, BODY)                                                 \
    for (uint other = (begin), end_ = (end); other < end_; ++other) {                                                  \
        if (!(WHERE)) continue;                                                                                        \
        find_position(coordinates, (e)->stride, other, &there_);                                                       \
        const ulong squared = squared_distance(&position_, &there_);                                                   \
        if (squared >= (e)->squared_reach || other == item) continue;                                                  \
        BODY                                                                                                           \
    }

// FOR_EACH_WITHIN_REACH(): BODY sees `other` and `squared` of each other point within reach for which WHERE, which sees
// `other`, is true: calls are textual, as OpenCL C has no function pointers.
#if LISTED

#define FOR_EACH_WITHIN_REACH(e, item, coordinates, WHERE, BODY)                                                       \
    Position position_, there_;                                                                                        \
    find_position(coordinates, (e)->stride, item, &position_);                                                         \
    for (uint run_ = cells[item] * RUNS, last_ = run_ + RUNS; run_ < last_; ++run_)                                    \
        FOR_EACH_OF_RUN(e, item, coordinates, runs[2 * run_], runs[2 * run_ + 1], WHERE, BODY)

#else

ALWAYS_INLINE uint cell_of(const Elimination* e, uint coordinate)
{
    return (uint)(((ulong)coordinate * e->grid_size) >> 32);
}

ALWAYS_INLINE int wrapped(int cell, int n) { return cell < n ? cell : cell - n; }

/// Cells that follow each other along an axis hold points that do.
#define FOR_EACH_WITHIN_REACH(e, item, coordinates, WHERE, BODY)                                                       \
    Position position_, there_;                                                                                        \
    find_position(coordinates, (e)->stride, item, &position_);                                                         \
    const int n_ = (int)(e)->grid_size;                                                                                \
    int first_[3] = {0, 0, 0}, cells_[3] = {1, 1, 1};                                                                  \
    FOR_EACH_AXIS(k) {                                                                                                 \
        const int cell_ = (int)cell_of(e, position_.c[k]);                                                             \
        first_[k] = n_ < 3 ? 0 : cell_ > 0 ? cell_ - 1 : n_ - 1;                                                       \
        cells_[k] = min(n_, 3);                                                                                        \
    }                                                                                                                  \
    for (int z_ = 0; z_ < cells_[2]; ++z_)                                                                             \
        for (int y_ = 0; y_ < cells_[1]; ++y_) {                                                                       \
            const int row_ = (wrapped(first_[2] + z_, n_) * n_ + wrapped(first_[1] + y_, n_)) * n_;                    \
            for (int x_ = 0, run_; x_ < cells_[0]; x_ += run_) {                                                       \
                const int begin_ = wrapped(first_[0] + x_, n_);                                                        \
                run_ = min(cells_[0] - x_, n_ - begin_);                                                               \
                FOR_EACH_OF_RUN(e, item, coordinates, starts[row_ + begin_], starts[row_ + begin_ + run_], WHERE, BODY)\
            }                                                                                                          \
        }

#endif

/// Turns the weight of a point that is removed into a negative number, which keeps the weight that it had.
ALWAYS_INLINE long of_removed(long weight) { return ~weight; }

ALWAYS_INLINE bool is_heavier(global const long* weights, global const uint* ids, uint item, uint other)
{
    return weights[item] > weights[other] || (weights[item] == weights[other] && ids[item] < ids[other]);
}

/// One work-item owns one point. Nothing is known of heavier ones yet, which `heavier` says by the point itself.
kernel void weigh_points(Elimination e, global const uint* coordinates, GRID_PARAMETERS, global long* weights,
                         global uint* heavier FACTORS_PARAMETER)
{
    const uint item = get_global_id(0);
    if (item >= e.points) return;
    long sum = 0;
    FOR_EACH_WITHIN_REACH(&e, item, coordinates, true, { sum += weight_of(&e, squared); })
    sum = TIMES_FACTOR(sum, item);
    weights[item] = sum;
    heavier[item] = item;
}

/// The heaviest point within reach of one, which may be the point itself.
uint find_heaviest(const Elimination* e, global const uint* coordinates, GRID_PARAMETERS, global const uint* ids,
                   global const long* weights, uint item)
{
    uint heaviest = item;
    FOR_EACH_WITHIN_REACH(e, item, coordinates, is_heavier(weights, ids, other, heaviest), { heaviest = other; })
    return heaviest;
}

void remove_point(const Elimination* e, global const uint* coordinates, GRID_PARAMETERS, global long* weights,
                  uint item FACTORS_PARAMETER)
{
    weights[item] = of_removed(weights[item]);
    FOR_EACH_WITHIN_REACH(e, item, coordinates, weights[other] >= 0,
                          { weights[other] -= TIMES_FACTOR(weight_of(e, squared), other); })
}

#if LISTED

/// A block of cells whose points follow each other.
typedef struct { uint number, begin, end; } Tile;

ALWAYS_INLINE bool is_inside(const Elimination* e, const Tile* t, global const uint* coordinates, uint item)
{
    return item >= t->begin && item < t->end;
}

void mark_around(const Elimination* e, const Tile* t, global uchar* marks TILES_PARAMETERS)
{
    for (uint i = 0; i < TILES_AROUND; ++i) {
        const uint other = tiles_around[t->number * TILES_AROUND + i];
        if (other != NO_TILE) marks[other] = 1;
    }
}

#else

/// A block of cells; beyond the last axis, one cell.
typedef struct { uint tile[3], begin[3], end[3]; } Tile;

/// The tile of a number among those of its colour, which has a bit for each axis.
ALWAYS_INLINE void find_tile(const Elimination* e, uint colour, uint number, Tile* t)
{
    for (int k = 0; k < 3; ++k) {
        t->tile[k] = t->begin[k] = 0;
        t->end[k] = 1;
    }
    const uint of_colour = max(e->tiles / 2, 1u);
    FOR_EACH_AXIS(k) {
        t->tile[k] = e->tiles == 1 ? 0 : 2 * (number % of_colour) + (colour >> k & 1);
        number /= of_colour;
        t->begin[k] = (uint)((ulong)t->tile[k] * e->grid_size / e->tiles);
        t->end[k] = (uint)((ulong)(t->tile[k] + 1) * e->grid_size / e->tiles);
    }
}

ALWAYS_INLINE bool is_inside(const Elimination* e, const Tile* t, global const uint* coordinates, uint item)
{
    bool inside = true;
    FOR_EACH_AXIS(k) {
        const uint cell = cell_of(e, coordinates[k * e->stride + item]);
        inside = inside && cell >= t->begin[k] && cell < t->end[k];
    }
    return inside;
}

/// Marks a tile and those around it.
void mark_around(const Elimination* e, const Tile* t, global uchar* marks)
{
    const uint n = e->tiles;
    for (uint z = 0; z < (DIMENSION == 3 ? 3 : 1); ++z)
        for (uint y = 0; y < 3; ++y)
            for (uint x = 0; x < 3; ++x) {
                const uint plane = DIMENSION == 3 ? (t->tile[2] + n + z - 1) % n * n : 0;
                marks[(plane + (t->tile[1] + n + y - 1) % n) * n + (t->tile[0] + n + x - 1) % n] = 1;
            }
}

#endif

/// From a point to heavier ones, as far as they lie in the tile; the last, if none within its reach is heavier, is
/// removed. Again, until the point itself is removed, too light, or waits for another tile. `heavier` has a point that
/// was heavier, for each: it is looked for anew only where it is no longer. The number of points removed.
uint climb(const Elimination* e, const Tile* t, global const uint* coordinates, GRID_PARAMETERS,
           global const uint* ids, global long* weights, global uint* heavier, long least, uint from
           FACTORS_PARAMETER)
{
    uint removed = 0;
    uint item = from;
    while (weights[from] >= least) {
        uint next = heavier[item];
        if (!is_heavier(weights, ids, next, item)) {
            next = find_heaviest(e, coordinates, GRID_ARGUMENTS, ids, weights, item);
            heavier[item] = next;
        }
        if (next == item) {
            remove_point(e, coordinates, GRID_ARGUMENTS, weights, item FACTORS_ARGUMENT);
            ++removed;
            item = from;
        } else if (is_inside(e, t, coordinates, next)) {
            item = next;
        } else {
            break;
        }
    }
    return removed;
}

#if LISTED
#define FIND_TILE(id)                                                                                                  \
    if (colour + (id) >= e.tiles) return;                                                                              \
    const Tile t = {colour + (id), tile_starts[colour + (id)], tile_starts[colour + (id) + 1]};                        \
    const uint number = t.number;
#define FOR_EACH_OF_TILE(item) for (uint item = t.begin; item < t.end; ++item)
#else
#define FIND_TILE(id)                                                                                                  \
    uint tiles = 1;                                                                                                    \
    FOR_EACH_AXIS(k) tiles *= max(e.tiles / 2, 1u);                                                                    \
    if ((id) >= tiles) return;                                                                                         \
    Tile t;                                                                                                            \
    find_tile(&e, colour, (id), &t);                                                                                   \
    const uint number = (t.tile[2] * e.tiles + t.tile[1]) * e.tiles + t.tile[0];
#define FOR_EACH_OF_TILE(item)                                                                                         \
    for (uint z = t.begin[2]; z < t.end[2]; ++z)                                                                       \
        for (uint y = t.begin[1], row; y < t.end[1] && (row = (z * e.grid_size + y) * e.grid_size, true); ++y)         \
            for (uint item = starts[row + t.begin[0]]; item < starts[row + t.end[0]]; ++item)
#endif

/// One work-item owns one tile of a colour, and leaves those alone around which nothing has changed since, unless
/// `is_first`. No point that is lighter than `least` is removed. With listed cells `colour` is the first tile of it.
kernel void eliminate_tiles(Elimination e, uint colour, long least, uint is_first, global const uint* coordinates,
                            GRID_PARAMETERS, global const uint* ids, global long* weights, global uint* heavier,
                            global uchar* marks, global EliminationCounts* counts TILES_PARAMETERS FACTORS_PARAMETER)
{
    FIND_TILE(get_global_id(0))
    if (!is_first && !marks[number]) return;
    uint removed = 0, before;
    do {
        before = removed;
        FOR_EACH_OF_TILE(item)
        removed += climb(&e, &t, coordinates, GRID_ARGUMENTS, ids, weights, heavier, least, item FACTORS_ARGUMENT);
    } while (removed > before);
    if (removed > 0) {
        mark_around(&e, &t, marks TILES_ARGUMENTS);
        atomic_add(&counts->removed, removed);
        atomic_add(&counts->of_round, removed);
    }
    marks[number] = 0;
}
