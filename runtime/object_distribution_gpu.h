// SPDX-License-Identifier: MIT-0
//
// Objects without end that do not overlap, on GPUs: object_distribution.h as OpenCL C 1.2 and as GLSL 4.3. Include
// poisson_tiles_gpu.h before.
//
// The buffer of words holds what pobjects_sort() of object_distribution.h writes, two numbers a word, instead of the
// points of the file; no other function of poisson_tiles_gpu.h but ptiles_tile reads it then.
//     struct pobjects_object o = pobjects_at(words, t, radius, tile, f);
#ifndef OBJECT_DISTRIBUTION_GPU_H
#define OBJECT_DISTRIBUTION_GPU_H

struct pobjects_object
{
    ptiles_float3 offset; ///< of the place from the object's point, in tiles
    float squared;        ///< distance, in tiles
    ptiles_int3 tile;     ///< the place of the point's tile
    uint index;           ///< in its tile
    uint id;              ///< random bits that stay with the object
};

/// These constants say where the numbers of a tile begin, and how many belong to a point.
PTILES_FUNCTION uint pobjects_first(PTILES_STRUCT(ptiles_tiling) t, uint tile)
{
    return tile * (t.points_per_tile * (t.dimension + 1u) + 32u);
}

/// Sorted point i of the tile whose numbers begin at `first`, from that tile's lowest corner. In 2D z is 0.
PTILES_FUNCTION ptiles_float3 pobjects_point(PTILES_BUFFER PTILES_STRUCT(ptiles_tiling) t, uint first, uint i)
{
    uint n = first + i * (t.dimension + 1u);
    ptiles_float3 p;
    p.x = ptiles_coordinate(PTILES_WORDS t, n);
    p.y = ptiles_coordinate(PTILES_WORDS t, n + 1u);
    p.z = t.dimension == 3u ? ptiles_coordinate(PTILES_WORDS t, n + 2u) : 0.0f;
    return p;
}

