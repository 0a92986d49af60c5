// Views of endless textures that are no tiles, as light: a work-item a pixel. Pieces of the exemplar are looked up at
// the level that fits a pixel's footprint, and what they show is blended, as graphics cards do it.
//
// See endless_texture.cl for the papers; Deliot and Heitz, Procedural Stochastic Textures by Tiling and Blending, 2019,
// section 1.5, for tables back of each level. The plain twin is host/texture/mapping/endless_map_reference.cpp: no
// library function but square root and floor of double precision, which are exact, and the same order of sums.
//
// Needs METHOD, CHANNELS (1 or 3), EXPONENT, GAIN, RESTORED and TURNED (0 or 1) of EndlessTexture.

#include "kernels/common/fields/endless_map.h"
#include "kernels/common/fields/endless_texture.h"
#include "kernels/common/fields/plane_view.clh"
#include "runtime/texture_tiles.h"

#define PIECES (METHOD == METHOD_OFFSETS ? 4 : 3)
#include "kernels/common/fields/blended_pieces.clh"

/// The levels and tables in which pieces are looked up.
typedef struct
{
    const struct EndlessPlane* plane;
    const struct EndlessWindow* origin;
    const struct ExemplarLevels* levels;
    global const float* exemplar; ///< light from 0 to 65535; of Gaussian exemplars numbers from the mean on
    global const float* encoded;  ///< numbers from 0 to 255 by the root of light
    global const float* light;    ///< of these numbers, then half the second derivatives of it
    global const float* means;    ///< of the channels, encoded, at each level
    global const float* inverse;  ///< tables back at each level: means and variances of each coordinate; of turned
                                  ///< hexagons cosines and sines
} Exemplar;

/// Two levels, and the part of the upper one.
typedef struct
{
    int lower;
    float upper;
} Level;

INLINE float between(float a, float b, float part) { return a + (b - a) * part; }

/// The texel beside the border that is meant: of exemplars that go on at the other side, or of the border's own.
INLINE int texel_inside(Exemplar from, int at, int size)
{
    if (METHOD != METHOD_REPEATED && !from.plane->is_tileable) return clamp(at, 0, size - 1);
    at += at < 0 ? size : 0;
    return at - (at >= size ? size : 0);
}

/// The four nearest texels of a level, bilinearly; `column` and `row` count from the middle of the first texel of level
/// 0. The texels of a level divide the exemplar evenly.
INLINE void add_level(Exemplar from, int level, double column, double row, float weight, float* values)
{
    const int width = from.levels->widths[level], height = from.levels->heights[level];
    const double x = (column + 0.5) * ((double)width / from.levels->widths[0]) - 0.5;
    const double y = (row + 0.5) * ((double)height / from.levels->heights[0]) - 0.5;
    const double west = floor(x), north = floor(y);
    const float east = (float)(x - west), south = (float)(y - north);
    for (int k = 0; k < 4; ++k) {
        const int i = texel_inside(from, (int)west + k % 2, width), j = texel_inside(from, (int)north + k / 2, height);
        const float share = weight * ((k % 2 ? east : 1 - east) * (k / 2 ? south : 1 - south));
        global const float* texel =
            from.exemplar + from.levels->offsets[level] + ((uint)j * (uint)width + (uint)i) * CHANNELS;
        for (int c = 0; c < CHANNELS; ++c) values[c] += share * texel[c];
    }
}

INLINE void look_up(Exemplar from, Level level, double column, double row, float* values)
{
    for (int c = 0; c < CHANNELS; ++c) values[c] = 0;
    add_level(from, level.lower, column, row, 1 - level.upper, values);
    if (level.upper > 0) add_level(from, level.lower + 1, column, row, level.upper, values);
}

/// Looks a piece up: that of a lattice point, from which the place is at (dx, dy).
INLINE void look_up_piece(Exemplar from, Level level, uint x, uint y, double dx, double dy, float* values)
{
    const struct EndlessPlane* plane = from.plane;
    const uint hash = ttiles_mix(ttiles_mix(ttiles_mix(plane->seed) + x) + y);
    double column = plane->reach_x + (int)(((hash & 0xffffu) * (uint)plane->choices_x) >> 16);
    double row = plane->reach_y + (int)(((hash >> 16) * (uint)plane->choices_y) >> 16);
    if (TURNED) {
        const uint turn = ttiles_mix(hash) >> 24;
        const double cosine = from.inverse[turn], sine = from.inverse[TURNS + turn];
        const double right = (cosine * dx - sine * dy) / TURN_UNIT;
        dy = (sine * dx + cosine * dy) / TURN_UNIT;
        dx = right;
    }
    if (plane->is_tileable) {
        column += dx;
        row += dy;
        column += column < 0 ? plane->width : 0;
        row += row < 0 ? plane->height : 0;
        column -= column >= plane->width ? plane->width : 0;
        row -= row >= plane->height ? plane->height : 0;
    } else {
        const double reach_x = plane->reach_x, reach_y = plane->reach_y;
        column += dx < -reach_x ? -reach_x : dx > reach_x ? reach_x : dx;
        row += dy < -reach_y ? -reach_y : dy > reach_y ? reach_y : dy;
    }
    look_up(from, level, column, row, values);
}

