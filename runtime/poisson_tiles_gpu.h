// SPDX-License-Identifier: MIT-0
//
// Poisson disk (sphere) distributions on GPUs: the look-ups of poisson_tiles.h as OpenCL C 1.2, GLSL 4.3,
// GLSL ES 3.00 (WebGL2) and HLSL (shader model 5).
//
// The points of a tile set file (docs/tile-set-file.md), its bytes from 128 on, are a buffer of 32-bit words,
// the last one filled up with zeros. In OpenCL functions take it as their first argument:
//     const struct ptiles_nearest n = ptiles_nearest_point(points, t, tile, f);
// Elsewhere it is declared before this file is included, and there is no such argument. GLSL 4.3:
//     layout(std430, binding = 0) readonly buffer PoissonTiles { uint ptiles_words[]; };
// HLSL, where PTILES_HLSL is defined as well:
//     StructuredBuffer<uint> ptiles_words : register(t0);
// GLSL ES 3.00 has no buffers: words are texels, 2,048 a row, of a texture of the format R32UI:
//     precision highp float; precision highp int; precision highp usampler2D;
//     uniform usampler2D ptiles_texture;
// There sums may be rounded in other ways than elsewhere: of two points that are as near, to the last bit of a float,
// either may be taken for the nearest.
#ifndef POISSON_TILES_GPU_H
#define POISSON_TILES_GPU_H

#if defined(__OPENCL_C_VERSION__) || defined(__OPENCL_VERSION__) // offline compilers define the former only
#pragma OPENCL FP_CONTRACT OFF
#ifdef __clang__ // without it PoCL calls functions, and runs one work-item at a time
#define PTILES_FUNCTION static inline __attribute__((always_inline))
#else
#define PTILES_FUNCTION static inline
#endif
#define PTILES_STRUCT(name) struct name
#define PTILES_BUFFER global const uint *ptiles_words,
#define PTILES_WORDS ptiles_words,
#define PTILES_PRECISE
#define PTILES_FLOAT(i) ((float)(i))
#define PTILES_UINT(i) ((uint)(i))
#define PTILES_INT(i) ((int)(i))
#define PTILES_INT3(i, j, k) ((int3)(i, j, k))
#define PTILES_WORD(i) ptiles_words[i]
#define ptiles_int3 int3
#define ptiles_float3 float3
#else
#define PTILES_FUNCTION
#define PTILES_STRUCT(name) name
#define PTILES_BUFFER
#define PTILES_WORDS
#define PTILES_FLOAT(i) float(i)
#define PTILES_UINT(i) uint(i)
#define PTILES_INT(i) int(i)
#ifdef GL_ES
#define PTILES_PRECISE
#define PTILES_WORD(i) texelFetch(ptiles_texture, ivec2(int((i) & 2047u), int((i) >> 11)), 0).r
#else
#define PTILES_PRECISE precise
#define PTILES_WORD(i) ptiles_words[i]
#endif
#ifdef PTILES_HLSL
#define PTILES_INT3(i, j, k) int3(i, j, k)
#define ptiles_int3 int3
#define ptiles_float3 float3
#else
#define PTILES_INT3(i, j, k) ivec3(i, j, k)
#define ptiles_int3 ivec3
#define ptiles_float3 vec3
#endif
#endif

/// The numbers of the file's header, and which tile is where: see ptiles_set and ptiles_tiling in
/// poisson_tiles.h. Tiles with strips: low 0, step 1, below and above 0. `ranks` says where ranks are in the buffer: in
/// terms of poisson_tiles.h set.ranks - set.points; 0: the set is not ranked.
struct ptiles_tiling
{
    uint kind;
    uint dimension;
    uint colors;
    uint tiles;
    uint points_per_tile;
    uint seed;
    int period;
    int low;
    int step;
    int below;
    int above;
    uint ranks;
};

struct ptiles_nearest
{
    float distance;
    ptiles_int3 tile; ///< the place of the point's tile
    uint index;       ///< in its tile
    uint id;          ///< random bits that stay with the point
};

PTILES_FUNCTION uint ptiles_mix(uint v)
{
    v = (v ^ (v >> 16)) * 0x21f0aaadu;
    v = (v ^ (v >> 15)) * 0xd35a2d97u;
    return v ^ (v >> 15);
}

PTILES_FUNCTION uint ptiles_hash(uint seed, uint x, uint y, uint z)
{
    return ptiles_mix(ptiles_mix(ptiles_mix(ptiles_mix(seed) + x) + y) + z);
}

