/* SPDX-License-Identifier: MIT-0
 *
 * Objects without end that do not overlap: the procedural object distribution function, for shaders and tools.
 *
 * Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.6: at any place, the nearest point of a Poisson disk
 * tiling, whether the place is in that point's disk, and numbers that belong to the point, for its object's size, turn
 * and looks. Objects stay in their disks, so they never overlap. The nearest point is that of ptiles_nearest, found
 * sooner: points are sorted along x, and the search ends at any point nearer than the disk radius.
 *
 * Positions are in tiles: where a unit square is to have `s` objects on average, positions times the square root of
 * s / points_per_tile (in space: the third root).
 *
 * C99 or C++, this header and poisson_tiles.h alone; it allocates nothing and calls no library. */
#ifndef OBJECT_DISTRIBUTION_H
#define OBJECT_DISTRIBUTION_H

#include "poisson_tiles.h"

enum
{
    POBJECTS_STARTS = 32 /* parts of a tile's numbers along x: where each begins among its sorted points */
};

/* A distribution: which tiling, and how large its disks are. */
typedef struct pobjects
{
    ptiles_tiling tiling;
    const uint16_t* sorted; /* made by pobjects_sort() */
    double radius;          /* of the disks, in tiles: half of the minimum distance that the tile set promises */
} pobjects;

/* The tiles around the last place, so that places next to each other look them up once, and its object, which is often
 * that of the next place, and never much farther. Begin with all zeros. */
typedef struct pobjects_cursor
{
    int32_t home[3];
    uint32_t known; /* bits of those that were looked up */
    uint32_t tiles[27];
    uint32_t tile;          /* the number of the object's tile */
    const uint16_t* sorted; /* the object among the sorted points; 0: there is none yet */
    ptiles_point point;
} pobjects_cursor;

/* The object at a place. */
typedef struct pobjects_object
{
    ptiles_point point;
    double offset[3]; /* of the place from the point, in tiles */
    double squared;   /* distance, in tiles */
    int inside;       /* whether the place is in the point's disk */
} pobjects_object;

/* How many numbers of 16 bits pobjects_sort() writes for a tile, and for a set. */
static inline uint64_t pobjects_stride(const ptiles_set* set)
{
    return (uint64_t)set->points_per_tile * (set->dimension + 1) + POBJECTS_STARTS;
}
static inline uint64_t pobjects_size(const ptiles_set* set) { return set->tiles * pobjects_stride(set); }

/* Writes the points of each tile sorted along x: coordinates as they are stored, then the point's index; and where the
 * points of each 32nd of all numbers begin. `sorted` has room for pobjects_size() numbers, and stays yours. */
static inline void pobjects_sort(const ptiles_set* set, uint16_t* sorted)
{
    const uint32_t n = set->points_per_tile, d = set->dimension, wide = d + 1;
    for (uint32_t tile = 0; tile < set->tiles; ++tile, sorted += pobjects_stride(set)) {
        const uint16_t* points = ptiles_points(set, tile);
        uint16_t* starts = sorted + (uint64_t)n * wide;
        uint32_t gap = n;
        for (uint32_t i = 0; i < n; ++i) sorted[i * wide] = (uint16_t)i; /* indices first, points by them later */
        while (gap > 0) {
            gap = gap == 2 ? 1 : gap * 5 / 11;
            for (uint32_t i = gap; gap > 0 && i < n; ++i) {
                const uint16_t index = sorted[i * wide];
                uint32_t k = i;
                for (; k >= gap; k -= gap) {
                    const uint16_t other = sorted[(k - gap) * wide];
                    const uint16_t x = points[index * d], there = points[other * d];
                    if (there < x || (there == x && other < index)) break;
                    sorted[k * wide] = other;
                }
                sorted[k * wide] = index;
            }
        }
        for (uint32_t i = 0; i < n; ++i) {
            const uint16_t index = sorted[i * wide];
            for (uint32_t a = 0; a < d; ++a) sorted[i * wide + a] = points[index * d + a];
            sorted[i * wide + d] = index;
        }
        for (uint32_t part = 0, i = 0; part < POBJECTS_STARTS; ++part) {
            while (i < n && sorted[i * wide] < part * (65536 / POBJECTS_STARTS)) ++i;
            starts[part] = (uint16_t)i;
        }
    }
}

/* A distribution with disks of this radius in tiles: half of the minimum distance that `tiles verify` proves. */
static inline pobjects pobjects_open(const ptiles_tiling* tiling, const uint16_t* sorted, double radius)
{
    pobjects o = {*tiling, sorted, radius};
    return o;
}

