// SPDX-License-Identifier: MIT-0
//
// Colours of an endless texture at a place: texture_tiles.h and texture_look_up.glsl in WGSL, after the numbers of a
// texture set:
//
//     const ttiles_colors = 3u;  // C
//     const ttiles_size = 64;    // T
//     const ttiles_levels = 7;
//     const ttiles_wang = false; // true: Wang tiles

fn ttiles_mix(value: u32) -> u32 {
    var v = value;
    v = (v ^ (v >> 16u)) * 0x21f0aaadu;
    v = (v ^ (v >> 15u)) * 0xd35a2d97u;
    return v ^ (v >> 15u);
}

fn ttiles_color(seed: u32, x: u32, y: u32) -> u32 {
    return ttiles_mix(ttiles_mix(ttiles_mix(ttiles_mix(seed) + x) + y)) % ttiles_colors;
}

/// The colour of the edge that goes east (is_vertical = 0) or north (1) from a lattice point.
fn ttiles_edge_color(seed: u32, x: u32, y: u32, is_vertical: u32) -> u32 {
    return ttiles_mix(ttiles_mix(ttiles_mix(ttiles_mix(seed) + x) + y) + is_vertical) % ttiles_colors;
}

/// The place of a pair of colours on the circle 0 0 1 0 2 ... 1 1 2 ... on which each pair of neighbours occurs once.
fn ttiles_pair(first: u32, second: u32) -> u32 {
    let low = min(first, second);
    let block = low * (2u * ttiles_colors - low);
    if (first == ttiles_colors - 1u) {
        if (second == 0u) { return ttiles_colors * ttiles_colors - 1u; }
        return second * (2u * ttiles_colors - second) - 1u;
    }
    if (first == second) { return block; }
    if (first < second) { return block + 2u * (second - first) - 1u; }
    return block + 2u * (first - second);
}

/// Where the tile with these corners lies in a packing of an odd number of colours: y C^2 + x, from the lower left.
fn ttiles_odd_place(ne: u32, se: u32, sw: u32, nw: u32) -> u32 {
    let side = ttiles_colors * ttiles_colors;
    let west = ttiles_pair(sw, nw);
    let x = (ttiles_pair(se, ne) + side - west) % side;
    // Column x is shifted by x (x - 1) / 2; the even factor is halved first.
    var shift = x * ((max(x, 1u) - 1u) / 2u);
    if (x % 2u == 0u) { shift = x / 2u * (x + side - 1u); }
    return (west + side - shift % side) % side * side + x;
}

/// The place of the tile with these corners in a packing of an even number of colours: the lowest digits of the corners
/// say which of 4 x 4 places, the others which block.
fn ttiles_even_place(ne: u32, se: u32, sw: u32, nw: u32) -> u32 {
    let base = max(ttiles_colors / 2u, 1u);
    let low = sw % 2u + 2u * (se % 2u) + 4u * (nw % 2u) + 8u * (ne % 2u);
    // 0, 3, 12, 13, 4, 15, 2, 11, 1, 8, 5, 14, 7, 6, 9, 10: four bits each.
    let place = (select(0xa967e581u, 0xb2f4dc30u, low < 8u) >> (4u * (low % 8u))) & 15u;
    let x = place % 4u;
    let y = place / 4u;
    // The window's even row holds the digits of a, its odd one those of b; even columns the lower digits.
    let is_west = x % 2u == 0u;
    let south_low = select(se, sw, is_west);
    let south_high = select(sw, se, is_west);
    let north_low = select(ne, nw, is_west);
    let north_high = select(nw, ne, is_west);
    let is_south = y % 2u == 0u;
    var a = select(north_low, south_low, is_south) / 2u + base * (select(north_high, south_high, is_south) / 2u);
    var b_digit = select(south_low, north_low, is_south) / 2u;
    if (y == 3u) { a = (a + base * base - 1u) % (base * base); }
    if (x == 3u) { b_digit = (b_digit + base - 1u) % base; }
    let b_high = select(south_high, north_high, is_south) / 2u;
    return (4u * a + y) * ttiles_colors * ttiles_colors + 4u * (b_digit + base * b_high) + x;
}

/// The place in a row of C^2 tiles of the one with these colours in the west and the east, or south and north.
fn ttiles_domino_place(first: u32, second: u32) -> u32 {
    if (first == second) { return select((first + 1u) * (first + 1u) - 2u, 0u, first == 0u); }
    if (first < second) { return second * second + 2u * first; }
    return select(first * first + 2u * second - 1u, (first + 1u) * (first + 1u) - 1u, second == 0u);
}

