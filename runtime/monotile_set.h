/* SPDX-License-Identifier: MIT-0
 *
 * Tile set files with points in one tile that never repeats: what is in a file, and whether it can be used. See
 * monotile_points.h, which finds points by it. docs/tile-set-file.md describes the file. */
#ifndef MONOTILE_SET_H
#define MONOTILE_SET_H

#include <stdint.h>

enum
{
    pmono_divisions = 32, /* of the two tiles around the origin */
    pmono_most_parts = 16 /* of a tile, and as many points */
};

/* What a file says, and where its tables are. Only numbers of levels are copied. */
typedef struct pmono_set
{
    uint32_t tiling; /* 0: hats, 1: spectres */
    uint32_t states; /* that tiles have by the tiles around them */
    uint32_t points_per_tile;
    uint32_t parts, starts;
    uint32_t flips;                /* 1: each division mirrors what it makes */
    uint32_t odd;                  /* the squared length of edges at 30, 90, ... degrees */
    uint64_t squared_min_distance; /* that the file promises, in units of 2^-16, rounded down */
    const unsigned char *distances, *start, *part, *state, *place, *rank;
    int64_t powers[pmono_divisions][16]; /* [n]: the images of 1, z, z^2, z^3 after n divisions, z = exp(2 pi i/12) */
    double reach[pmono_divisions + 1];   /* [n]: how far points are from a tile that is divided n times, at most */
} pmono_set;

static inline uint32_t pmono_word(const unsigned char* bytes)
{
    return bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 | (uint32_t)bytes[3] << 24;
}
static inline uint32_t pmono_half(const unsigned char* bytes) { return bytes[0] | (uint32_t)bytes[1] << 8; }
static inline int32_t pmono_signed_half(const unsigned char* bytes)
{
    const int32_t u = (int32_t)pmono_half(bytes);
    return u < 32768 ? u : u - 65536;
}
static inline int32_t pmono_signed_word(const unsigned char* bytes)
{
    const int64_t u = pmono_word(bytes);
    return (int32_t)(u < 2147483648 ? u : u - 4294967296);
}
static inline uint32_t pmono_mix(uint32_t v)
{
    v = (v ^ v >> 16) * 0x21f0aaadu;
    v = (v ^ v >> 15) * 0xd35a2d97u;
    return v ^ v >> 15;
}

/* The square root to within a unit in the last place, by Newton's method from above. */
static inline double pmono_root(double squared)
{
    double root = squared > 1 ? squared : 1, next = (root + squared / root) / 2;
    if (!(squared > 0)) return 0;
    for (; next < root; next = (root + squared / root) / 2) root = next;
    return root;
}

/* Returns the minimum distance of every window, which `poissonlab tiles verify` proves; 0 where the file promises none.
 */
static inline double pmono_min_distance(const pmono_set* set)
{
    return pmono_root((double)set->squared_min_distance) / 65536.0;
}

/* The power spectrum goes to 0 at least with this power of the frequency, between its peaks. */
static inline uint32_t pmono_exponent(const pmono_set* set)
{
    (void)set;
    return 2;
}

/* Says whether any density is spread evenly. All sets of this kind have ranks. */
static inline int pmono_is_ranked(const pmono_set* set)
{
    (void)set;
    return 1;
}

/* Turns a number a + b z + c z^2 + d z^3 of the ring by some sixths of a turn. */
static inline void pmono_turn(int64_t* n, uint32_t sixths)
{
    for (; sixths > 0; --sixths) {
        const int64_t a = n[0], b = n[1], c = n[2], d = n[3];
        n[0] = -c, n[1] = -d, n[2] = a + c, n[3] = b + d;
    }
}

/* Twice the coordinate along an axis: whole + root * sqrt(3). */
static inline void pmono_twice(const pmono_set* set, const int64_t* n, int axis, int64_t* whole, int64_t* root)
{
    const int64_t even = axis ? n[2] : n[1], other = axis ? n[1] + 2 * n[3] : 2 * n[0] + n[2];
    *whole = set->odd == 1 ? other : axis ? 0 : other + 3 * n[1];
    *root = set->odd == 1 ? even : axis ? even + other : 0;
}

/* A coordinate in units of 2^-32. Integers up to 2^42 times sqrt(3) need more than 64 bits: what is left of the sum
 * needs fewer, so that it is computed modulo 2^64, with sqrt(3) = s / 2^83 in four digits of 21 bits. */
