/* SPDX-License-Identifier: MIT-0
 *
 * Poisson disk (sphere) distributions without end, from a tile set file: for renderers, games and tools.
 *
 * Lagae, Tile-Based Methods in Computer Graphics, 2007, chapter 4 and sections 3.3 and 7.6: a hash function says which
 * tile is where, so that points anywhere are found in constant time and nothing is stored but the tiles.
 * docs/tile-set-file.md describes the file. C99 or C++, this header alone; it allocates nothing and calls no
 * library. Tiles have side 1, the tile (i, j, k) has its lowest corner there; positions are from -2^31 + 2 to
 * 2^31 - 3 along each axis. */
#ifndef POISSON_TILES_H
#define POISSON_TILES_H

#include <stdint.h>

/* The tiles: what a file says, and where its points are. Nothing is copied. */
typedef struct ptiles_set
{
    uint32_t kind; /* 0: by colours of corners, 1: by colours of edges, 2: template tiles */
    uint32_t dimension, colors, tiles, points_per_tile;
    const uint16_t* points; /* tile after tile, point after point, x before y before z */
    int32_t low, step;      /* the number u is the coordinate low + step * u, in units of 1/65536 */
    int32_t below, above;   /* units that points are below or above their tile's square at most, along any axis */
    const uint16_t* ranks;  /* of each point in its tile, in the order of points; 0: the set is not ranked */
    uint32_t classes;       /* 0: points have none; else see ptiles_class */
    const unsigned char* class_points; /* of each class in a tile, four bytes each */
    uint64_t squared_min_distance;     /* that the file promises, in units of 1/65536 tile; see ptiles_min_distance */
    uint32_t equal_moments;            /* order up to which all tiles have the same moments; see ptiles_exponent */
} ptiles_set;

/* Which tile is where: every seed gives another tiling. It closes after `period` tiles along each axis, 0:
 * never. */
typedef struct ptiles_tiling
{
    ptiles_set set;
    uint32_t seed;
    int32_t period;
} ptiles_tiling;

typedef struct ptiles_point
{
    double position[3];
    int32_t tile[3]; /* the place of its tile; 0 along z in 2D */
    uint32_t index;  /* in its tile */
    uint32_t id;     /* random bits that stay with the point (and its repetitions), such as for its looks */
    double level;    /* the density, from 0 to 1, above which the point is there: see ptiles_in_window */
} ptiles_point;

static inline uint32_t ptiles_word(const unsigned char* bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}

/* How many tiles a set has that knows so many colours; 0: more than there can be. Template tiles: any number.
 */
static inline uint32_t ptiles_tile_count(uint32_t kind, uint32_t dimension, uint32_t colors)
{
    uint64_t count = 1;
    const uint32_t digits = kind == 1 ? 12 : 1u << dimension;
    for (uint32_t place = 0; place < digits; ++place) {
        count *= colors;
        if (count > 0xffffffffu) return 0;
    }
    return (uint32_t)count;
}

/* The class of a point, such as trees, bushes and stones, by its index in its tile, where points come class after class;
 * 0 where they have none. */
static inline uint32_t ptiles_class(const ptiles_set* set, uint32_t index)
{
    uint32_t c = 0;
    for (; c + 1 < set->classes; ++c) {
        const uint32_t points = ptiles_word(set->class_points + 4 * c);
        if (index < points) break;
        index -= points;
    }
    return c;
}

/* Returns the minimum distance of every tiling, in tiles, to within a unit in the last place: no two points are nearer.
 * `poissonlab tiles verify` proves it. It is 0 where the file promises none. */
static inline double ptiles_min_distance(const ptiles_set* set)
{
    const double squared = (double)set->squared_min_distance;
    double root = squared > 1 ? squared : 1, next = (root + squared / root) / 2;
    if (set->squared_min_distance == 0) return 0;
    for (; next < root; next = (root + squared / root) / 2) root = next; /* Newton's method, from above */
    return root / 65536.0;
}

