// Colours of endless textures at pixels of the plane: a work-item a pixel, a row of work-groups a row of pixels.
//
// Quilez, Texture repetition, 2015; Mikkelsen, Practical Real-Time Hex-Tiling, 2022; Heitz and Neyret, High-Performance
// By-Example Noise using a Histogram-Preserving Blending Operator, 2018; Burley, On Histogram-Preserving Blending for
// Randomized Texture Tiling, 2019; Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.4. See
// host/texture/endless; the plain twin is endless_reference.cpp there.
//
// Needs METHOD of the contract, CHANNELS (1 or 3), CELL and ROW, the plane's cell and row, by which so much is divided
// that they are known when the kernel is built, EXPONENT, GAIN, RESTORED and TURNED (0 or 1) of EndlessTexture, and
// COLORS of tiles.

#include "runtime/texture_tiles.h"

#include "kernels/common/fields/endless_texture.h"

#define PIECES (METHOD == METHOD_OFFSETS ? 4 : 3)
#include "kernels/common/fields/blended_pieces.clh"

/// The texel of the exemplar that a pixel so far from a lattice point sees through that point's piece.
INLINE uint piece_texel(struct EndlessPlane plane, uint x, uint y, int dx, int dy)
{
    const uint hash = ttiles_mix(ttiles_mix(ttiles_mix(plane.seed) + x) + y);
    int column = plane.reach_x + (int)(((hash & 0xffffu) * (uint)plane.choices_x) >> 16);
    int row = plane.reach_y + (int)(((hash >> 16) * (uint)plane.choices_y) >> 16);
    if (plane.is_tileable) {
        column += dx;
        row += dy;
        column += column < 0 ? plane.width : 0;
        row += row < 0 ? plane.height : 0;
        column -= column >= plane.width ? plane.width : 0;
        row -= row >= plane.height ? plane.height : 0;
    } else {
        column += clamp(dx, -plane.reach_x, plane.reach_x);
        row += clamp(dy, -plane.reach_y, plane.reach_y);
    }
    return (uint)row * (uint)plane.width + (uint)column;
}

/// Returns the colour of a turned piece as bytes of the channels. It interpolates between the four texels of the
/// exemplar around a place, whose position is rounded to 256ths of a texel.
INLINE uint turned_texel(struct EndlessPlane plane, global const uint* texels, global const float* turns, uint x,
                         uint y, int dx, int dy)
{
    const uint hash = ttiles_mix(ttiles_mix(ttiles_mix(plane.seed) + x) + y), turn = ttiles_mix(hash) >> 24;
    const int cosine = (int)turns[turn], sine = (int)turns[TURNS + turn];
    const int right = (cosine * dx - sine * dy + 64) >> 7, down = (sine * dx + cosine * dy + 64) >> 7;
    const int east = right & 255, south = down & 255;
    int column = plane.reach_x + (int)(((hash & 0xffffu) * (uint)plane.choices_x) >> 16) + (right >> 8);
    int row = plane.reach_y + (int)(((hash >> 16) * (uint)plane.choices_y) >> 16) + (down >> 8);
    int columns[2], rows[2];
    for (int k = 0; k < 2; ++k) {
        columns[k] = column + k;
        rows[k] = row + k;
        if (plane.is_tileable) {
            columns[k] = (columns[k] + 2 * plane.width) % plane.width; // a piece reaches less than two exemplars far
            rows[k] = (rows[k] + 2 * plane.height) % plane.height;
        }
    }
    uint bytes = 0;
    for (int c = 0; c < CHANNELS; ++c) {
        int sum = 1 << 15;
        for (int k = 0; k < 4; ++k) {
            const uint texel = texels[rows[k / 2] * plane.width + columns[k % 2]];
            sum += (k % 2 ? east : 256 - east) * (k / 2 ? south : 256 - south) * (int)((texel >> (8 * c)) & 0xffu);
        }
        bytes |= (uint)(sum >> 16) << (8 * c);
    }
    return bytes;
}

