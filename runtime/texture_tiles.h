// SPDX-License-Identifier: MIT-0
//
// Endless textures of corner tiles and of complete sets of Wang tiles: which texel of the atlas is shown where. For C99,
// C++, OpenCL C 1.2, GLSL 4.3 and ES 3.00 (with TTILES_GLSL defined there) and HLSL (TTILES_HLSL); it needs nothing else.
//
// `poissonlab texture build corner` and `wang` write the atlas, docs/texture-set.md: C^2 x C^2 tiles of T x T texels,
// packed so that what lies beside a tile in the atlas has the colours of what lies beside it in the texture. A hash
// function gives lattice points, or edges, their colours, these make a tile, and the tile's place in the atlas follows
// without a table: Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.4; the packing of corner tiles is the
// laboratory's, tiles/packing/closed_packing.hpp, that of Wang tiles Wei's (Tile-Based Texture Mapping on Graphics
// Hardware, 2004).
//
// Filtering. Texels near a border are those of the ring, which the neighbour in the atlas has as well: a bilinear look-up
// in the atlas is right at every level with 2^level <= ring; with Wang tiles not within 1.5 texels of a corner of tiles,
// where neighbours in the atlas and in the texture share no colour. Take the level from derivatives of the coordinates of
// the endless texture, never from those in the atlas, which jump at borders (GLSL: textureGrad). Beyond that level, fetch
// each texel of the footprint by ttiles_texel() or ttiles_wang_texel().
#ifndef TEXTURE_TILES_H
#define TEXTURE_TILES_H

#if defined(__OPENCL_C_VERSION__) || defined(__OPENCL_VERSION__)
#ifdef __clang__ // without it PoCL calls functions, and runs one work-item at a time
#define TTILES_FUNCTION static inline __attribute__((always_inline))
#else
#define TTILES_FUNCTION static inline
#endif
#define ttiles_uint uint
#elif defined(GL_core_profile) || defined(VULKAN) || defined(TTILES_GLSL) || defined(TTILES_HLSL)
#define TTILES_FUNCTION
#define ttiles_uint uint
#else
#include <stdint.h>
#define TTILES_FUNCTION static inline
#define ttiles_uint uint32_t
#endif

TTILES_FUNCTION ttiles_uint ttiles_mix(ttiles_uint v)
{
    v = (v ^ (v >> 16)) * 0x21f0aaadu;
    v = (v ^ (v >> 15)) * 0xd35a2d97u;
    return v ^ (v >> 15);
}

/// The colour of a lattice point; coordinates modulo 2^32. The same as the lower left corner of a tile of
/// poisson_tiles.h.
TTILES_FUNCTION ttiles_uint ttiles_color(ttiles_uint seed, ttiles_uint colors, ttiles_uint x, ttiles_uint y)
{
    return ttiles_mix(ttiles_mix(ttiles_mix(ttiles_mix(seed) + x) + y)) % colors;
}

/// The place of a pair of colours on the circle 0 0 1 0 2 ... 1 1 2 ... on which each pair of neighbours occurs once.
TTILES_FUNCTION ttiles_uint ttiles_pair(ttiles_uint first, ttiles_uint second, ttiles_uint colors)
{
    ttiles_uint low = first < second ? first : second;
    ttiles_uint block = low * (2u * colors - low);
    if (first == colors - 1u)
        return second == 0u ? colors * colors - 1u : second * (2u * colors - second) - 1u;
    if (first == second) return block;
    return first < second ? block + 2u * (second - first) - 1u : block + 2u * (first - second);
}

/// Returns the place of a tile, by its corners, in a packing of an odd number of colours: y C^2 + x, from the lower left.
TTILES_FUNCTION ttiles_uint ttiles_odd_place(ttiles_uint colors, ttiles_uint ne, ttiles_uint se, ttiles_uint sw,
                                             ttiles_uint nw)
{
    ttiles_uint side = colors * colors;
    ttiles_uint west = ttiles_pair(sw, nw, colors);
    ttiles_uint x = (ttiles_pair(se, ne, colors) + side - west) % side;
    // Column x is shifted by 0 + 1 + ... + (x - 1) = x (x - 1) / 2; the even factor is halved first.
    ttiles_uint shift = x % 2u == 0u ? x / 2u * (x + side - 1u) : x * ((x - 1u) / 2u);
    return (west + side - shift % side) % side * side + x;
}

/// The place of the tile with these corners in a packing of an even number of colours: the lowest digits of the corners
/// say which of 4 x 4 places, the others which block.
TTILES_FUNCTION ttiles_uint ttiles_even_place(ttiles_uint colors, ttiles_uint ne, ttiles_uint se, ttiles_uint sw,
                                              ttiles_uint nw)
{
    ttiles_uint base = colors / 2u;
    ttiles_uint low = sw % 2u + 2u * (se % 2u) + 4u * (nw % 2u) + 8u * (ne % 2u);
    // 0, 3, 12, 13, 4, 15, 2, 11, 1, 8, 5, 14, 7, 6, 9, 10: four bits each.
    ttiles_uint place = ((low < 8u ? 0xb2f4dc30u : 0xa967e581u) >> (4u * (low % 8u))) & 15u;
    ttiles_uint x = place % 4u;
    ttiles_uint y = place / 4u;
    // The window's even row holds the digits of a, its odd one those of b; even columns the lower digits.
    ttiles_uint a_low = y % 2u == 0u ? (x % 2u == 0u ? sw : se) : (x % 2u == 0u ? nw : ne);
    ttiles_uint a_high = y % 2u == 0u ? (x % 2u == 0u ? se : sw) : (x % 2u == 0u ? ne : nw);
    ttiles_uint b_low = y % 2u == 0u ? (x % 2u == 0u ? nw : ne) : (x % 2u == 0u ? sw : se);
    ttiles_uint b_high = y % 2u == 0u ? (x % 2u == 0u ? ne : nw) : (x % 2u == 0u ? se : sw);
    ttiles_uint a = a_low / 2u + base * (a_high / 2u);
    ttiles_uint b_digit = b_low / 2u;
    if (y == 3u) a = (a + base * base - 1u) % (base * base);
    if (x == 3u) b_digit = (b_digit + base - 1u) % base;
    return (4u * a + y) * colors * colors + 4u * (b_digit + base * (b_high / 2u)) + x;
}