/* The power spectrum of tilings goes to 0 with this power of the frequency, at least: 2, or 4, 6, 8 where the tiles of the set
 * have equal moments. */
static inline uint32_t ptiles_exponent(const ptiles_set* set) { return 2 * (set->equal_moments + 1); }

/* Says whether any density of the set is spread evenly: see ptiles_in_window. */
static inline int ptiles_is_ranked(const ptiles_set* set) { return set->ranks != 0; }

/* Looks at the `size` bytes of a file, which must stay where they are, at an even address. 0: `set` can be
 * used; otherwise what is wrong. Checks all numbers that are used here, not the checksum. */
static inline const char* ptiles_open(ptiles_set* set, const void* file, uint64_t size)
{
    const unsigned char* bytes = (const unsigned char*)file;
    const char* magic = "PTILES\r\n";
    const uint16_t one = 1;
    if (size < 128) return "shorter than the header of a tile set file";
    for (int i = 0; i < 8; ++i)
        if (bytes[i] != (unsigned char)magic[i]) return "not a tile set file";
    const uint32_t version = ptiles_word(bytes + 8);
    if (version < 1 || version > 3 || ptiles_word(bytes + 12) != 128) return "an unknown version of the file format";
    set->kind = ptiles_word(bytes + 16);
    set->dimension = ptiles_word(bytes + 20);
    set->colors = ptiles_word(bytes + 24);
    set->tiles = ptiles_word(bytes + 28);
    set->points_per_tile = ptiles_word(bytes + 32);
    set->points = (const uint16_t*)(const void*)(bytes + 128);
    set->squared_min_distance = ptiles_word(bytes + 40) | (uint64_t)ptiles_word(bytes + 44) << 32;
    set->equal_moments = version > 1 ? ptiles_word(bytes + 112) : 0;
    const uint32_t chains = version > 1 ? ptiles_word(bytes + 88) : 0; /* between tiles: no, or yes */
    set->low = chains ? -32768 : 0;
    set->step = chains ? 2 : 1;
    set->below = version > 1 ? (int32_t)ptiles_word(bytes + 100) : 0;
    set->above = version > 1 ? (int32_t)ptiles_word(bytes + 104) : 0;
    const uint32_t ranked = version > 1 ? ptiles_word(bytes + 108) : 0; /* no, or yes */
    if (ranked > 1 || chains > 1 || set->below < 0 || set->below > 32768 || set->above < 0 || set->above > 32768)
        return "an unknown kind of borders or ranks";
    if (set->kind > 2 || (set->dimension != 2 && (set->dimension != 3 || set->kind != 0)))
        return "an unknown kind of tiles";
    if (set->colors == 0 || set->tiles == 0 || set->points_per_tile == 0 || set->points_per_tile > 65536 ||
        (set->kind != 2 && set->tiles != ptiles_tile_count(set->kind, set->dimension, set->colors)))
        return "numbers of colours, tiles and points that do not fit together";
    /* Lengths of chains lie behind the points; nothing here needs them. */
    const uint64_t lengths = chains ? (uint64_t)2 * set->colors * set->colors : 0;
    const uint64_t points = (uint64_t)set->tiles * set->points_per_tile;
    const uint64_t before_ranks = points * set->dimension + lengths; /* numbers */
    set->ranks = ranked ? set->points + before_ranks : 0;
    const uint64_t end = 128 + 2 * (before_ranks + (ranked ? points : 0)), c = version > 2 ? ptiles_word(bytes + 36) : 0;
    /* Then come the number of points of each class, and two distances of each pair of classes, which are not read. */
    if (c > 32 || (version > 2 && c == 0) || size != end + 4 * c + 8 * c * (c + 1)) return "too short or too long for its points";
    set->classes = (uint32_t)c;
    set->class_points = c > 0 ? bytes + end : 0;
    uint64_t of_classes = 0;
    for (uint32_t i = 0; i < set->classes; ++i) of_classes += ptiles_word(set->class_points + 4 * i);
    if (c > 0 && of_classes != set->points_per_tile) return "classes that have not all points of a tile";
    if (*(const unsigned char*)&one != 1) return "files are little-endian, this machine is not";
    if ((uintptr_t)file % 2 != 0) return "bytes must be at an even address";
    return 0;
}

