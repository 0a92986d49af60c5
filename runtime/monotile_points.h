/* SPDX-License-Identifier: MIT-0
 *
 * Points without end from one tile that never repeats: hats or spectres (Smith, Myers, Kaplan, Goodman-Strauss 2024)
 * with points in each tile, from a file of `poissonlab tiles build hat` or `spectre`.
 *
 * docs/tile-set-file.md describes the file. C99 or C++, this header and monotile_set.h alone; it allocates nothing and
 * calls no library. Lengths are in units of the tile's edges: edges of spectres have length 1, those of hats 1 and
 * sqrt(3). A window is placed by two integers, exactly, however far away it is: its origin is (X, Y) for spectres and
 * (X, sqrt(3) Y) for hats, and X and Y are from -2^40 to 2^40. Positions are seen from this origin, and are rounded to
 * 2^-32. All arithmetic is on integers or exact, so that all compilers and monotile_points.js find the same bits.
 *
 *     pmono_set set;
 *     const char* problem = pmono_open(&set, bytes, size);
 *     uint64_t n = pmono_in_window(&set, seed, origin, low, high, points, capacity, 1);
 */
#ifndef MONOTILE_POINTS_H
#define MONOTILE_POINTS_H

#include "monotile_set.h"

typedef struct pmono_point
{
    double position[2]; /* seen from the window's origin */
    double level;       /* the density, from 0 to 1, above which the point is there */
    uint32_t id;        /* random bits that stay with the point */
    uint32_t index;     /* in its tile */
} pmono_point;

/* A window, and the points that were found in it. */
typedef struct pmono_search
{
    const pmono_set* set;
    const double *low, *high;
    pmono_point* points;
    uint64_t capacity, found;
    double density;
    double visits; /* that are left: tables that lie must not make a search without end */
} pmono_search;

/* A tile on the way to a window. */
typedef struct pmono_tile
{
    uint32_t state, turn;
    int64_t at[4];          /* where its parts of the last level begin, seen from the window's origin */
    uint32_t hash;          /* of its place in the divisions */
    uint32_t threshold;     /* of these the tiles of one level are spread evenly over all numbers of 32 bits */
    uint32_t part, of_part; /* its number among all parts; the number of parts of the tile that it is a part of */
    uint32_t whole;         /* the threshold of that tile */
} pmono_tile;

static inline int pmono_is_near(const pmono_search* s, const pmono_tile* tile, uint32_t divisions)
{
    double squared = 0;
    for (int axis = 0; axis < 2; ++axis) {
        const double x = pmono_rough(s->set, tile->at, axis);
        const double gap = x < s->low[axis] ? s->low[axis] - x : x > s->high[axis] ? x - s->high[axis] : 0;
        squared += gap * gap;
    }
    /* Rounding of places is far below these margins. */
    const double reach = s->set->reach[divisions] * (1 + 1e-9) + 0.01;
    return squared <= reach * reach;
}

static inline void pmono_add_points(pmono_search* s, const pmono_tile* tile)
{
    const pmono_set* set = s->set;
    const uint32_t n = set->points_per_tile;
    const int64_t x = pmono_fixed(set, tile->at, 0), y = pmono_fixed(set, tile->at, 1);
    for (uint32_t i = 0; i < n; ++i) {
        int64_t place[4];
        pmono_point_place(set, tile->state, i, place);
        pmono_turn(place, tile->turn);
        pmono_point p;
        p.position[0] = (double)(x + pmono_fixed_part(set, place, 0)) / 4294967296.0;
        p.position[1] = (double)(y + pmono_fixed_part(set, place, 1)) / 4294967296.0;
        const uint64_t rank = pmono_half(set->rank + 2 * ((uint64_t)tile->part * n + i));
        p.level = (double)(((rank << 32) + tile->whole) / (tile->of_part * n)) / 4294967296.0;
        p.id = pmono_mix(tile->hash + 0x9e3779b9u * (i + 1));
        p.index = i;
        if (p.position[0] < s->low[0] || p.position[0] >= s->high[0] || p.position[1] < s->low[1] ||
            p.position[1] >= s->high[1] || p.level >= s->density)
            continue;
        if (s->found < s->capacity) s->points[s->found] = p;
        ++s->found;
    }
}

