// The looks of objects of a distribution: sizes, turns and colours by their identity, shapes as radii by direction.
// Kernel and plain twin share it; it comes after runtime/object_distribution.h or, in kernels,
// object_distribution_gpu.h.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 7.6.1 and 7.6.2. Nothing here calls a library: cosines
// are polynomials, and directions are told apart by quotients, so that all devices draw the same.
#pragma once

#include "kernels/common/contract.h"

#ifdef __cplusplus
#include <cmath>
#define LOOKS_FUNCTION inline
#define LOOKS_TABLE const float*
#define LOOKS_ROOT std::sqrt
#else
#define LOOKS_FUNCTION static inline
#define LOOKS_TABLE global const float*
#define LOOKS_ROOT sqrt
#endif

CONTRACT(objects)

enum
{
    SHAPE_STEPS = 1024, ///< radii of a shape, all around
    MAX_LAYERS = 4,
    MAX_COLORS = 16,
    SPREAD_CONSTANT = 0, ///< a
    SPREAD_UNIFORM = 1,  ///< a to b
    SPREAD_NORMAL = 2,   ///< mean a, standard deviation b
    VIEW_PLANE = 0,      ///< x to the right, y upwards; in space, a slice
    VIEW_SPHERE = 1,
    VIEW_TORUS = 2,
    VIEW_CLOTH = 3, ///< a cloth on a round table, and nothing else
    VIEW_FLOOR = 4, ///< the floor around it
    SHOWS_LAYERS = 0,
    SHOWS_CELLS = 1,       ///< colours of the nearest objects around their disks
    SHOWS_FRAMES = 2,      ///< the local coordinates as colours
    SHOWS_INSIDE = 3,      ///< this and those that follow are what a look-up returns: black in disks
    SHOWS_COORDINATES = 4, ///< of the nearest point, as red, green and blue
    SHOWS_NUMBER = 5,      ///< a random colour of the nearest point's number
    SHOWS_DISTANCE = 6,    ///< from the nearest point, white from three radii on
    PURPOSE_SIZE = 0,      ///< each takes six numbers
    PURPOSE_TURN = 6,
    PURPOSE_ASPECT = 12,
    PURPOSE_SHAPE = 18,
    PURPOSE_COLOR = 24, ///< and after it one of each layer
    PURPOSE_FACE = 32   ///< and after it three of each face of a body
};

/// Values that differ from object to object.
struct Spread
{
    uint kind;
    float a, b;
};

/// One of the shapes of an object; later ones lie over earlier ones.
struct Layer
{
    uint shape, shapes; ///< the first one, and how many to choose from
    float scale;        ///< of the object's size
    uint color, colors; ///< the same in the palette
};

/// The tile set and the tiling: see ptiles_tiling in runtime/poisson_tiles_gpu.h.
struct ObjectTiles
{
    uint kind, dimension, colors, tiles, points_per_tile, seed;
    int period, low, step, below, above;
};

struct ObjectScene
{
    uint width, height; ///< pixels
    uint samples;       ///< of a pixel, along each axis
    uint view;
    long left, bottom, z;             ///< the first sample's place in tiles times 2^32
    long step;                        ///< between samples
    float radius;                     ///< of disks, tiles
    float extent;                     ///< of the picture's height in tiles
    struct Spread size, turn, aspect; ///< turns are whole ones
    uint layers;
    struct Layer layer[MAX_LAYERS];
    uint background;          ///< a colour
    uint ripples;             ///< the colour into which noise fades the background; the same: none
    float noise_cells;        ///< of the noise, a tile
    uint shows;               ///< SHOWS_LAYERS, ...
    uint has_bodies;          ///< layers are faces of bodies in space
    float modulation;         ///< of the layers' colours by noise, from 0 to 1
    uint palette[MAX_COLORS]; ///< 0xrrggbb
};

/// The point of an object in parts of the picture, or in those of a surface's quad.
struct ObjectCoordinates
{
    float x, y, z;
};

LOOKS_FUNCTION float root_of(float squared) { return LOOKS_ROOT(squared); }

LOOKS_FUNCTION float within(float x, float low, float high) { return x < low ? low : x > high ? high : x; }

/// The value of an object, at least `low` and at most `high`.
LOOKS_FUNCTION float spread_value(struct Spread spread, uint id, uint purpose, float low, float high)
{
    float value = spread.a;
    if (spread.kind == SPREAD_UNIFORM) value = spread.a + (spread.b - spread.a) * (float)pobjects_uniform(id, purpose);
    if (spread.kind == SPREAD_NORMAL) value = spread.a + spread.b * (float)pobjects_normal(id, purpose);
    return within(value, low, high);
}

