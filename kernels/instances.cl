// Instances of models at the points of a tiling: a work-item a point.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.5. All that an instance is follows from its point's
// place and random bits, by sums, products and quotients of doubles that all devices round alike: bit for bit what the
// plain twin makes, host/distribution/reference/instances.cpp.

#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#include "runtime/poisson_tiles_gpu.h"

#include "runtime/object_distribution_gpu.h"

#include "kernels/common/fields/instances.h"
#include "kernels/common/fields/object_looks.h"

double instance_scale(const struct InstanceScene* scene, uint id)
{
    double scale = scene->scale_a;
    // Both numbers are exact as floats.
    if (scene->scale_kind == SCALE_UNIFORM)
        scale += (scene->scale_b - scene->scale_a) * (double)pobjects_uniform(id, PURPOSE_SCALE);
    if (scene->scale_kind == SCALE_NORMAL) scale += scene->scale_b * (double)pobjects_normal(id, PURPOSE_SCALE);
    return scale < LEAST_SCALE ? LEAST_SCALE : scale > 1 ? 1 : scale;
}

uint is_in_scene(const struct InstanceScene* scene, uint dimension, const double* position)
{
    const double x = position[0], y = position[1], z = position[2];
    if (x < scene->left || x >= scene->left + scene->width) return 0;
    if (y < scene->bottom || y >= scene->bottom + scene->height) return 0;
    if (dimension == 2) return 1;
    const double squared = x * x + y * y, half_thickness = scene->thickness / 2;
    return squared >= scene->inner * scene->inner && squared < scene->outer * scene->outer && z >= -half_thickness &&
           z < half_thickness;
}

kernel void place_instances(struct InstanceScene scene, struct ObjectTiles tiles, struct InstanceTiles block,
                            global const uint* words, global struct PlacedInstance* instances)
{
    const uint item = get_global_id(0);
    if (item >= block.tiles * tiles.points_per_tile) return;
    const struct ptiles_tiling t = {
        tiles.kind,   tiles.dimension, tiles.colors, tiles.tiles, tiles.points_per_tile, tiles.seed,
        tiles.period, tiles.low,       tiles.step,   tiles.below, tiles.above,           0};
    const ulong number = block.begin + item / tiles.points_per_tile;
    const ulong row = number / block.columns;
    const int3 at = (int3)(block.west + (int)(number % block.columns), block.south + (int)(row % block.rows),
                           block.below + (int)(row / block.rows));
    const uint index = item % tiles.points_per_tile;
    const float3 in_tile = ptiles_point(words, t, ptiles_tile(t, at), index);

    struct PlacedInstance instance;
    instance.position[0] = (at.x + (double)in_tile.x) / scene.unit;
    instance.position[1] = (at.y + (double)in_tile.y) / scene.unit;
    instance.position[2] = (at.z + (double)in_tile.z) / scene.unit;
    instance.tile[0] = at.x;
    instance.tile[1] = at.y;
    instance.tile[2] = at.z;
    instance.index = index;
    const uint id = ptiles_mix(
        ptiles_hash(t.seed, ptiles_place(at.x, t.period), ptiles_place(at.y, t.period), ptiles_place(at.z, t.period)) +
        1 + index);
    instance.id = id;
    instance.model = (uint)((ulong)pobjects_bits(id, PURPOSE_MODEL) * scene.models >> 32);
    instance.turn = WHOLE_TURN * (double)pobjects_uniform(id, PURPOSE_INSTANCE_TURN);
    instance.scale = instance_scale(&scene, id);
    instance.tilt = scene.tilt * (double)pobjects_uniform(id, PURPOSE_TILT);
    instance.tilt_direction = WHOLE_TURN * (double)pobjects_uniform(id, PURPOSE_TILT_DIRECTION);
    instance.is_inside = is_in_scene(&scene, tiles.dimension, instance.position);
    instance.unused = 0;
    instances[item] = instance;
}