/// The place in the atlas, y C^2 + x from the lower left, of the tile with these corners.
TTILES_FUNCTION ttiles_uint ttiles_corner_place(ttiles_uint colors, ttiles_uint ne, ttiles_uint se, ttiles_uint sw,
                                                ttiles_uint nw)
{
    if (colors % 2u == 1u) return ttiles_odd_place(colors, ne, se, sw, nw);
    return ttiles_even_place(colors, ne, se, sw, nw);
}

/// The place in the atlas of the tile whose lower left corner is the lattice point (x, y).
TTILES_FUNCTION ttiles_uint ttiles_place(ttiles_uint seed, ttiles_uint colors, ttiles_uint x, ttiles_uint y)
{
    return ttiles_corner_place(colors, ttiles_color(seed, colors, x + 1u, y + 1u), ttiles_color(seed, colors, x + 1u, y),
                               ttiles_color(seed, colors, x, y), ttiles_color(seed, colors, x, y + 1u));
}

/// The colour of the edge that goes east (is_vertical = 0) or north (1) from a lattice point, coordinates modulo 2^32.
/// Edge tiles of poisson_tiles.h have this colour, too.
TTILES_FUNCTION ttiles_uint ttiles_edge_color(ttiles_uint seed, ttiles_uint colors, ttiles_uint x, ttiles_uint y,
                                              ttiles_uint is_vertical)
{
    return ttiles_mix(ttiles_mix(ttiles_mix(ttiles_mix(seed) + x) + y) + is_vertical) % colors;
}

/// The place in a row of C^2 tiles of the one with these colours in the west and the east, or south and north.
TTILES_FUNCTION ttiles_uint ttiles_domino_place(ttiles_uint first, ttiles_uint second)
{
    if (first == second) return first == 0u ? 0u : (first + 1u) * (first + 1u) - 2u;
    if (first < second) return second * second + 2u * first;
    return second == 0u ? (first + 1u) * (first + 1u) - 1u : first * first + 2u * second - 1u;
}

/// The place in the atlas, y C^2 + x from the lower left, of the Wang tile with these edges.
TTILES_FUNCTION ttiles_uint ttiles_wang_place_of(ttiles_uint colors, ttiles_uint n, ttiles_uint e, ttiles_uint s,
                                                 ttiles_uint w)
{
    return ttiles_domino_place(s, n) * colors * colors + ttiles_domino_place(w, e);
}

/// The place in the atlas of the Wang tile whose lower left corner is the lattice point (x, y).
TTILES_FUNCTION ttiles_uint ttiles_wang_place(ttiles_uint seed, ttiles_uint colors, ttiles_uint x, ttiles_uint y)
{
    return ttiles_wang_place_of(
        colors, ttiles_edge_color(seed, colors, x, y + 1u, 0u), ttiles_edge_color(seed, colors, x + 1u, y, 1u),
        ttiles_edge_color(seed, colors, x, y, 0u), ttiles_edge_color(seed, colors, x, y, 1u));
}

/// The texel `column` texels east and `row` texels north of the lower left of the tile at a place in the atlas, both
/// below T: its number in the atlas, whose rows go from north to south and have C^2 T texels.
TTILES_FUNCTION ttiles_uint ttiles_texel_at(ttiles_uint place, ttiles_uint colors, ttiles_uint size, ttiles_uint column,
                                            ttiles_uint row)
{
    ttiles_uint side = colors * colors;
    ttiles_uint from_south = place / side * size + row;
    return (side * size - 1u - from_south) * (side * size) + place % side * size + column;
}

/// The texel of the endless texture of corner tiles so far from the lower left of the tile (x, y).
TTILES_FUNCTION ttiles_uint ttiles_texel(ttiles_uint seed, ttiles_uint colors, ttiles_uint size, ttiles_uint x,
                                         ttiles_uint y, ttiles_uint column, ttiles_uint row)
{
    return ttiles_texel_at(ttiles_place(seed, colors, x, y), colors, size, column, row);
}

/// The texel of the endless texture of Wang tiles so far from the lower left of the tile (x, y).
TTILES_FUNCTION ttiles_uint ttiles_wang_texel(ttiles_uint seed, ttiles_uint colors, ttiles_uint size, ttiles_uint x,
                                              ttiles_uint y, ttiles_uint column, ttiles_uint row)
{
    return ttiles_texel_at(ttiles_wang_place(seed, colors, x, y), colors, size, column, row);
}

#endif
