// Pictures of objects that a distribution function places: a work-item a pixel.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.6. Each sample asks for the object at its place and
// for that object's colour; a pixel is the mean of its samples.
#include "runtime/poisson_tiles_gpu.h"

#include "runtime/object_distribution_gpu.h"

#include "kernels/common/fields/object_views.h"

/// A place in tiles: a whole tile and what is beyond its lowest corner.
struct TilePlace
{
    int3 tile;
    float3 f;
};

float fraction_of(long place) { return (float)((uint)place >> 8) / 16777216.0f; }

kernel void draw_objects(struct ObjectScene scene, struct ObjectTiles tiles, global const uint* words,
                         global const float* shapes, global uchar4* pixels, global uint* ids)
{
    const uint id = get_global_id(0);
    if (id >= scene.width * scene.height) return;
    const uint column = id % scene.width;
    const uint row = scene.height - 1 - id / scene.width;
    const struct ptiles_tiling t = {
        tiles.kind,   tiles.dimension, tiles.colors, tiles.tiles, tiles.points_per_tile, tiles.seed,
        tiles.period, tiles.low,       tiles.step,   tiles.below, tiles.above,           0};
    uint sums[4] = {0, 0, 0, 0};
    ids[id] = 0;
    for (uint sample = 0; sample < scene.samples * scene.samples; ++sample) {
        const uint i = column * scene.samples + sample % scene.samples;
        const uint j = row * scene.samples + sample / scene.samples;
        struct TilePlace place;
        float light = 1;
        float3 part = (float3)(((float)i + 0.5f) / (float)(scene.width * scene.samples),
                               ((float)j + 0.5f) / (float)(scene.height * scene.samples), 0.5f);
        if (scene.view == VIEW_PLANE) {
            const long x = scene.left + i * scene.step, y = scene.bottom + j * scene.step;
            place.tile = (int3)((int)(x >> 32), (int)(y >> 32), tiles.dimension == 3 ? (int)(scene.z >> 32) : 0);
            place.f = (float3)(fraction_of(x), fraction_of(y), tiles.dimension == 3 ? fraction_of(scene.z) : 0);
        } else {
            const float half_height = (float)(scene.height * scene.samples) / 2;
            const struct SurfacePlace seen =
                surface_place(scene.view, ((float)i + 0.5f - (float)(scene.width * scene.samples) / 2) / half_height,
                              ((float)j + 0.5f - half_height) / half_height);
            if (!seen.is_there) {
                sums[0] += 255, sums[1] += 255, sums[2] += 255;
                continue;
            }
            const float scale = scene.extent / 2;
            const float x = seen.x * scale, y = seen.y * scale, z = tiles.dimension == 3 ? seen.z * scale : 0;
            place.tile = (int3)((int)whole_part(x), (int)whole_part(y), (int)whole_part(z));
            place.f = (float3)(x - whole_part(x), y - whole_part(y), z - whole_part(z));
            part = (float3)(seen.x + 1, seen.y + 1, seen.z + 1) / 2;
            light = seen.light;
        }
        const struct pobjects_object object = pobjects_at(words, t, scene.radius, place.tile, place.f);
        if (sample == 0) ids[id] = object.id;
        const float3 there = (float3)((float)place.tile.x + place.f.x, (float)place.tile.y + place.f.y,
                                      (float)place.tile.z + place.f.z);
        const uint behind = background_color(&scene, there.x, there.y, there.z);
        const float3 at = part - object.offset / scene.extent;
        uint inside;
        uint color = object_color(&scene, shapes, object.id, object.offset.x, object.offset.y, object.offset.z,
                                  (struct ObjectCoordinates){at.x, at.y, at.z}, behind, &inside);
        if (color != behind) color = modulated(&scene, color, there.x, there.y, there.z);
        color = mixed(0, color, light);
        sums[0] += color >> 16 & 255;
        sums[1] += color >> 8 & 255;
        sums[2] += color & 255;
        sums[3] += inside;
    }
    const uint samples = scene.samples * scene.samples;
    pixels[id] = (uchar4)((uchar)((sums[0] + samples / 2) / samples), (uchar)((sums[1] + samples / 2) / samples),
                          (uchar)((sums[2] + samples / 2) / samples), (uchar)sums[3]);
}