/// A lattice number that may be beyond 32 bits, modulo 2^32.
INLINE uint lattice_number(double number) { return (uint)(number - floor(number * 0x1p-32) * 0x1p32); }

/// The pieces of the triangle around a place, in pixels from the origin's lattice point, and their weights.
INLINE void see_triangle(Exemplar from, Level level, double x, double y, float* values, float* weights)
{
    const double cell = from.plane->cell, height = from.plane->row, whole = 2 * cell * height;
    const double j = floor(y / height), dy = y - j * height;
    x -= j * (cell / 2); // from the row's own lattice point
    const double a = 2 * height * x - cell * dy, i = floor(a / whole);
    const double fa = a - i * whole, fb = 2 * cell * dy;
    const int is_upper = fa + fb >= whole;
    const double parts[3] = {is_upper ? fa + fb - whole : whole - fa - fb, is_upper ? whole - fb : fb,
                             is_upper ? whole - fa : fa};
    const int east[3] = {is_upper, is_upper, 1 - is_upper}, south[3] = {is_upper, 1 - is_upper, is_upper};
    for (int k = 0; k < 3; ++k) {
        look_up_piece(from, level, from.origin->cell_x + lattice_number(i) + (uint)east[k],
                      from.origin->cell_y + lattice_number(j) + (uint)south[k],
                      x - (i + east[k]) * cell - south[k] * (cell / 2), dy - south[k] * height, values + k * CHANNELS);
        const float part = (float)parts[k] * from.plane->inverse_unit;
        weights[k] = power(part < 0 ? 0 : part, EXPONENT);
    }
}

/// The pieces of the square around a place, in pixels from the origin's lattice point, and their weights.
INLINE void see_square(Exemplar from, Level level, double x, double y, float* values, float* weights)
{
    const double cell = from.plane->cell;
    const double i = floor(x / cell), j = floor(y / cell), dx = x - i * cell, dy = y - j * cell;
    const float east = smooth_part((float)dx * from.plane->inverse_unit);
    const float south = smooth_part((float)dy * from.plane->inverse_unit);
    for (int k = 0; k < 4; ++k) {
        const int u = k % 2, v = k / 2;
        look_up_piece(from, level, from.origin->cell_x + lattice_number(i) + (uint)u,
                      from.origin->cell_y + lattice_number(j) + (uint)v, dx - u * cell, dy - v * cell,
                      values + k * CHANNELS);
        weights[k] = (u ? east : 1.0f - east) * (v ? south : 1.0f - south);
    }
}

/// The number from 0 to 255 that is written for light.
INLINE float encoded_number(Exemplar from, float light)
{
    const double root = sqrt((double)light) * ENCODED_STEPS;
    const int entry = min((int)root, ENCODED_ENTRIES - 2);
    return between(from.encoded[entry], from.encoded[entry + 1], (float)(root - entry));
}

/// The mean light of numbers with this mean and variance: by sRGB's curve, which is nearly a square.
INLINE float mean_light(Exemplar from, float number, float variance)
{
    number = number < 0 ? 0 : number > 255 ? 255 : number;
    const int entry = min((int)number, 254);
    const float part = number - (float)entry;
    return between(from.light[entry], from.light[entry + 1], part) +
           between(from.light[256 + entry], from.light[257 + entry], part) * variance;
}

/// The lightness of encoded channels, from 0 to 1.
INLINE float lightness(const float* values)
{
    if (CHANNELS == 1) return 256 * values[0] * (1.0f / 65280.0f);
    return (77 * values[0] + 150 * values[1] + 29 * values[2]) * (1.0f / 65280.0f);
}

/// The mean of a channel at a level.
INLINE float mean_of(Exemplar from, Level level, int c)
{
    const int above = min(level.lower + 1, from.levels->top);
    return between(from.means[3 * level.lower + c], from.means[3 * above + c], level.upper);
}

/// The blend of what pieces show, encoded.
INLINE void blend(Exemplar from, Level level, float* values, float* weights, float* numbers)
{
    for (int k = 0; k < PIECES * CHANNELS; ++k) values[k] = encoded_number(from, values[k]);
    if (METHOD == METHOD_HEXAGONS)
        for (int k = 0; k < PIECES; ++k)
            weights[k] = weights[k] * (1.0f + from.plane->falloff * (lightness(values + k * CHANNELS) - 1.0f));
    divide_weights(weights);
    gain_weights(weights);
    const float factor = RESTORED ? restoring_factor(weights) : 1.0f;
    for (int c = 0; c < CHANNELS; ++c) {
        float sum = weights[0] * values[c];
        for (int k = 1; k < PIECES; ++k) sum += weights[k] * values[k * CHANNELS + c];
        if (RESTORED) {
            const float mean = mean_of(from, level, c);
            sum = mean + (sum - mean) * factor;
        }
        numbers[c] = sum;
    }
}