static inline uint32_t pobjects_tile(const pobjects* o, pobjects_cursor* cursor, const int32_t home[3],
                                     const int32_t offset[3])
{
    const int32_t far = offset[0] * offset[0] > 1 || offset[1] * offset[1] > 1 || offset[2] * offset[2] > 1;
    if (!cursor || far) return ptiles_tile(&o->tiling, home[0] + offset[0], home[1] + offset[1], home[2] + offset[2]);
    const int32_t place = ((offset[2] + 1) * 3 + offset[1] + 1) * 3 + offset[0] + 1;
    if (!(cursor->known >> place & 1)) {
        cursor->tiles[place] = ptiles_tile(&o->tiling, home[0] + offset[0], home[1] + offset[1], home[2] + offset[2]);
        cursor->known |= 1u << place;
    }
    return cursor->tiles[place];
}

/* The nearest point found so far: its squared distance in steps of the stored numbers, and where it is. */
typedef struct pobjects_best
{
    double squared;
    int32_t offset[3];
    uint32_t tile; /* its number */
    uint32_t index;
    const uint16_t* sorted;
} pobjects_best;

/* Looks at a point of a tile. Of points of one tile at the same distance the first one in the set is taken, as by
 * ptiles_nearest. */
static inline void pobjects_look(const uint16_t* point, uint32_t d, const double at[3], uint32_t tile,
                                 const int32_t offset[3], pobjects_best* best)
{
    double sum = 0;
    for (uint32_t a = 0; a < d; ++a) {
        const double difference = point[a] - at[a];
        sum += difference * difference;
    }
    if (sum > best->squared) return;
    if (sum == best->squared && (best->offset[0] != offset[0] || best->offset[1] != offset[1] ||
                                 best->offset[2] != offset[2] || best->index < point[d]))
        return;
    best->squared = sum;
    for (int a = 0; a < 3; ++a) best->offset[a] = offset[a];
    best->tile = tile;
    best->index = point[d];
    best->sorted = point;
}

/* The place `f` of the home tile in the numbers of the tile that is so many tiles away. */
static inline void pobjects_numbers(const ptiles_set* set, const double f[3], const int32_t offset[3], double at[3])
{
    for (uint32_t a = 0; a < 3; ++a) at[a] = (f[a] - offset[a] - set->low / 65536.0) / (set->step / 65536.0);
}

/* Looks at the object of the last place. Unless it is nearer than `enough`, only its distance counts, and a little
 * more: the search finds it again, or one that is nearer. */
static inline void pobjects_look_back(const pobjects* o, const pobjects_cursor* cursor, const int32_t home[3],
                                      const double f[3], double enough, pobjects_best* best)
{
    int32_t offset[3];
    double at[3];
    if (!cursor || !cursor->sorted) return;
    for (int a = 0; a < 3; ++a) {
        const uint32_t away = (uint32_t)cursor->point.tile[a] - (uint32_t)home[a] + 2;
        if (away > 4) return;
        offset[a] = (int32_t)away - 2;
    }
    pobjects_numbers(&o->tiling.set, f, offset, at);
    pobjects_look(cursor->sorted, o->tiling.set.dimension, at, cursor->tile, offset, best);
    if (best->squared >= enough) best->squared *= 1 + 1e-9;
}

/* Looks at the points of a tile from the place outwards along x, as long as they can be nearer. */
static inline void pobjects_visit(const pobjects* o, uint32_t tile, const double f[3], const int32_t offset[3],
                                  pobjects_best* best)
{
    const ptiles_set* set = &o->tiling.set;
    const uint32_t n = set->points_per_tile, d = set->dimension, wide = d + 1;
    const uint16_t* sorted = o->sorted + tile * pobjects_stride(set);
    double at[3];
    pobjects_numbers(set, f, offset, at);
    const uint32_t part = at[0] <= 0       ? 0
                          : at[0] >= 65535 ? POBJECTS_STARTS - 1
                                           : (uint32_t)at[0] / (65536 / POBJECTS_STARTS);
    const uint32_t first = sorted[n * wide + part];
    for (uint32_t i = first; i < n; ++i) {
        const double x = sorted[i * wide] - at[0];
        if (x > 0 && x * x > best->squared) break;
        pobjects_look(sorted + i * wide, d, at, tile, offset, best);
    }
    for (uint32_t i = first; i-- > 0;) {
        const double x = at[0] - sorted[i * wide];
        if (x > 0 && x * x > best->squared) break;
        pobjects_look(sorted + i * wide, d, at, tile, offset, best);
    }
}