LOOKS_FUNCTION float whole_part(float x)
{
    const float cut = (float)(int)x;
    return cut > x ? cut - 1 : cut;
}

/// The cosine of whole turns, to 1e-6: Taylor's series of a quarter, mirrored.
LOOKS_FUNCTION float turn_cosine(float turns)
{
    float part = turns - whole_part(turns);
    if (part > 0.5f) part = 1 - part;
    const float sign = part > 0.25f ? -1.0f : 1.0f;
    if (part > 0.25f) part = 0.5f - part;
    const float x = part * 6.2831853f, s = x * x;
    return sign * (1 - s / 2 * (1 - s / 12 * (1 - s / 30 * (1 - s / 56 * (1 - s / 90)))));
}

/// The radius of a shape in the direction of (x, y): its steps go around by quotients instead of angles.
LOOKS_FUNCTION float shape_radius(LOOKS_TABLE shapes, uint shape, float x, float y)
{
    const float sum = (x < 0 ? -x : x) + (y < 0 ? -y : y);
    if (sum == 0) return 1;
    const float around = y >= 0 ? (x >= 0 ? y / sum : 1 - x / sum) : (x < 0 ? 2 - y / sum : 3 + x / sum);
    const float at = around * (SHAPE_STEPS / 4);
    const uint step = (uint)at;
    const float part = at - (float)step;
    const uint row = shape * SHAPE_STEPS;
    return shapes[row + step % SHAPE_STEPS] * (1 - part) + shapes[row + (step + 1) % SHAPE_STEPS] * part;
}

/// The slope of Perlin's noise at a corner of its lattice, times the way from there: Perlin, Improving noise, 2002.
LOOKS_FUNCTION float noise_corner(int ix, int iy, int iz, float x, float y, float z)
{
    const uint slope = pobjects_bits(pobjects_bits((uint)ix, (uint)iy), (uint)iz) >> 28;
    const float u = slope < 8 ? x : y, v = slope < 4 ? y : slope == 12 || slope == 14 ? x : z;
    return (slope & 1 ? -u : u) + (slope & 2 ? -v : v);
}

/// Perlin's noise, moved to 0 to 1.
LOOKS_FUNCTION float smooth_noise(float x, float y, float z)
{
    const float fx = whole_part(x), fy = whole_part(y), fz = whole_part(z);
    const int ix = (int)fx, iy = (int)fy, iz = (int)fz;
    const float px = x - fx, py = y - fy, pz = z - fz;
    const float u = px * px * px * (px * (px * 6 - 15) + 10), v = py * py * py * (py * (py * 6 - 15) + 10),
                w = pz * pz * pz * (pz * (pz * 6 - 15) + 10);
    float sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        sum += noise_corner(ix + i, iy + j, iz + k, px - (float)i, py - (float)j, pz - (float)k) * (i ? u : 1 - u) *
               (j ? v : 1 - v) * (k ? w : 1 - w);
    }
    return within((sum + 1) / 2, 0, 1);
}

/// A mixture of two colours; 0: the first.
LOOKS_FUNCTION uint mixed(uint first, uint second, float share)
{
    uint color = 0;
    for (uint shift = 0; shift < 24; shift += 8) {
        const float a = (float)(first >> shift & 255), b = (float)(second >> shift & 255);
        color |= (uint)(a + (b - a) * share + 0.5f) << shift;
    }
    return color;
}

/// True if the place u of a body of flat faces is inside it: faces look in random directions, at distances from 1/2 on.
LOOKS_FUNCTION int in_body(uint id, uint faces, float scale, float x, float y, float z)
{
    for (uint face = 0; face < faces; ++face) {
        float nx = (float)pobjects_uniform(id, PURPOSE_FACE + 4 * face) * 2 - 1;
        float ny = (float)pobjects_uniform(id, PURPOSE_FACE + 4 * face + 1) * 2 - 1;
        float nz = (float)pobjects_uniform(id, PURPOSE_FACE + 4 * face + 2) * 2 - 1;
        const float along = nx * x + ny * y + nz * z, squared = nx * nx + ny * ny + nz * nz;
        const float away = scale * (0.5f + 0.35f * (float)pobjects_uniform(id, PURPOSE_FACE + 4 * face + 3));
        if (along > 0 && along * along > away * away * squared) return 0;
    }
    return 1;
}

