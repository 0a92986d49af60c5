// The contract of texture_map.cl and its host code, host/texture/mapping/texture_map.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(texture_map)

enum
{
    FILTER_NEAREST = 0,     ///< one texel of level 0
    FILTER_BILINEAR = 1,    ///< four texels of level 0
    FILTER_MIPMAP = 2,      ///< eight texels of the two levels that fit the longer side of a pixel's footprint
    FILTER_ANISOTROPIC = 3, ///< such look-ups side by side along it, at levels that fit the shorter side
    LOOKUP_PACKED = 0,      ///< neighbours in the atlas, as graphics cards read them
    LOOKUP_EXACT = 1,       ///< each texel through its own tile
    LOOKUP_CLAMPED = 2,     ///< the tile's own nearest texel instead of its neighbours
    LOOKUP_REPEATED = 3,    ///< no tiling: the atlas itself, side by side
    MAX_LEVELS = 10,        ///< of tiles up to 512 x 512
    WHOLE_LEVELS = 2,       ///< beyond those of a tile, of 2 x 2 and 4 x 4 tiles; then comes the mean of all
    MAX_PROBES = 16         ///< of an anisotropic look-up
};

/// The divisor is more than this where the plane is seen, and places are nearer than so many tiles.
REAL(HORIZON, 0x1p-24)
REAL(FARTHEST, 0x1p30)

/// The light where the plane is not seen; white is 65535.
REAL(SKY_LIGHT, 39321)

/// A view of the plane: places, in tiles, are quotients of affine functions of a sample's column and row. Each function
/// is its value at the upper left corner, then its steps to the next column and row.
struct TextureView
{
    double u[3], v[3];   ///< east and north
    double w[3];         ///< what both are divided by; at most 0 above the horizon
    uint tile_x, tile_y; ///< of the place 0, modulo 2^32
    int width, height;   ///< pixels
    int samples;         ///< of a pixel, along each axis
    int filter;
};

/// The atlas at all levels: rows from south to north, levels one after the other.
struct TextureLevels
{
    uint seed;
    int colors;
    int size;                     ///< of a tile, in texels of level 0: a power of two
    int top;                      ///< the level at which a tile is one texel
    uint offsets[MAX_LEVELS + 1]; ///< where levels begin; after the last one there is the mean of all
};

END_CONTRACT