/* The object at a position, in tiles. `cursor`: of places that follow each other closely, or 0. */
static inline pobjects_object pobjects_at(const pobjects* o, const double* position, pobjects_cursor* cursor)
{
    const ptiles_set* set = &o->tiling.set;
    const int32_t d = (int32_t)set->dimension;
    const double step = set->step / 65536.0, below = set->below / 65536.0, above = set->above / 65536.0;
    const double enough = o->radius * o->radius / (step * step) * (1 - 1e-9); /* nothing else can be nearer */
    int32_t home[3] = {0, 0, 0}, offset[3] = {0, 0, 0};
    double f[3] = {0, 0, 0}, border = 1;
    pobjects_best best = {1e300, {0, 0, 0}, 0, 0, 0};
    for (int32_t a = 0; a < d; ++a) {
        home[a] = ptiles_floor(position[a]);
        f[a] = position[a] - home[a];
        if (f[a] < border) border = f[a];
        if (1 - f[a] < border) border = 1 - f[a];
    }
    if (cursor && (cursor->home[0] != home[0] || cursor->home[1] != home[1] || cursor->home[2] != home[2])) {
        for (int a = 0; a < 3; ++a) cursor->home[a] = home[a];
        cursor->known = 0;
    }
    pobjects_look_back(o, cursor, home, f, enough, &best);
    if (best.squared >= enough) pobjects_visit(o, pobjects_tile(o, cursor, home, offset), f, offset, &best);
    for (int32_t ring = 1; best.squared >= enough; ++ring) {
        const double away = border + ring - 1 - (below > above ? below : above);
        if (away > 0 && away * away >= best.squared * (step * step)) break;
        const int32_t layers = d == 3 ? ring : 0;
        for (offset[2] = -layers; offset[2] <= layers; ++offset[2])
            for (offset[1] = -ring; offset[1] <= ring; ++offset[1]) {
                const int outer =
                    offset[1] == -ring || offset[1] == ring || (d == 3 && (offset[2] == -ring || offset[2] == ring));
                for (offset[0] = -ring; offset[0] <= ring; offset[0] += outer ? 1 : 2 * ring) {
                    const double gap = ptiles_gap(f[0], offset[0], below, above) +
                                       ptiles_gap(f[1], offset[1], below, above) +
                                       ptiles_gap(f[2], offset[2], below, above);
                    if (gap >= best.squared * (step * step) || best.squared < enough) continue;
                    pobjects_visit(o, pobjects_tile(o, cursor, home, offset), f, offset, &best);
                }
            }
    }
    const int32_t place[3] = {home[0] + best.offset[0], home[1] + best.offset[1], home[2] + best.offset[2]};
    const uint16_t* numbers = ptiles_points(set, best.tile) + (uint64_t)best.index * set->dimension;
    pobjects_object object = {{{0, 0, 0}, {0, 0, 0}, 0, 0, 0}, {0, 0, 0}, 0, 0};
    if (cursor && cursor->sorted == best.sorted && cursor->point.tile[0] == place[0] &&
        cursor->point.tile[1] == place[1] && cursor->point.tile[2] == place[2])
        object.point = cursor->point;
    else
        object.point = ptiles_point_at(&o->tiling, place, best.index, numbers);
    if (cursor) {
        cursor->tile = best.tile;
        cursor->sorted = best.sorted;
        cursor->point = object.point;
    }
    for (int32_t a = 0; a < d; ++a) object.offset[a] = f[a] - best.offset[a] - ptiles_coordinate(set, numbers[a]);
    object.squared = best.squared * (step * step);
    object.inside = object.squared < o->radius * o->radius;
    return object;
}

/* 32 random bits of an object for a purpose, any number. */
static inline uint32_t pobjects_bits(uint32_t id, uint32_t purpose)
{
    return ptiles_mix(ptiles_mix(id ^ 0x9e3779b9u) + purpose);
}

/* A number from 0 to 1, 1 excluded. */
static inline double pobjects_uniform(uint32_t id, uint32_t purpose)
{
    return (pobjects_bits(id, purpose) >> 8) / 16777216.0;
}

/* A number with mean 0 and standard deviation 1, about normal: a sum of 12 uniform ones, from -6 to 6. Exact, and so
 * the same everywhere. Takes the purposes from `purpose` to `purpose` + 5. */
static inline double pobjects_normal(uint32_t id, uint32_t purpose)
{
    int32_t sum = -6 * 65535;
    for (uint32_t i = 0; i < 6; ++i) {
        const uint32_t bits = pobjects_bits(id, purpose + i);
        sum += (int32_t)(bits >> 16) + (int32_t)(bits & 0xffff);
    }
    return sum / 65536.0;
}

/* The place in an object's own coordinates: its disk, made smaller by `size` (0 to 1), is the unit disk, turned by the
 * angle with this cosine and sine. With an aspect above 1 the object is that much longer along x than along y, below 1
 * the other way round. Returns whether the place may be in the object; else the background is there. */
static inline int pobjects_local(const pobjects* o, const pobjects_object* object, double size, double cosine,
                                 double sine, double aspect, double u[2])
{
    const double disk = o->radius * size, x = object->offset[0], y = object->offset[1];
    if (!(x * x + y * y < disk * disk)) return 0;
    u[0] = (cosine * x + sine * y) / disk;
    u[1] = (cosine * y - sine * x) / disk;
    if (aspect >= 1)
        u[1] *= aspect;
    else
        u[0] /= aspect;
    return u[0] * u[0] + u[1] * u[1] < 1;
}

#endif
