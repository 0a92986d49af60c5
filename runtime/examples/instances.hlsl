// SPDX-License-Identifier: MIT-0
//
// Unity, Unreal, Direct3D: a compute shader that places instances, such as grass, on the tiles around a camera. Run it
// with (points_per_tile + 63) / 64 groups along x, and as many along y and z as there are tiles along the axes.
#define PTILES_HLSL
StructuredBuffer<uint> ptiles_words : register(t0); // the bytes of a tile set file from 128 on
#include "poisson_tiles_gpu.h"

cbuffer Meadow : register(b0)
{
    ptiles_tiling tiling; // the numbers of the file's header, a seed and a period
    int2 first_tile;      // the lowest one
    float tile_side;      // in the world's units
    float density;        // from 0 to 1
};

struct Instance
{
    float2 position; // from the lowest corner of the first tile: add that on the processor, in double precision
    float angle;
    float size;
};
AppendStructuredBuffer<Instance> instances : register(u0);

[numthreads(64, 1, 1)] void place_points(uint3 at : SV_DispatchThreadID)
{
    if (at.x >= tiling.points_per_tile) return;
    int3 place = int3(first_tile + int2(at.yz), 0);
    uint tile = ptiles_tile(tiling, place);
    uint id = ptiles_mix(ptiles_hash(tiling.seed, ptiles_place(place.x, tiling.period), ptiles_place(place.y, tiling.period), 0u) + 1u + at.x);
    if (ptiles_level(tiling, tile, at.x, id) >= density) return;
    Instance instance;
    instance.position = (float2(at.yz) + ptiles_point(tiling, tile, at.x).xy) * tile_side;
    instance.angle = 6.2831853f * float(id & 0xffffu) / 65536.0f;
    instance.size = 0.8f + 0.4f * float(id >> 16) / 65536.0f;
    instances.Append(instance);
}
