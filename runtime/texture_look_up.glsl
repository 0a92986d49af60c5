// SPDX-License-Identifier: MIT-0
//
// Colours of an endless texture at a place: GLSL 4.3 and GLSL ES 3.00, after texture_tiles.h with TTILES_GLSL defined and
// the numbers of a texture set:
//
//     #define TTILES_COLORS 3u  // C
//     #define TTILES_SIZE 64    // T, texels of a tile; its levels are log2(T) + 1 where T is a power of two
//     #define TTILES_LEVELS 7
//     #define TTILES_WANG 0     // 1: Wang tiles
//
// GLSL ES also needs `precision highp float; precision highp int;` before all of it, since its integers may have 16 bits.
// `poissonlab texture export` writes all of it as look_up.glsl, and the textures: atlas is the packed one, layers the
// array. Places are a tile, east and north of the tile (0, 0), and a place inside of it from 0 to 1, so that nothing is
// lost far away. `texels` says how many texels of level 0 a pixel covers; it chooses the level.

uint ttiles_place_of(uint seed, ivec2 tile)
{
#if TTILES_WANG
    return ttiles_wang_place(seed, TTILES_COLORS, uint(tile.x), uint(tile.y));
#else
    return ttiles_place(seed, TTILES_COLORS, uint(tile.x), uint(tile.y));
#endif
}

// The tile that a texel lies in, up to a tile's side beyond `tile`; the texel is counted from there afterwards.
ivec2 ttiles_tile_of(ivec2 tile, inout ivec2 texel, int size)
{
    ivec2 beyond = ivec2(greaterThanEqual(texel, ivec2(size))) - ivec2(lessThan(texel, ivec2(0)));
    texel -= beyond * size;
    return tile + beyond;
}

vec4 ttiles_packed_texel(sampler2D atlas, uint seed, ivec2 tile, ivec2 texel, int level)
{
    int size = TTILES_SIZE >> level;
    uint place = ttiles_place_of(seed, ttiles_tile_of(tile, texel, size));
    uint side = TTILES_COLORS * TTILES_COLORS;
    ivec2 at = ivec2(int(place % side), int(side - 1u - place / side)) * size;
    return texelFetch(atlas, at + ivec2(texel.x, size - 1 - texel.y), level);
}

vec4 ttiles_layer_texel(highp sampler2DArray layers, uint seed, ivec2 tile, ivec2 texel, int level)
{
    int size = TTILES_SIZE >> level;
    int place = int(ttiles_place_of(seed, ttiles_tile_of(tile, texel, size)));
    return texelFetch(layers, ivec3(texel.x, size - 1 - texel.y, place), level);
}

// How far between four texels of a level a place is, and the lower left one of them.
vec2 ttiles_between(vec2 inside, int level, out ivec2 texel)
{
    vec2 texels = inside * float(TTILES_SIZE >> level) - 0.5;
    texel = ivec2(floor(texels));
    return texels - floor(texels);
}

vec4 ttiles_packed_level(sampler2D atlas, uint seed, ivec2 tile, vec2 inside, int level)
{
    ivec2 t;
    vec2 part = ttiles_between(inside, level, t);
    return mix(mix(ttiles_packed_texel(atlas, seed, tile, t, level),
                   ttiles_packed_texel(atlas, seed, tile, t + ivec2(1, 0), level), part.x),
               mix(ttiles_packed_texel(atlas, seed, tile, t + ivec2(0, 1), level),
                   ttiles_packed_texel(atlas, seed, tile, t + ivec2(1, 1), level), part.x), part.y);
}

vec4 ttiles_layer_level(highp sampler2DArray layers, uint seed, ivec2 tile, vec2 inside, int level)
{
    ivec2 t;
    vec2 part = ttiles_between(inside, level, t);
    return mix(mix(ttiles_layer_texel(layers, seed, tile, t, level),
                   ttiles_layer_texel(layers, seed, tile, t + ivec2(1, 0), level), part.x),
               mix(ttiles_layer_texel(layers, seed, tile, t + ivec2(0, 1), level),
                   ttiles_layer_texel(layers, seed, tile, t + ivec2(1, 1), level), part.x), part.y);
}

// The finer one of two levels that fit to a pixel's texels, and how much the coarser one counts. The last level is that
// at which a tile is smallest: farther away, it is shown as well.
int ttiles_level_of(float texels, out float coarser)
{
    int level = 0;
    float wide = 1.0;
    while (texels >= 2.0 * wide && level < TTILES_LEVELS - 1) {
        ++level;
        wide *= 2.0;
    }
    coarser = level == TTILES_LEVELS - 1 ? 0.0 : clamp(texels / wide - 1.0, 0.0, 1.0);
    return level;
}

// Looks each texel up through its own tile, in the packed atlas: right at all levels, and at corners of Wang tiles.
vec4 ttiles_exact(sampler2D atlas, uint seed, ivec2 tile, vec2 inside, float texels)
{
    float coarser;
    int level = ttiles_level_of(texels, coarser);
    vec4 fine = ttiles_packed_level(atlas, seed, tile, inside, level);
    if (coarser == 0.0) return fine;
    return mix(fine, ttiles_packed_level(atlas, seed, tile, inside, level + 1), coarser);
}

// Looks each texel up through its own tile, in layers.
vec4 ttiles_layered(highp sampler2DArray layers, uint seed, ivec2 tile, vec2 inside, float texels)
{
    float coarser;
    int level = ttiles_level_of(texels, coarser);
    vec4 fine = ttiles_layer_level(layers, seed, tile, inside, level);
    if (coarser == 0.0) return fine;
    return mix(fine, ttiles_layer_level(layers, seed, tile, inside, level + 1), coarser);
}

// Looks a texel up by the filters of hardware, in one look-up: right at levels with 2^level <= ring. dx, dy:
// derivatives of the place, in tiles a pixel. The atlas repeats at its borders, and the sampler has no levels beyond
// TTILES_LEVELS - 1.
vec4 ttiles_packed(sampler2D atlas, uint seed, ivec2 tile, vec2 inside, vec2 dx, vec2 dy)
{
    uint place = ttiles_place_of(seed, tile);
    uint side = TTILES_COLORS * TTILES_COLORS;
    vec2 at = (vec2(float(place % side), float(place / side)) + inside) / float(side);
    vec2 down = vec2(1.0, -1.0) / float(side); // rows of the atlas go from north to south
    return textureGrad(atlas, vec2(at.x, 1.0 - at.y), dx * down, dy * down);
}