static inline uint32_t ptiles_mix(uint32_t v)
{
    v = (v ^ v >> 16) * 0x21f0aaadu;
    v = (v ^ v >> 15) * 0xd35a2d97u;
    return v ^ v >> 15;
}

static inline uint32_t ptiles_hash(uint32_t seed, uint32_t x, uint32_t y, uint32_t z)
{
    return ptiles_mix(ptiles_mix(ptiles_mix(ptiles_mix(seed) + x) + y) + z);
}

static inline uint32_t ptiles_color(const ptiles_tiling* t, uint32_t x, uint32_t y, uint32_t z)
{
    return ptiles_hash(t->seed, x, y, z) % t->set.colors;
}

/* A place as the hash function takes it, and those after and before it, on the circle of a period or of 2^32.
 */
static inline uint32_t ptiles_place(int32_t i, int32_t period)
{
    if (period != 0) i = i % period < 0 ? i % period + period : i % period;
    return (uint32_t)i;
}
static inline uint32_t ptiles_after(uint32_t x, int32_t period) { return x + 1 == (uint32_t)period ? 0 : x + 1; }
static inline uint32_t ptiles_before(uint32_t x, int32_t period) { return (x == 0 ? (uint32_t)period : x) - 1; }

/* The digits of a corner tile: NE, SE, SW, NW at the height z. */
static inline uint32_t ptiles_corners(const ptiles_tiling* t, uint32_t x, uint32_t y, uint32_t z)
{
    const uint32_t c = t->set.colors, east = ptiles_after(x, t->period), north = ptiles_after(y, t->period);
    const uint32_t ne = ptiles_color(t, east, north, z), se = ptiles_color(t, east, y, z);
    return ((ne * c + se) * c + ptiles_color(t, x, y, z)) * c + ptiles_color(t, x, north, z);
}

/* The digits of an edge tile: N, E, S, W; then, two at each corner, NE, SE, SW, NW, what leaves the tile
 * there. */
static inline uint32_t ptiles_edges(const ptiles_tiling* t, uint32_t x, uint32_t y)
{
    const uint32_t east = ptiles_after(x, t->period), west = ptiles_before(x, t->period);
    const uint32_t north = ptiles_after(y, t->period), south = ptiles_before(y, t->period);
    /* Each edge by the lattice point from which it goes east (0) or north (1). */
    const uint32_t edges[12][3] = {{x, north, 0},    {east, y, 1},     {x, y, 0},        {x, y, 1},
                                   {east, north, 0}, {east, north, 1}, {east, y, 0},     {east, south, 1},
                                   {west, y, 0},     {x, south, 1},    {west, north, 0}, {x, north, 1}};
    uint32_t tile = 0;
    for (int e = 0; e < 12; ++e) tile = tile * t->set.colors + ptiles_color(t, edges[e][0], edges[e][1], edges[e][2]);
    return tile;
}

/* The number of the tile at a place; k: 0 in 2D. */
static inline uint32_t ptiles_tile(const ptiles_tiling* t, int32_t i, int32_t j, int32_t k)
{
    const uint32_t x = ptiles_place(i, t->period), y = ptiles_place(j, t->period), z = ptiles_place(k, t->period);
    const uint32_t c = t->set.colors;
    if (t->set.kind == 2) return ptiles_hash(t->seed, x, y, 0) % t->set.tiles;
    if (t->set.kind == 1) return ptiles_edges(t, x, y);
    if (t->set.dimension == 2) return ptiles_corners(t, x, y, 0);
    return ptiles_corners(t, x, y, ptiles_after(z, t->period)) * (c * c * c * c) + ptiles_corners(t, x, y, z);
}

/* The numbers of a tile's points: points_per_tile times `dimension`. */
static inline const uint16_t* ptiles_points(const ptiles_set* set, uint32_t tile)
{
    return set->points + (uint64_t)tile * set->points_per_tile * set->dimension;
}