/// Texels and weights of the corners of the triangle around a pixel, or what turned pieces show there; `x` and `y` from
/// the window's lattice point.
INLINE void find_triangle(struct EndlessPlane plane, struct EndlessWindow window, global const uint* exemplar,
                          global const float* turns, int x, int y, uint* texels, float* weights)
{
    const int whole = 2 * CELL * ROW;
    const int j = y / ROW, dy = y - j * ROW;
    x -= j * (CELL / 2); // from the row's own lattice point
    const int a = 2 * ROW * x - CELL * dy;
    int i = a / whole;
    i -= a < i * whole;
    const int fa = a - i * whole, fb = 2 * CELL * dy;
    const int is_upper = fa + fb >= whole;
    const int parts[3] = {is_upper ? fa + fb - whole : whole - fa - fb, is_upper ? whole - fb : fb,
                          is_upper ? whole - fa : fa};
    const int east[3] = {is_upper, is_upper, 1 - is_upper}, south[3] = {is_upper, 1 - is_upper, is_upper};
    for (int k = 0; k < 3; ++k) {
        const uint u = window.cell_x + (uint)(i + east[k]), v = window.cell_y + (uint)(j + south[k]);
        const int right = x - (i + east[k]) * CELL - south[k] * (CELL / 2), down = dy - south[k] * ROW;
        texels[k] =
            TURNED ? turned_texel(plane, exemplar, turns, u, v, right, down) : piece_texel(plane, u, v, right, down);
        weights[k] = power((float)parts[k] * plane.inverse_unit, EXPONENT);
    }
}

/// Texels and weights of the corners of the square around a pixel; `x` and `y` from the window's lattice point.
INLINE void find_square(struct EndlessPlane plane, struct EndlessWindow window, int x, int y, uint* texels,
                        float* weights)
{
    const int i = x / CELL, j = y / CELL, dx = x - i * CELL, dy = y - j * CELL;
    const float east = smooth_part((float)dx * plane.inverse_unit), south = smooth_part((float)dy * plane.inverse_unit);
    for (int k = 0; k < 4; ++k) {
        const int u = k % 2, v = k / 2;
        texels[k] = piece_texel(plane, window.cell_x + (uint)(i + u), window.cell_y + (uint)(j + v), dx - u * CELL,
                                dy - v * CELL);
        weights[k] = (u ? east : 1.0f - east) * (v ? south : 1.0f - south);
    }
}

INLINE float byte_of(uint texel, int channel) { return (float)((texel >> (8 * channel)) & 0xffu); }

/// The lightness of a texel, from 0 to 1.
INLINE float lightness(uint texel)
{
    if (CHANNELS == 1) return (float)(256u * (texel & 0xffu)) * (1.0f / 65280.0f);
    return (float)(77u * (texel & 0xffu) + 150u * ((texel >> 8) & 0xffu) + 29u * ((texel >> 16) & 0xffu)) *
           (1.0f / 65280.0f);
}

INLINE uint rounded_byte(float v)
{
    v = v + 0.5f;
    v = v < 0.0f ? 0.0f : v > 255.0f ? 255.0f : v;
    return (uint)(int)v;
}

INLINE uint blended_bytes(struct EndlessPlane plane, global const uint* texels, const uint* places, float* weights)
{
    uint found[PIECES];
    for (int k = 0; k < PIECES; ++k) found[k] = TURNED ? places[k] : texels[places[k]];
    if (METHOD == METHOD_HEXAGONS)
        for (int k = 0; k < PIECES; ++k)
            weights[k] = weights[k] * (1.0f + plane.falloff * (lightness(found[k]) - 1.0f));
    divide_weights(weights);
    gain_weights(weights);
    const float factor = RESTORED ? restoring_factor(weights) : 1.0f;
    uint bytes = 0;
    for (int c = 0; c < CHANNELS; ++c) {
        float sum = weights[0] * byte_of(found[0], c);
        for (int k = 1; k < PIECES; ++k) sum += weights[k] * byte_of(found[k], c);
        if (RESTORED) sum = plane.means[c] + (sum - plane.means[c]) * factor;
        bytes |= rounded_byte(sum) << (8 * c);
    }
    return bytes;
}

