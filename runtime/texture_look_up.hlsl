// SPDX-License-Identifier: MIT-0
//
// Colours of an endless texture at a place: texture_look_up.glsl in HLSL, after texture_tiles.h with TTILES_HLSL defined
// and the same four numbers, which says what everything is.

uint ttiles_place_of(uint seed, int2 tile)
{
#if TTILES_WANG
    return ttiles_wang_place(seed, TTILES_COLORS, uint(tile.x), uint(tile.y));
#else
    return ttiles_place(seed, TTILES_COLORS, uint(tile.x), uint(tile.y));
#endif
}

// The tile that a texel lies in, up to a tile's side beyond `tile`; the texel is counted from there afterwards.
int2 ttiles_tile_of(int2 tile, inout int2 texel, int size)
{
    int2 beyond = int2(texel.x >= size, texel.y >= size) - int2(texel.x < 0, texel.y < 0);
    texel -= beyond * size;
    return tile + beyond;
}

float4 ttiles_packed_texel(Texture2D<float4> atlas, uint seed, int2 tile, int2 texel, int level)
{
    int size = TTILES_SIZE >> level;
    uint place = ttiles_place_of(seed, ttiles_tile_of(tile, texel, size));
    uint side = TTILES_COLORS * TTILES_COLORS;
    int2 at = int2(int(place % side), int(side - 1u - place / side)) * size;
    return atlas.Load(int3(at + int2(texel.x, size - 1 - texel.y), level));
}

float4 ttiles_layer_texel(Texture2DArray<float4> layers, uint seed, int2 tile, int2 texel, int level)
{
    int size = TTILES_SIZE >> level;
    int place = int(ttiles_place_of(seed, ttiles_tile_of(tile, texel, size)));
    return layers.Load(int4(texel.x, size - 1 - texel.y, place, level));
}

// How far between four texels of a level a place is, and the lower left one of them.
float2 ttiles_between(float2 inside, int level, out int2 texel)
{
    float2 texels = inside * float(TTILES_SIZE >> level) - 0.5;
    texel = int2(floor(texels));
    return texels - floor(texels);
}

float4 ttiles_packed_level(Texture2D<float4> atlas, uint seed, int2 tile, float2 inside, int level)
{
    int2 t;
    float2 part = ttiles_between(inside, level, t);
    return lerp(lerp(ttiles_packed_texel(atlas, seed, tile, t, level),
                     ttiles_packed_texel(atlas, seed, tile, t + int2(1, 0), level), part.x),
                lerp(ttiles_packed_texel(atlas, seed, tile, t + int2(0, 1), level),
                     ttiles_packed_texel(atlas, seed, tile, t + int2(1, 1), level), part.x), part.y);
}

float4 ttiles_layer_level(Texture2DArray<float4> layers, uint seed, int2 tile, float2 inside, int level)
{
    int2 t;
    float2 part = ttiles_between(inside, level, t);
    return lerp(lerp(ttiles_layer_texel(layers, seed, tile, t, level),
                     ttiles_layer_texel(layers, seed, tile, t + int2(1, 0), level), part.x),
                lerp(ttiles_layer_texel(layers, seed, tile, t + int2(0, 1), level),
                     ttiles_layer_texel(layers, seed, tile, t + int2(1, 1), level), part.x), part.y);
}

// The finer one of two levels that fit to a pixel's texels, and how much the coarser one counts.
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

// Looks each texel up through its own tile, in the packed atlas.
float4 ttiles_exact(Texture2D<float4> atlas, uint seed, int2 tile, float2 inside, float texels)
{
    float coarser;
    int level = ttiles_level_of(texels, coarser);
    float4 fine = ttiles_packed_level(atlas, seed, tile, inside, level);
    if (coarser == 0.0) return fine;
    return lerp(fine, ttiles_packed_level(atlas, seed, tile, inside, level + 1), coarser);
}

// Looks each texel up through its own tile, in layers.
float4 ttiles_layered(Texture2DArray<float4> layers, uint seed, int2 tile, float2 inside, float texels)
{
    float coarser;
    int level = ttiles_level_of(texels, coarser);
    float4 fine = ttiles_layer_level(layers, seed, tile, inside, level);
    if (coarser == 0.0) return fine;
    return lerp(fine, ttiles_layer_level(layers, seed, tile, inside, level + 1), coarser);
}

// Looks a texel up by the filters of hardware, in the packed atlas; dx, dy: derivatives of the place, in tiles a pixel.
float4 ttiles_packed(Texture2D<float4> atlas, SamplerState repeating, uint seed, int2 tile, float2 inside, float2 dx,
                     float2 dy)
{
    uint place = ttiles_place_of(seed, tile);
    uint side = TTILES_COLORS * TTILES_COLORS;
    float2 at = (float2(float(place % side), float(place / side)) + inside) / float(side);
    float2 down = float2(1.0, -1.0) / float(side); // rows of the atlas go from north to south
    return atlas.SampleGrad(repeating, float2(at.x, 1.0 - at.y), dx * down, dy * down);
}