/* A number as a coordinate, in tiles from the tile's lowest corner. */
static inline double ptiles_coordinate(const ptiles_set* set, uint16_t number)
{
    return (set->low + set->step * (int32_t)number) / 65536.0;
}

/* The point of the tile at this place with these numbers. */
static inline ptiles_point ptiles_point_at(const ptiles_tiling* t, const int32_t tile[3], uint32_t index,
                                           const uint16_t* numbers)
{
    ptiles_point p = {{0, 0, 0}, {tile[0], tile[1], tile[2]}, index, 0, 0};
    uint32_t place[3];
    for (uint32_t a = 0; a < 3; ++a) {
        place[a] = ptiles_place(tile[a], t->period);
        if (a < t->set.dimension) p.position[a] = tile[a] + ptiles_coordinate(&t->set, numbers[a]);
    }
    p.id = ptiles_mix(ptiles_hash(t->seed, place[0], place[1], place[2]) + 1 + index);
    if (t->set.ranks)
        p.level = (t->set.ranks[(numbers - t->set.points) / t->set.dimension] + 0.5) / t->set.points_per_tile;
    else
        p.level = p.id / 4294967296.0;
    return p;
}

/* Points of a ranked tile with a rank below this have a level below the density. */
static inline uint32_t ptiles_ranks_below(const ptiles_set* set, double density)
{
    const uint32_t n = set->points_per_tile;
    uint32_t rank = density >= 1 ? n : density > 0 ? (uint32_t)(density * n) : 0;
    while (rank > 0 && (rank - 0.5) / n >= density) --rank;
    while (rank < n && (rank + 0.5) / n < density) ++rank;
    return rank;
}

static inline int32_t ptiles_floor(double x) { return (int32_t)x - (x < (int32_t)x); }

/* All points p with low <= p < high along each axis: how many there are, the first `capacity` of them in
 * `points`. Rows of tiles from south to north (3D: layers from the bottom), in each from west to east.
 *
 * Of these, those with a level below `density`: 1 for all of them, 0.25 for a quarter. Ranked sets (tiles build
 * --ranked) are spread evenly at any density, others lose points at random. More density adds points and moves none, so
 * that a density that differs from place to place is: the largest one here, then of each point whether its level is
 * below the density at its position. */
static inline uint64_t ptiles_in_window(const ptiles_tiling* t, const double* low, const double* high,
                                        ptiles_point* points, uint64_t capacity, double density)
{
    const uint32_t d = t->set.dimension;
    const uint16_t* ranks = density < 1 ? t->set.ranks : 0; /* that have to be looked at */
    const uint32_t ranks_below = ptiles_ranks_below(&t->set, density);
    int32_t at[3], first[3] = {0, 0, 0}, last[3] = {0, 0, 0};
    uint64_t found = 0;
    for (uint32_t a = 0; a < d; ++a) {
        first[a] = ptiles_floor(low[a] - t->set.above / 65536.0);
        last[a] = ptiles_floor(high[a] + t->set.below / 65536.0);
    }
    for (at[2] = first[2]; at[2] <= last[2]; ++at[2])
        for (at[1] = first[1]; at[1] <= last[1]; ++at[1])
            for (at[0] = first[0]; at[0] <= last[0]; ++at[0]) {
                const uint32_t tile = ptiles_tile(t, at[0], at[1], at[2]);
                const uint16_t* numbers = ptiles_points(&t->set, tile);
                const uint64_t first_point = (uint64_t)tile * t->set.points_per_tile;
                for (uint32_t n = 0; n < t->set.points_per_tile; ++n, numbers += d) {
                    int inside = !ranks || ranks[first_point + n] < ranks_below;
                    for (uint32_t a = 0; a < d; ++a) {
                        const double x = at[a] + ptiles_coordinate(&t->set, numbers[a]);
                        inside = inside && x >= low[a] && x < high[a];
                    }
                    if (!inside) continue;
                    if (density < 1 && !ranks && ptiles_point_at(t, at, n, numbers).level >= density) continue;
                    if (found < capacity) points[found] = ptiles_point_at(t, at, n, numbers);
                    ++found;
                }
            }
    return found;
}