static inline int64_t pmono_fixed(const pmono_set* set, const int64_t* n, int axis)
{
    int64_t whole, root;
    pmono_twice(set, n, axis, &whole, &root);
    const uint64_t q = (uint64_t)(root < 0 ? -root : root);
    uint64_t sum = 1649569u * q >> 21;
    sum = (sum + 1223118u * q) >> 21;
    sum = ((sum + 1903369u * q) >> 10) + 1816186u * q * 2048;
    sum = (root < 0 ? 0 - sum : sum) + (uint64_t)whole * 2147483648u;
    return sum >> 63 ? -(int64_t)(0 - sum - 1) - 1 : (int64_t)sum;
}

/* A coordinate of a number in units of 2^-16, which is small, in units of 2^-32. */
static inline int64_t pmono_fixed_part(const pmono_set* set, const int64_t* n, int axis)
{
    int64_t whole, root;
    pmono_twice(set, n, axis, &whole, &root);
    return whole * 32768 + (int64_t)((double)root * 56755.84086241697);
}

static inline double pmono_rough(const pmono_set* set, const int64_t* n, int axis)
{
    int64_t whole, root;
    pmono_twice(set, n, axis, &whole, &root);
    return ((double)whole + 1.7320508075688772 * (double)root) / 2;
}
static inline double pmono_squared(const pmono_set* set, const int64_t* n)
{
    const double x = pmono_rough(set, n, 0), y = pmono_rough(set, n, 1);
    return x * x + y * y;
}

/* Adds the image of a place after some divisions. */
static inline void pmono_add_image(const pmono_set* set, uint32_t divisions, const int64_t* place, int64_t* sum)
{
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) sum[j] += set->powers[divisions][4 * i + j] * place[i];
}

static inline void pmono_place(const unsigned char* record, int64_t* place)
{
    for (int i = 0; i < 4; ++i) place[i] = pmono_signed_half(record + 4 + 2 * i);
}

/* The place of a point in its tile, in units of 2^-16. */
static inline void pmono_point_place(const pmono_set* set, uint32_t state, uint32_t index, int64_t* place)
{
    const unsigned char* xy = set->place + 8 * ((uint64_t)state * set->points_per_tile + index);
    const uint32_t own = pmono_half(set->state + 8 * (uint64_t)state + 6);
    const int64_t x = pmono_signed_word(xy), y = (own & 2 ? -1 : 1) * (int64_t)pmono_signed_word(xy + 4);
    /* x + i y, or i y as it is mirrored; then a twelfth of a turn: i z = z^4 = z^2 - 1. */
    place[0] = own & 1 ? -y : x;
    place[1] = own & 1 ? x : 0;
    place[2] = own & 1 ? y : 0;
    place[3] = own & 1 ? 0 : y;
}

/* Checks records of tiles in the frame of another one, `extra` is below a limit. 0: they are right. */
static inline int pmono_bad_record(const pmono_set* set, const unsigned char* record)
{
    int bad = pmono_word(record) >= set->states || pmono_half(record + 12) > 5;
    for (int i = 0; i < 4; ++i)
        bad |= pmono_signed_half(record + 4 + 2 * i) < -64 || pmono_signed_half(record + 4 + 2 * i) > 64;
    return bad;
}

/* Checks the parts of a state: they follow those of the state before; orders and ranks have each number once. */
static inline int pmono_bad_state(const pmono_set* set, uint32_t state, uint32_t* first)
{
    const unsigned char* record = set->state + 8 * (uint64_t)state;
    const uint32_t count = pmono_half(record + 4), n = set->points_per_tile, begin = *first;
    unsigned char known[pmono_most_parts * pmono_most_parts] = {0}, known_order[pmono_most_parts] = {0};
    if (pmono_word(record) != begin || count > pmono_most_parts || count > set->parts - begin ||
        pmono_half(record + 6) > 3)
        return 1;
    *first += count;
    for (uint32_t i = 0; i < count; ++i) {
        const unsigned char* part = set->part + 16 * (uint64_t)(begin + i);
        const uint32_t order = pmono_half(part + 14);
        if (pmono_bad_record(set, part) || order >= count || known_order[order]++) return 1;
        for (uint32_t k = 0; k < n; ++k) {
            const uint32_t rank = pmono_half(set->rank + 2 * ((uint64_t)(begin + i) * n + k));
            if (rank >= count * n || known[rank]++) return 1;
        }
    }
    return 0;
}

/* Computes the images of places and the reach of tiles, level after level. 0: all are small enough, and tiles do not
 * lie so densely that a window would never end. */