static inline void pmono_walk(pmono_search* s, const pmono_tile* tile, uint32_t divisions)
{
    const pmono_set* set = s->set;
    if (--s->visits < 0 || !pmono_is_near(s, tile, divisions)) return;
    if (divisions == 0) {
        pmono_add_points(s, tile);
        return;
    }
    const unsigned char* record = set->state + 8 * (uint64_t)tile->state;
    const uint32_t first = pmono_word(record), count = pmono_half(record + 4);
    const uint32_t turn = set->flips ? (6 - tile->turn) % 6 : tile->turn;
    for (uint32_t i = 0; i < count; ++i) {
        const unsigned char* part = set->part + 16 * (uint64_t)(first + i);
        pmono_tile next;
        int64_t at[4];
        pmono_place(part, at);
        pmono_turn(at, turn);
        for (int k = 0; k < 4; ++k) next.at[k] = tile->at[k];
        pmono_add_image(set, divisions - 1, at, next.at);
        next.state = pmono_word(part);
        next.turn = (turn + pmono_half(part + 12)) % 6;
        next.hash = pmono_mix(tile->hash + i + 1);
        next.part = first + i;
        next.of_part = count;
        next.whole = tile->threshold;
        /* The parts of a tile take turns in an order that begins anywhere. */
        const uint64_t order = (pmono_half(part + 14) + tile->hash % count) % count;
        next.threshold = (uint32_t)(((order << 32) + tile->threshold) / count);
        pmono_walk(s, &next, divisions - 1);
    }
}

/* All points p with low <= p < high along each axis, seen from the origin, in the order of the divisions: how many
 * there are, the first `capacity` of them in `points`. Windows are from -2^20 to 2^20. The seed decides levels and ids,
 * not the places of points.
 *
 * Of these, those with a level below `density`: 1 for all of them, 0.25 for a quarter, spread evenly. More density adds
 * points and moves none, so that a density that differs from place to place is: the largest one here, then of each
 * point whether its level is below the density at its position. */
static inline uint64_t pmono_in_window(const pmono_set* set, uint32_t seed, const int64_t* origin, const double* low,
                                       const double* high, pmono_point* points, uint64_t capacity, double density)
{
    pmono_search s = {set, low, high, points, capacity, 0, density, 0};
    for (int axis = 0; axis < 2; ++axis)
        if (!(low[axis] >= -1048576 && high[axis] <= 1048576 && low[axis] < high[axis]) ||
            origin[axis] < -(INT64_C(1) << 40) || origin[axis] > INT64_C(1) << 40)
            return 0;
    /* Tilings have fewer than half a tile to visit on each unit of area, and few more on the way there. */
    s.visits = 100000 + 50 * (high[0] - low[0] + 2 * set->reach[0]) * (high[1] - low[1] + 2 * set->reach[0]);
    for (uint32_t i = 0; i < set->starts; ++i) {
        const unsigned char* record = set->start + 16 * i;
        pmono_tile tile = {pmono_word(record), pmono_half(record + 12), {-origin[0], 0, 0, -origin[1]}, 0, 0, 0, 1, 0};
        int64_t at[4], once[4] = {0, 0, 0, 0};
        pmono_place(record, at);
        for (int k = 0; k < 4; ++k) /* the images of the ring's units after one division, which are divided on */
            for (int j = 0; j < 4; ++j) once[j] += set->powers[1][4 * k + j] * at[k];
        pmono_add_image(set, pmono_divisions - 1, once, tile.at);
        tile.hash = pmono_mix(pmono_mix(seed) + i);
        tile.threshold = tile.hash;
        pmono_walk(&s, &tile, pmono_divisions);
    }
    return s.found;
}

#endif