/// An output of the function as a colour; `away`: the distance from the object's point, in tiles.
LOOKS_FUNCTION uint output_color(const struct ObjectScene* scene, uint id, struct ObjectCoordinates at, float away,
                                 uint inside)
{
    if (scene->shows == SHOWS_INSIDE) return inside ? 0 : 0xffffff;
    if (scene->shows == SHOWS_NUMBER) return pobjects_bits(id, PURPOSE_COLOR) & 0xffffff;
    if (scene->shows == SHOWS_DISTANCE) return mixed(0, 0xffffff, within(away / (3 * scene->radius), 0, 1));
    return mixed(0, 0xff0000, within(at.x, 0, 1)) | mixed(0, 0x00ff00, within(at.y, 0, 1)) |
           mixed(0, 255, within(at.z, 0, 1));
}

/// The colour of an object at `offset` from its point, in tiles, or `behind` where it has a hole there; `inside` is set
/// to whether the place is in its disk.
LOOKS_FUNCTION uint object_color(const struct ObjectScene* scene, LOOKS_TABLE shapes, uint id, float x, float y,
                                 float z, struct ObjectCoordinates at, uint behind, uint* inside)
{
    const float size = spread_value(scene->size, id, PURPOSE_SIZE, 0, 1), disk = scene->radius * size;
    *inside = x * x + y * y + z * z < disk * disk;
    if (scene->shows >= SHOWS_INSIDE) return output_color(scene, id, at, root_of(x * x + y * y + z * z), *inside);
    if (scene->shows == SHOWS_CELLS) {
        const uint own =
            scene->palette[scene->layer[0].color + pobjects_bits(id, PURPOSE_COLOR) % scene->layer[0].colors];
        return x * x + y * y + z * z < disk * disk / 100 ? 0 : *inside ? own : mixed(own, 0xffffff, 0.6f);
    }
    if (!*inside) return behind;
    const float turn = spread_value(scene->turn, id, PURPOSE_TURN, -1000, 1000);
    const float aspect = spread_value(scene->aspect, id, PURPOSE_ASPECT, 0.01f, 100);
    const float cosine = turn_cosine(turn), sine = turn_cosine(turn - 0.25f);
    float u = (cosine * x + sine * y) / disk, v = (cosine * y - sine * x) / disk;
    if (aspect >= 1)
        v *= aspect;
    else
        u /= aspect;
    const float w = z / disk;
    if (u * u + v * v + w * w >= 1) return behind;
    if (scene->shows == SHOWS_FRAMES)
        return mixed(0, 0xff0000, (u + 1) / 2) | mixed(0, 0x00ff00, (v + 1) / 2) |
               (scene->has_bodies ? mixed(0, 255, (w + 1) / 2) : 96);
    uint color = behind;
    for (uint i = 0; i < scene->layers; ++i) {
        const struct Layer layer = scene->layer[i];
        const uint shape = layer.shape + pobjects_bits(id, PURPOSE_SHAPE) % layer.shapes;
        if (scene->has_bodies) {
            // Faces of a body: none is a ball, "1" a cube within the ball, more a stone.
            const float reach = layer.scale * 0.57735f;
            const uint is_there = shape == 0 ? u * u + v * v + w * w < layer.scale * layer.scale
                                  : shape == 1
                                      ? (u < 0 ? -u : u) < reach && (v < 0 ? -v : v) < reach && (w < 0 ? -w : w) < reach
                                      : (uint)in_body(id, shape, layer.scale, u, v, w);
            if (!is_there) continue;
        } else {
            const float radius = layer.scale * shape_radius(shapes, shape, u, v);
            if (u * u + v * v >= radius * radius) continue;
        }
        color = scene->palette[layer.color + pobjects_bits(id, PURPOSE_COLOR + i) % layer.colors];
    }
    return color;
}

/// The background at a place, in tiles.
LOOKS_FUNCTION uint background_color(const struct ObjectScene* scene, float x, float y, float z)
{
    if (scene->ripples == scene->background) return scene->background;
    const float c = scene->noise_cells;
    const float coarse = smooth_noise(x * c, y * c, z * c),
                fine = smooth_noise(x * c * 2.7f, y * c * 2.7f, z * c * 2.7f);
    return mixed(scene->background, scene->ripples, 0.65f * coarse + 0.35f * fine);
}

/// The colour of an object at a place in tiles, as noise darkens and lightens it.
LOOKS_FUNCTION uint modulated(const struct ObjectScene* scene, uint color, float x, float y, float z)
{
    if (scene->modulation == 0) return color;
    const float c = scene->noise_cells * 0.61f; // so that its lattice and the background's do not coincide
    const float noise = smooth_noise(x * c + 0.31f, y * c + 0.17f, z * c + 0.43f);
    return mixed(color, noise < 0.5f ? 0 : 0xffffff,
                 scene->modulation * (noise < 0.5f ? 1 - 2 * noise : 2 * noise - 1));
}

END_CONTRACT