static inline int pmono_bad_levels(pmono_set* set, const unsigned char* growth)
{
    double longest = 0, tiles = 1;
    int64_t n[4];
    for (uint32_t s = 0; s < set->states; ++s)
        for (uint32_t k = 0; k < set->points_per_tile; ++k) {
            const unsigned char* xy = set->place + 8 * ((uint64_t)s * set->points_per_tile + k);
            const int32_t x = pmono_signed_word(xy), y = pmono_signed_word(xy + 4);
            if (x < -1048576 || x > 1048576 || y < -1048576 || y > 1048576) return 1;
            pmono_point_place(set, s, k, n);
            const double squared = pmono_squared(set, n);
            if (squared > longest) longest = squared;
        }
    set->reach[0] = pmono_root(longest) / 65536;
    for (int i = 0; i < 16; ++i) set->powers[0][i] = i % 5 == 0;
    for (uint32_t level = 1; level <= pmono_divisions; ++level) {
        longest = 0;
        for (uint32_t p = 0; p < set->parts; ++p) {
            int64_t at[4], image[4] = {0, 0, 0, 0};
            pmono_place(set->part + 16 * (uint64_t)p, at);
            pmono_add_image(set, level - 1, at, image);
            const double squared = pmono_squared(set, image);
            if (squared > longest) longest = squared;
        }
        set->reach[level] = set->reach[level - 1] + pmono_root(longest);
        tiles *= 5; /* fewer than those of any tile */
        if (tiles > 64 * (1 + set->reach[level] * set->reach[level])) return 1;
        if (level == pmono_divisions) break;
        for (int i = 0; i < 4; ++i) {
            int64_t unit[4], image[4] = {0, 0, 0, 0};
            for (int j = 0; j < 4; ++j) {
                const int32_t g = growth[4 * i + j];
                unit[j] = g < 128 ? g : g - 256;
                if (unit[j] < -8 || unit[j] > 8) return 1;
            }
            pmono_add_image(set, level - 1, unit, image);
            for (int j = 0; j < 4; ++j) {
                if (image[j] > INT64_C(1) << 47 || image[j] < -(INT64_C(1) << 47)) return 1;
                set->powers[level][4 * i + j] = image[j];
            }
        }
    }
    return 0;
}

/* Looks at the `size` bytes of a file, which must stay where they are. 0: `set` can be used; otherwise what is wrong.
 * Checks all numbers that are used here, not the checksum, and not that the tables are those of the tiling: `poissonlab
 * tiles verify` does that. */
static inline const char* pmono_open(pmono_set* set, const void* file, uint64_t size)
{
    const unsigned char* bytes = (const unsigned char*)file;
    const char* magic = "PTILES\r\n";
    if (size < 128) return "shorter than the header of a tile set file";
    for (int i = 0; i < 8; ++i)
        if (bytes[i] != (unsigned char)magic[i]) return "not a tile set file";
    if (pmono_word(bytes + 8) != 4 || pmono_word(bytes + 12) != 128) return "not version 4 of the file format";
    if (pmono_word(bytes + 16) != 3 || pmono_word(bytes + 20) != 2 || pmono_word(bytes + 24) > 1)
        return "an unknown kind of tiles";
    set->tiling = pmono_word(bytes + 24);
    set->states = pmono_word(bytes + 28);
    set->points_per_tile = pmono_word(bytes + 32);
    set->squared_min_distance = pmono_word(bytes + 40) | (uint64_t)pmono_word(bytes + 44) << 32;
    set->parts = pmono_word(bytes + 48);
    set->starts = pmono_word(bytes + 52);
    set->flips = pmono_word(bytes + 56);
    set->odd = pmono_word(bytes + 60);
    const uint64_t n = set->points_per_tile, t = set->states, p = set->parts, s = set->starts;
    if (n < 1 || n > pmono_most_parts || t < 1 || t > 65536 || p < 1 || p > 1048576 || s < 1 || s > 8 ||
        set->flips > 1 || set->odd != (set->tiling ? 1u : 3u) || pmono_word(bytes + 80) != pmono_divisions)
        return "numbers of states, parts and points that do not fit together";
    if (size != 128 + 16 * (n + s + p) + 8 * t + 8 * t * n + 2 * p * n) return "too short or too long for its points";
    set->distances = bytes + 128;
    set->start = set->distances + 16 * n;
    set->part = set->start + 16 * s;
    set->state = set->part + 16 * p;
    set->place = set->state + 8 * t;
    set->rank = set->place + 8 * t * n;
    uint32_t first = 0;
    for (uint32_t i = 0; i < set->states; ++i)
        if (pmono_bad_state(set, i, &first)) return "states whose parts or ranks do not fit together";
    for (uint32_t i = 0; i < set->starts; ++i)
        if (pmono_bad_record(set, set->start + 16 * i)) return "tiles around the origin that do not fit together";
    if (first != set->parts || pmono_bad_levels(set, bytes + 64)) return "tiles that do not fit together";
    return 0;
}

#endif
