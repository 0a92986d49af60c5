// SPDX-License-Identifier: MIT-0
//
// An endless plane with texture tiles: a fragment shader of GLSL 4.3, after texture_tiles.h with TTILES_GLSL defined.
//
//     #version 430
//     #define TTILES_GLSL
//     ... texture_tiles.h ...
//     ... this file ...
//
// Without exact_lookup it reads the packed atlas as hardware does: mip-mapped and anisotropic, right at every level with
// 2^level <= ring; give the sampler no levels beyond log2(tile_size), whose texels would be of several tiles. With it,
// four texels of level 0 are fetched through their own tiles: right without a ring as well.
// The atlas is bound with repeating borders, sRGB bytes as sRGB, so that averages are of light.
uniform sampler2D atlas;
uniform uint seed;
uniform uint colors;      // C of the set
uniform uint tile_size;   // T
uniform bool wang_tiles;  // whether the set is of Wang tiles
uniform bool exact_lookup;
in vec2 place;            // in tiles, east and north
out vec4 color;

// Where a tile lies in the atlas.
uint tile_place(uint x, uint y)
{
    return wang_tiles ? ttiles_wang_place(seed, colors, x, y) : ttiles_place(seed, colors, x, y);
}

// The texel i, j of the endless texture, counted from the lower left of the tile (0, 0).
vec4 endless_texel(ivec2 texel)
{
    ivec2 tile = ivec2(floor(vec2(texel) / float(tile_size)));
    ivec2 inside = texel - tile * int(tile_size);
    uint number =
        ttiles_texel_at(tile_place(uint(tile.x), uint(tile.y)), colors, tile_size, uint(inside.x), uint(inside.y));
    uint width = colors * colors * tile_size;
    return texelFetch(atlas, ivec2(number % width, number / width), 0);
}

void main()
{
    if (exact_lookup) {
        vec2 texels = place * float(tile_size) - 0.5;
        ivec2 corner = ivec2(floor(texels));
        vec2 part = texels - vec2(corner);
        color = mix(mix(endless_texel(corner), endless_texel(corner + ivec2(1, 0)), part.x),
                    mix(endless_texel(corner + ivec2(0, 1)), endless_texel(corner + ivec2(1, 1)), part.x), part.y);
        return;
    }
    float side = float(colors * colors);
    vec2 tile = floor(place);
    uint packed_place = tile_place(uint(int(tile.x)), uint(int(tile.y)));
    vec2 shown = (vec2(packed_place % (colors * colors), packed_place / (colors * colors)) + place - tile) / side;
    // Derivatives of the endless texture: those in the atlas jump at borders. Rows of the atlas go from north to south.
    vec2 dx = dFdx(place) / side, dy = dFdy(place) / side;
    color = textureGrad(atlas, vec2(shown.x, 1.0 - shown.y), vec2(dx.x, -dx.y), vec2(dy.x, -dy.y));
}