/* The squared distance of x, in the tile 0 at `f`, from where points of the tile `offset` tiles away along this axis
 * can be, which is `below` and `above` more than its square. */
static inline double ptiles_gap(double f, int32_t offset, double below, double above)
{
    const double gap = offset > 0 ? offset - below - f : offset < 0 ? f - (offset + 1 + above) : 0;
    return gap > 0 ? gap * gap : 0;
}

/* If one of a tile's points is nearer than `squared`, the nearest of them, and its squared distance. `f` is
 * the position relative to the lowest corner of the tile `home`. Distances are compared in steps of the stored
 * numbers, which saves a product a coordinate. */
static inline void ptiles_visit(const ptiles_tiling* t, const int32_t home[3], const double f[3],
                                const int32_t offset[3], double* squared, ptiles_point* nearest)
{
    const int32_t tile[3] = {home[0] + offset[0], home[1] + offset[1], home[2] + offset[2]};
    const uint32_t d = t->set.dimension;
    const uint16_t* numbers = ptiles_points(&t->set, ptiles_tile(t, tile[0], tile[1], tile[2]));
    const double step = t->set.step / 65536.0;
    double limit = *squared / (step * step), at[3];
    uint32_t best = t->set.points_per_tile; /* none */
    for (uint32_t a = 0; a < 3; ++a) at[a] = (f[a] - offset[a] - t->set.low / 65536.0) / step;
    for (uint32_t n = 0; n < t->set.points_per_tile; ++n) {
        double sum = 0;
        for (uint32_t a = 0; a < d; ++a) {
            const double difference = numbers[n * d + a] - at[a];
            sum += difference * difference;
        }
        if (sum >= limit) continue;
        limit = sum;
        best = n;
    }
    if (best == t->set.points_per_tile) return;
    *squared = limit * (step * step);
    *nearest = ptiles_point_at(t, tile, best, numbers + best * d);
}

/* The point that is nearest to a position, of several the one in the tile that is visited first: rings of
 * tiles around that of the position, as long as they can have a nearer point. Returns the squared distance.
 */
static inline double ptiles_nearest(const ptiles_tiling* t, const double* position, ptiles_point* nearest)
{
    const int32_t d = (int32_t)t->set.dimension;
    const ptiles_point none = {{0, 0, 0}, {0, 0, 0}, 0, 0, 0};
    int32_t home[3] = {0, 0, 0}, o[3];
    const double below = t->set.below / 65536.0, above = t->set.above / 65536.0;
    double f[3] = {0, 0, 0}, squared = 1e300, border = 1; /* of the home tile */
    *nearest = none;
    for (int32_t a = 0; a < d; ++a) {
        home[a] = ptiles_floor(position[a]);
        f[a] = position[a] - home[a];
        if (f[a] < border) border = f[a];
        if (1 - f[a] < border) border = 1 - f[a];
    }
    for (int32_t ring = 0;; ++ring) {
        const double away = border + ring - 1 - (below > above ? below : above); /* of points in the ring, at least */
        if (ring > 0 && away > 0 && away * away >= squared) break;
        const int32_t layers = d == 3 ? ring : 0;
        for (o[2] = -layers; o[2] <= layers; ++o[2])
            for (o[1] = -ring; o[1] <= ring; ++o[1]) {
                /* A row inside the ring has only its ends in it. */
                const int outer = o[1] == -ring || o[1] == ring || (d == 3 && (o[2] == -ring || o[2] == ring));
                for (o[0] = -ring; o[0] <= ring; o[0] += outer || ring == 0 ? 1 : 2 * ring)
                    if (ptiles_gap(f[0], o[0], below, above) + ptiles_gap(f[1], o[1], below, above) +
                            ptiles_gap(f[2], o[2], below, above) <
                        squared)
                        ptiles_visit(t, home, f, o, &squared, nearest);
            }
    }
    return squared;
}

#endif