/// The place in the atlas, y C^2 + x from the lower left, of the tile at a place of the plane; it is its layer as well.
fn ttiles_place(seed: u32, tile: vec2<i32>) -> u32 {
    let x = u32(tile.x);
    let y = u32(tile.y);
    if (ttiles_wang) {
        let south_north = ttiles_domino_place(ttiles_edge_color(seed, x, y, 0u), ttiles_edge_color(seed, x, y + 1u, 0u));
        let west_east = ttiles_domino_place(ttiles_edge_color(seed, x, y, 1u), ttiles_edge_color(seed, x + 1u, y, 1u));
        return south_north * ttiles_colors * ttiles_colors + west_east;
    }
    let ne = ttiles_color(seed, x + 1u, y + 1u);
    let se = ttiles_color(seed, x + 1u, y);
    let sw = ttiles_color(seed, x, y);
    let nw = ttiles_color(seed, x, y + 1u);
    if (ttiles_colors % 2u == 1u) { return ttiles_odd_place(ne, se, sw, nw); }
    return ttiles_even_place(ne, se, sw, nw);
}

/// How far a texel lies beyond the tile, in tiles.
fn ttiles_beyond(texel: vec2<i32>, size: i32) -> vec2<i32> {
    return vec2<i32>(texel >= vec2<i32>(size)) - vec2<i32>(texel < vec2<i32>(0));
}

fn ttiles_layer_texel(layers: texture_2d_array<f32>, seed: u32, tile: vec2<i32>, texel: vec2<i32>, level: i32) -> vec4<f32> {
    let size = ttiles_size >> u32(level);
    let beyond = ttiles_beyond(texel, size);
    let inside = texel - beyond * size;
    return textureLoad(layers, vec2<i32>(inside.x, size - 1 - inside.y), i32(ttiles_place(seed, tile + beyond)), level);
}

fn ttiles_layer_level(layers: texture_2d_array<f32>, seed: u32, tile: vec2<i32>, inside: vec2<f32>, level: i32) -> vec4<f32> {
    let texels = inside * f32(ttiles_size >> u32(level)) - 0.5;
    let t = vec2<i32>(floor(texels));
    let part = texels - floor(texels);
    return mix(mix(ttiles_layer_texel(layers, seed, tile, t, level),
                   ttiles_layer_texel(layers, seed, tile, t + vec2<i32>(1, 0), level), part.x),
               mix(ttiles_layer_texel(layers, seed, tile, t + vec2<i32>(0, 1), level),
                   ttiles_layer_texel(layers, seed, tile, t + vec2<i32>(1, 1), level), part.x), part.y);
}

/// Each texel through its own tile, from layers; `texels` says how many of level 0 a pixel covers.
fn ttiles_layered(layers: texture_2d_array<f32>, seed: u32, tile: vec2<i32>, inside: vec2<f32>, texels: f32) -> vec4<f32> {
    var level = 0;
    var wide = 1.0;
    while (texels >= 2.0 * wide && level < ttiles_levels - 1) {
        level++;
        wide *= 2.0;
    }
    let fine = ttiles_layer_level(layers, seed, tile, inside, level);
    if (level == ttiles_levels - 1) { return fine; }
    let coarse = ttiles_layer_level(layers, seed, tile, inside, level + 1);
    return mix(fine, coarse, clamp(texels / wide - 1.0, 0.0, 1.0));
}

/// Looks a texel up by the filters of hardware, in the packed atlas, which repeats at its borders; dx, dy: derivatives
/// of the place, in tiles a pixel.
fn ttiles_packed(atlas: texture_2d<f32>, repeating: sampler, seed: u32, tile: vec2<i32>, inside: vec2<f32>,
                 dx: vec2<f32>, dy: vec2<f32>) -> vec4<f32> {
    let place = ttiles_place(seed, tile);
    let side = ttiles_colors * ttiles_colors;
    let at = (vec2<f32>(f32(place % side), f32(place / side)) + inside) / f32(side);
    let down = vec2<f32>(1.0, -1.0) / f32(side); // rows of the atlas go from north to south
    return textureSampleGrad(atlas, repeating, vec2<f32>(at.x, 1.0 - at.y), dx * down, dy * down);
}
