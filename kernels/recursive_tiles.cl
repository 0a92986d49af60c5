// Points of recursive Wang tiles: those that the tiles of a level have by their ranks, where the density asks for them.
//
// Kopf, Cohen-Or, Deussen and Lischinski, Recursive Wang tiles for real-time blue noise, 2006. The plain twin, which has
// the same points, is host/tile_sampling/recursive/recursive_points.cpp; host/tile_sampling/recursive/
// recursive_sampler.cpp shows the tiles level by level. Whole numbers decide; only coordinates are of double precision.

#pragma OPENCL FP_CONTRACT OFF

#include "kernels/common/tile_sampling/recursive_tiles.h"

/// The tile that has one of all ranks: the last one that begins there or before.
uint tile_with(struct RankedLevel level, global const struct RankedTile* tiles, uint rank)
{
    uint low = 0, high = level.tiles;
    while (high - low > 1) {
        const uint middle = low + (high - low) / 2;
        if (tiles[middle].begin <= rank)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/// Points per tile of the level that the density asks for where it has a weight: the host code's demand().
ulong demand_at(struct RankedLevel level, ulong weight)
{
    const ulong most = mul_hi(weight, level.most) << (64 - WEIGHT_BITS) | weight * level.most >> WEIGHT_BITS;
    return 4 * level.level < 64 ? most >> 4 * level.level : 0;
}

/// The weight of the pixel at a place of a tile of the next level. Places are parts of 2^32 of the torus.
ulong weight_at(struct RankedLevel level, global const ulong* weights, ulong2 cell, uint2 place)
{
    const ulong2 at = (cell << 32 | convert_ulong2(place)) / level.across;
    const ulong column = at.x * level.width >> 32, row = at.y * level.height >> 32;
    return weights[row * level.width + column];
}

/// One work-item finds the point of one rank of a tile: (-1, -1) where the density does without it. Links and children
/// by tile, places by tile and rank.
kernel void place_ranks(struct RankedLevel level, global const struct RankedTile* tiles, global const ushort* links,
                        global const uint* children, global const uint2* places, global const ulong* weights,
                        global double2* points)
{
    const uint item = get_global_id(0);
    if (item >= level.ranks) return;
    const struct RankedTile from = tiles[tile_with(level, tiles, item)];
    const uint rank = from.first + (item - from.begin);
    const uint link = links[from.tile * CELLS * level.points_per_tile + rank];
    const uint in_cell = link >> POINT_BITS, point = link & ((1u << POINT_BITS) - 1);
    const uint tile = children[from.tile * CELLS + in_cell];
    const ulong2 cell = (ulong2)(from.cell_x << 2 | (in_cell & 3u), from.cell_y << 2 | in_cell >> 2);
    const uint2 place = places[tile * level.points_per_tile + point];
    const ulong turn = ((ulong)rank << 32) + from.turn;
    if (!level.is_uniform && turn > demand_at(level, weight_at(level, weights, cell, place))) {
        points[item] = (double2)(-1);
        return;
    }
    points[item] = (convert_double2(cell) + convert_double2(place) * 0x1p-32) / (double)level.across;
}