/// An entry of the tables back between two levels; `which` is twice the coordinate, and one more of its variance.
INLINE float between_tables(Exemplar from, Level level, int which, int entry)
{
    const int above = min(level.lower + 1, from.levels->top);
    return between(from.inverse[(2 * CHANNELS * level.lower + which) * INVERSE_ENTRIES + entry],
                   from.inverse[(2 * CHANNELS * above + which) * INVERSE_ENTRIES + entry], level.upper);
}

/// The blend of Gaussian numbers, transformed back by the tables of two levels, and the variances of what these
/// averaged.
INLINE void blend_gaussian(Exemplar from, Level level, const float* values, float* weights, float* numbers,
                           float* variances)
{
    divide_weights(weights);
    const float factor = restoring_factor(weights);
    for (int c = 0; c < CHANNELS; ++c) {
        numbers[c] = mean_of(from, level, c);
        variances[c] = 0;
    }
    for (int k = 0; k < CHANNELS; ++k) {
        float sum = weights[0] * values[k];
        for (int piece = 1; piece < 3; ++piece) sum += weights[piece] * values[piece * CHANNELS + k];
        const int number = (int)(sum * factor + (GAUSSIAN_ZERO + 0.5f));
        const int entry = clamp(number, 0, 65535) / (65536 / INVERSE_ENTRIES);
        const float coordinate = between_tables(from, level, 2 * k, entry);
        const float variance = between_tables(from, level, 2 * k + 1, entry);
        for (int c = 0; c < CHANNELS; ++c) {
            const float axis = from.plane->axes[3 * k + c];
            numbers[c] = numbers[c] + coordinate * axis;
            variances[c] = variances[c] + variance * axis * axis;
        }
    }
}

/// Adds the light of the texture at a place, in pixels from the origin's lattice point.
INLINE void add_place(Exemplar from, Level level, double x, double y, float weight, float* sum)
{
    if (METHOD == METHOD_REPEATED) {
        float shown[CHANNELS];
        const double width = from.plane->width, height = from.plane->height;
        x -= floor(x / width) * width; // may be rounded to the width
        y -= floor(y / height) * height;
        look_up(from, level, x >= width ? 0 : x, y >= height ? 0 : y, shown);
        for (int c = 0; c < CHANNELS; ++c) sum[c] += weight * shown[c];
        return;
    }
    float values[4 * CHANNELS], weights[4], numbers[CHANNELS], variances[CHANNELS];
    if (METHOD == METHOD_OFFSETS)
        see_square(from, level, x, y, values, weights);
    else
        see_triangle(from, level, x, y, values, weights);
    if (METHOD == METHOD_BLENDED)
        blend_gaussian(from, level, values, weights, numbers, variances);
    else
        blend(from, level, values, weights, numbers);
    for (int c = 0; c < CHANNELS; ++c)
        sum[c] += weight * mean_light(from, numbers[c], METHOD == METHOD_BLENDED ? variances[c] : 0.0f);
}

/// Adds the texture where a sample sees it. Rows of the texture go to the south.
void add_sample(const struct TextureView* view, Exemplar from, double column, double row, float* sum)
{
    SeenPlace seen;
    if (!see_plane(view, TILE_TEXELS, column, row, &seen)) {
        for (int c = 0; c < CHANNELS; ++c) sum[c] += (float)SKY_LIGHT;
        return;
    }
    Level level;
    level.lower = lower_level(seen.texels, from.levels->top, &level.upper);
    if (level.lower == from.levels->top) level.upper = 0;
    for (int probe = 0; probe < seen.probes; ++probe) {
        double u, v;
        find_probe(&seen, probe, &u, &v);
        double x = u * TILE_TEXELS, y = -v * TILE_TEXELS;
        x = view->filter == FILTER_NEAREST ? floor(x) : x - 0.5;
        y = view->filter == FILTER_NEAREST ? floor(y) : y - 0.5;
        add_place(from, level, from.origin->start_x + x, from.origin->start_y + y, (float)(1.0 / seen.probes), sum);
    }
}

/// Pixels from `first` on, `count` of them. `origin` is the pixel of the texture at the lower left corner of the view's
/// tile.
kernel void map_endless(struct TextureView view, struct EndlessPlane plane, struct EndlessWindow origin,
                        struct ExemplarLevels levels, uint first, uint count, global const float* exemplar,
                        global const float* encoded, global const float* light, global const float* means,
                        global const float* inverse, global float* pixels)
{
    const uint id = get_global_id(0);
    if (id >= count) return;
    const uint column = (first + id) % (uint)view.width, row = (first + id) / (uint)view.width;
    const Exemplar from = {&plane, &origin, &levels, exemplar, encoded, light, means, inverse};
    float sum[CHANNELS];
    for (int c = 0; c < CHANNELS; ++c) sum[c] = 0;
    for (int j = 0; j < view.samples; ++j)
        for (int i = 0; i < view.samples; ++i)
            add_sample(&view, from, (double)column * view.samples + i + 0.5, (double)row * view.samples + j + 0.5, sum);
    for (int c = 0; c < CHANNELS; ++c)
        pixels[id * CHANNELS + c] = (float)(sum[c] / (double)(view.samples * view.samples));
}