/// The object at a position in the tile at `home`, which is `f` from that tile's lowest corner; 0 <= f < 1, in 2D
/// f.z = 0. Where two points are equally near, it is the one that ptiles_nearest_point finds: of the tile that is
/// visited first, and there of the lower index.
PTILES_FUNCTION PTILES_STRUCT(pobjects_object)
    pobjects_at(PTILES_BUFFER PTILES_STRUCT(ptiles_tiling) t, float radius, ptiles_int3 home, ptiles_float3 f)
{
    bool is_3d = t.dimension == 3u;
    float border = min(min(f.x, 1.0f - f.x), min(f.y, 1.0f - f.y));
    if (is_3d) border = min(border, min(f.z, 1.0f - f.z));
    PTILES_STRUCT(pobjects_object) best;
    best.squared = 1e30f;
    best.tile = home;
    best.index = 0u;
    float below = PTILES_FLOAT(t.below) / 65536.0f;
    float above = PTILES_FLOAT(t.above) / 65536.0f;
    float enough = radius * radius * 0.99999f; // nothing else can be nearer
    for (int ring = 0; ring == 0 || best.squared >= enough; ++ring) {
        float away = border + PTILES_FLOAT(ring - 1) - max(below, above);
        if (ring > 0 && away > 0.0f && away * away >= best.squared) break;
        int layers = is_3d ? ring : 0;
        for (int k = -layers; k <= layers; ++k) {
            for (int j = -ring; j <= ring; ++j) {
                bool outer = ring == 0 || j == -ring || j == ring || (is_3d && (k == -ring || k == ring));
                for (int i = -ring; i <= ring; i += outer ? 1 : 2 * ring) {
                    float gap = ptiles_gap(f.x, i, below, above) + ptiles_gap(f.y, j, below, above) +
                                ptiles_gap(f.z, k, below, above);
                    if (gap >= best.squared || best.squared < enough) continue;
                    ptiles_int3 place = home + PTILES_INT3(i, j, k);
                    uint first = pobjects_first(t, ptiles_tile(t, place));
                    uint wide = t.dimension + 1u;
                    // The place as a number along x says where to begin.
                    float at = ((f.x - PTILES_FLOAT(i)) * 65536.0f - PTILES_FLOAT(t.low)) / PTILES_FLOAT(t.step);
                    uint part = PTILES_UINT(clamp(at, 0.0f, 65535.0f)) / 2048u;
                    uint middle = ptiles_number(PTILES_WORDS first + t.points_per_tile * wide + part);
                    bool is_first_tile_point = true;
                    float before = best.squared; // ties with other tiles are theirs
                    for (int way = 0; way < 2; ++way) {
                        for (uint n = middle; n < t.points_per_tile + 1u; n += way == 0 ? 1u : 0xffffffffu) {
                            uint s = way == 0 ? n : n - 1u;
                            if (s >= t.points_per_tile) break;
                            ptiles_float3 p = pobjects_point(PTILES_WORDS t, first, s);
                            PTILES_PRECISE float x = p.x + PTILES_FLOAT(i) - f.x;
                            float out_of_reach = way == 0 ? x : -x;
                            if (out_of_reach > 0.0f && x * x > best.squared) break;
                            PTILES_PRECISE float y = p.y + PTILES_FLOAT(j) - f.y;
                            PTILES_PRECISE float z = p.z + PTILES_FLOAT(k) - f.z;
                            PTILES_PRECISE float sum = x * x + y * y + z * z;
                            if (sum > best.squared || sum >= before) continue;
                            uint index = ptiles_number(PTILES_WORDS first + s * wide + t.dimension);
                            if (sum == best.squared && !is_first_tile_point && index > best.index) continue;
                            is_first_tile_point = false;
                            best.squared = sum;
                            best.tile = place;
                            best.index = index;
                            best.offset.x = -x;
                            best.offset.y = -y;
                            best.offset.z = -z;
                        }
                    }
                }
            }
        }
    }
    best.id = ptiles_mix(ptiles_hash(t.seed, ptiles_place(best.tile.x, t.period), ptiles_place(best.tile.y, t.period),
                                     ptiles_place(best.tile.z, t.period)) +
                         1u + best.index);
    return best;
}

/// 32 random bits of an object for a purpose, any number.
PTILES_FUNCTION uint pobjects_bits(uint id, uint purpose) { return ptiles_mix(ptiles_mix(id ^ 0x9e3779b9u) + purpose); }

/// A number from 0 to 1, 1 excluded.
PTILES_FUNCTION float pobjects_uniform(uint id, uint purpose)
{
    return PTILES_FLOAT(pobjects_bits(id, purpose) >> 8) / 16777216.0f;
}

/// A number with mean 0 and standard deviation 1, about normal: a sum of 12 uniform ones. Takes six purposes.
PTILES_FUNCTION float pobjects_normal(uint id, uint purpose)
{
    int sum = -6 * 65535;
    for (uint i = 0u; i < 6u; ++i) {
        uint bits = pobjects_bits(id, purpose + i);
        sum += PTILES_INT(bits >> 16) + PTILES_INT(bits & 0xffffu);
    }
    return PTILES_FLOAT(sum) / 65536.0f;
}

/// The place in an object's own coordinates: see pobjects_local in object_distribution.h. w is 1 where the place may be
/// in the object, else 0.
PTILES_FUNCTION ptiles_float3 pobjects_local(ptiles_float3 offset, float disk, float cosine, float sine, float aspect)
{
    ptiles_float3 u;
    u.x = (cosine * offset.x + sine * offset.y) / disk;
    u.y = (cosine * offset.y - sine * offset.x) / disk;
    bool inside = offset.x * offset.x + offset.y * offset.y < disk * disk;
    if (aspect >= 1.0f)
        u.y *= aspect;
    else
        u.x /= aspect;
    u.z = inside && u.x * u.x + u.y * u.y < 1.0f ? 1.0f : 0.0f;
    return u;
}

#endif