/// A coordinate of a Gaussian exemplar, in its numbers from the mean on.
INLINE float gaussian_number(global const uint* texels, uint place, int k)
{
    if (CHANNELS == 1) return (float)((int)texels[place] - GAUSSIAN_ZERO);
    const uint pair = texels[2 * place + k / 2];
    return (float)((int)((pair >> (16 * (k % 2))) & 0xffffu) - GAUSSIAN_ZERO);
}

INLINE uint gaussian_bytes(struct EndlessPlane plane, global const uint* texels, global const float* inverse,
                           const uint* places, float* weights)
{
    divide_weights(weights);
    const float factor = restoring_factor(weights);
    float colors[CHANNELS];
    for (int c = 0; c < CHANNELS; ++c) colors[c] = plane.means[c];
    for (int k = 0; k < CHANNELS; ++k) {
        float sum = weights[0] * gaussian_number(texels, places[0], k);
        for (int piece = 1; piece < 3; ++piece) sum += weights[piece] * gaussian_number(texels, places[piece], k);
        const int number = (int)(sum * factor + (GAUSSIAN_ZERO + 0.5f));
        const int entry = clamp(number, 0, 65535) / (65536 / INVERSE_ENTRIES);
        const float coordinate = inverse[k * INVERSE_ENTRIES + entry];
        for (int c = 0; c < CHANNELS; ++c) colors[c] = colors[c] + coordinate * plane.axes[3 * k + c];
    }
    uint bytes = 0;
    for (int c = 0; c < CHANNELS; ++c) bytes |= rounded_byte(colors[c]) << (8 * c);
    return bytes;
}

INLINE uint tile_bytes(struct EndlessPlane plane, struct EndlessWindow window, global const uint* texels, int x, int y)
{
    // Tiles count from the south.
    const int from_south = window.start_y + window.height - 1 - y;
    const uint i = (uint)(x / CELL), j = (uint)(from_south / CELL);
    const uint column = (uint)x - i * CELL, row = (uint)from_south - j * CELL;
    const uint texel =
        METHOD == METHOD_WANG_TILES
            ? ttiles_wang_texel(plane.seed, COLORS, CELL, window.cell_x + i, window.cell_y + j, column, row)
            : ttiles_texel(plane.seed, COLORS, CELL, window.cell_x + i, window.cell_y + j, column, row);
    return texels[texel];
}

/// Bytes of the channels from the lowest on, row by row. `groups` work-groups make a row.
kernel void color_pixels(struct EndlessPlane plane, struct EndlessWindow window, uint groups, global const uint* texels,
                         global const float* inverse, global uint* pixels)
{
    const int row = (int)(get_group_id(0) / groups);
    const int column = (int)((get_group_id(0) % groups) * get_local_size(0) + get_local_id(0));
    if (column >= window.width || row >= window.height) return;
    const int x = window.start_x + column, y = window.start_y + row;
    uint bytes;
    if (METHOD == METHOD_REPEATED)
        bytes = texels[(y % ROW) * CELL + x % CELL];
    else if (METHOD >= METHOD_TILES)
        bytes = tile_bytes(plane, window, texels, x, row);
    else {
        uint places[PIECES];
        float weights[PIECES];
        if (METHOD >= METHOD_HEXAGONS)
            find_triangle(plane, window, texels, inverse, x, y, places, weights);
        else
            find_square(plane, window, x, y, places, weights);
        bytes = METHOD == METHOD_BLENDED ? gaussian_bytes(plane, texels, inverse, places, weights)
                                         : blended_bytes(plane, texels, places, weights);
    }
    pixels[row * window.width + column] = bytes;
}