PTILES_FUNCTION uint ptiles_color(PTILES_STRUCT(ptiles_tiling) t, uint x, uint y, uint z)
{
    return ptiles_hash(t.seed, x, y, z) % t.colors;
}

/// A place as the hash function takes it, and those after and before it, on the circle of a period or of
/// 2^32.
PTILES_FUNCTION uint ptiles_place(int i, int period)
{
    if (period == 0) return PTILES_UINT(i);
    // GLSL leaves the remainder of negative numbers undefined: -1 - i is not negative.
    return PTILES_UINT(i < 0 ? period - 1 - (-1 - i) % period : i % period);
}
PTILES_FUNCTION uint ptiles_after(uint x, int period) { return x + 1u == PTILES_UINT(period) ? 0u : x + 1u; }
PTILES_FUNCTION uint ptiles_before(uint x, int period) { return (x == 0u ? PTILES_UINT(period) : x) - 1u; }

/// The digits of a corner tile at the height z.
PTILES_FUNCTION uint ptiles_corners(PTILES_STRUCT(ptiles_tiling) t, uint x, uint y, uint z)
{
    uint east = ptiles_after(x, t.period);
    uint north = ptiles_after(y, t.period);
    uint tile = ptiles_color(t, east, north, z) * t.colors + ptiles_color(t, east, y, z);
    return (tile * t.colors + ptiles_color(t, x, y, z)) * t.colors + ptiles_color(t, x, north, z);
}

/// Appends two digits to a tile's number: the colours of the edges that go east from (x0, y0) and north from (x1, y1).
PTILES_FUNCTION uint ptiles_edge_pair(PTILES_STRUCT(ptiles_tiling) t, uint tile, uint x0, uint y0, uint x1, uint y1)
{
    return (tile * t.colors + ptiles_color(t, x0, y0, 0u)) * t.colors + ptiles_color(t, x1, y1, 1u);
}

/// The number of the tile at (i, j, k); k is 0 in 2D.
PTILES_FUNCTION uint ptiles_tile(PTILES_STRUCT(ptiles_tiling) t, ptiles_int3 at)
{
    uint x = ptiles_place(at.x, t.period);
    uint y = ptiles_place(at.y, t.period);
    if (t.kind == 2u) return ptiles_hash(t.seed, x, y, 0u) % t.tiles;
    if (t.kind == 0u && t.dimension == 2u) return ptiles_corners(t, x, y, 0u);
    if (t.kind == 0u) {
        uint z = ptiles_place(at.z, t.period);
        return ptiles_corners(t, x, y, ptiles_after(z, t.period)) * (t.colors * t.colors * t.colors * t.colors) +
               ptiles_corners(t, x, y, z);
    }
    uint east = ptiles_after(x, t.period);
    uint west = ptiles_before(x, t.period);
    uint north = ptiles_after(y, t.period);
    uint south = ptiles_before(y, t.period);
    uint tile = ptiles_edge_pair(t, 0u, x, north, east, y);
    tile = ptiles_edge_pair(t, tile, x, y, x, y);
    tile = ptiles_edge_pair(t, tile, east, north, east, north);
    tile = ptiles_edge_pair(t, tile, east, y, east, south);
    tile = ptiles_edge_pair(t, tile, west, y, x, south);
    return ptiles_edge_pair(t, tile, west, north, x, north);
}

/// The number of this place among all of the buffer.
PTILES_FUNCTION uint ptiles_number(PTILES_BUFFER uint n)
{
    return (PTILES_WORD(n >> 1) >> ((n & 1u) * 16u)) & 0xffffu;
}

/// A number as a coordinate, in tiles from the tile's lowest corner, without rounding.
PTILES_FUNCTION float ptiles_coordinate(PTILES_BUFFER PTILES_STRUCT(ptiles_tiling) t, uint n)
{
    return PTILES_FLOAT(t.low + t.step * PTILES_INT(ptiles_number(PTILES_WORDS n))) / 65536.0f;
}

/// The point of this index of a tile: from the tile's lowest corner, without rounding. In 2D z is 0.
PTILES_FUNCTION ptiles_float3 ptiles_point(PTILES_BUFFER PTILES_STRUCT(ptiles_tiling) t, uint tile, uint index)
{
    uint n = (tile * t.points_per_tile + index) * t.dimension;
    ptiles_float3 p;
    p.x = ptiles_coordinate(PTILES_WORDS t, n);
    p.y = ptiles_coordinate(PTILES_WORDS t, n + 1u);
    p.z = t.dimension == 3u ? ptiles_coordinate(PTILES_WORDS t, n + 2u) : 0.0f;
    return p;
}

/// Returns the minimum distance of every tiling, in tiles, from the file's header: its 32-bit words 10 and 11, at the bytes 40
/// and 44. It is 0 where the file promises none.
PTILES_FUNCTION float ptiles_min_distance(uint word10, uint word11)
{
    return sqrt(PTILES_FLOAT(word11) * 4294967296.0f + PTILES_FLOAT(word10)) / 65536.0f;
}

/// The density, from 0 to 1, above which a point is there: ranked sets are spread evenly at any density, others lose
/// points at random. `tile` is the number of its tile, `id` its random bits.
PTILES_FUNCTION float ptiles_level(PTILES_BUFFER PTILES_STRUCT(ptiles_tiling) t, uint tile, uint index, uint id)
{
    if (t.ranks == 0u) return PTILES_FLOAT(id >> 8) / 16777216.0f;
    uint rank = ptiles_number(PTILES_WORDS t.ranks + tile * t.points_per_tile + index);
    return (PTILES_FLOAT(rank) + 0.5f) / PTILES_FLOAT(t.points_per_tile);
}

/// The squared distance along an axis of a position in the tile 0 from where points of the tile `offset` tiles away can
/// be, which is `below` and `above` more than its square.
PTILES_FUNCTION float ptiles_gap(float f, int offset, float below, float above)
{
    float gap = 0.0f;
    if (offset > 0) gap = max(PTILES_FLOAT(offset) - below - f, 0.0f);
    if (offset < 0) gap = max(f - (PTILES_FLOAT(offset + 1) + above), 0.0f);
    return gap * gap;
}

/// The point nearest to a position in the tile at `home`, which is `f` from that tile's lowest corner; 0 <= f
/// < 1, in 2D f.z = 0. Rings of tiles around that tile are visited as long as they can have a nearer point.
PTILES_FUNCTION PTILES_STRUCT(ptiles_nearest)
    ptiles_nearest_point(PTILES_BUFFER PTILES_STRUCT(ptiles_tiling) t, ptiles_int3 home, ptiles_float3 f)
{
    bool is_3d = t.dimension == 3u;
    float border = min(min(f.x, 1.0f - f.x), min(f.y, 1.0f - f.y));
    if (is_3d) border = min(border, min(f.z, 1.0f - f.z));
    PTILES_STRUCT(ptiles_nearest) nearest;
    float squared = 1e30f;
    float below = PTILES_FLOAT(t.below) / 65536.0f;
    float above = PTILES_FLOAT(t.above) / 65536.0f;
    for (int ring = 0;; ++ring) {
        float away = border + PTILES_FLOAT(ring - 1) - max(below, above); // of points in the ring, at least
        if (ring > 0 && away > 0.0f && away * away >= squared) break;
        int layers = is_3d ? ring : 0;
        for (int k = -layers; k <= layers; ++k) {
            for (int j = -ring; j <= ring; ++j) {
                // Rows inside the ring contribute only their ends.
                bool outer = ring == 0 || j == -ring || j == ring || (is_3d && (k == -ring || k == ring));
                for (int i = -ring; i <= ring; i += outer ? 1 : 2 * ring) {
                    float gap = ptiles_gap(f.x, i, below, above) + ptiles_gap(f.y, j, below, above) +
                                ptiles_gap(f.z, k, below, above);
                    if (gap >= squared) continue;
                    ptiles_int3 place = home + PTILES_INT3(i, j, k);
                    uint tile = ptiles_tile(t, place);
                    for (uint n = 0u; n < t.points_per_tile; ++n) {
                        ptiles_float3 p = ptiles_point(PTILES_WORDS t, tile, n);
                        PTILES_PRECISE float x = p.x + PTILES_FLOAT(i) - f.x;
                        PTILES_PRECISE float y = p.y + PTILES_FLOAT(j) - f.y;
                        PTILES_PRECISE float z = p.z + PTILES_FLOAT(k) - f.z;
                        PTILES_PRECISE float sum = x * x + y * y + z * z;
                        if (sum >= squared) continue;
                        squared = sum;
                        nearest.tile = place;
                        nearest.index = n;
                    }
                }
            }
        }
    }
    nearest.distance = sqrt(squared);
    uint z = ptiles_place(nearest.tile.z, t.period);
    nearest.id = ptiles_mix(
        ptiles_hash(t.seed, ptiles_place(nearest.tile.x, t.period), ptiles_place(nearest.tile.y, t.period), z) + 1u +
        nearest.index);
    return nearest;
}

#endif
