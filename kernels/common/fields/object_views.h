// The surfaces on which objects of a distribution are seen: bodies, which solid textures fill, and a table with its
// cloth. Kernel and plain twin share it; it comes after object_looks.h.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 7.14 to 7.16.
#pragma once

#include "kernels/common/fields/object_looks.h"

CONTRACT(objects)

/// A place of a body's surface and how much light it has; nothing where the ray misses it.
struct SurfacePlace
{
    float x, y, z; ///< from -1 to 1
    float light;
    uint is_there;
};

/// The distance from the surface of a torus of the radii 0.66 and 0.3, tilted towards the eye, which looks along -z.
LOOKS_FUNCTION float torus_distance(float x, float y, float z)
{
    const float up = 0.6f * y + 0.8f * z, along = 0.8f * y - 0.6f * z;
    const float ring = root_of(x * x + along * along) - 0.66f;
    return root_of(ring * ring + up * up) - 0.3f;
}

/// The table of figure 7.14 in metres, z upwards, and its eye, which looks at (0, 0, AIM_HEIGHT).
#define TABLE_HEIGHT 0.75f
#define TABLE_RADIUS 0.6f
#define CLOTH_DROP 0.58f  ///< from the edge of the table down to the hem
#define CLOTH_REACH 0.85f ///< farther from the axis no fold goes
#define EYE_AWAY 2.6f
#define EYE_HEIGHT 1.75f
#define AIM_HEIGHT 0.36f
#define VIEW_SLOPE 0.42f ///< of half the picture's height

/// The distance from the axis of the hanging cloth in the direction of (x, y), `drop` below the table: twelve folds,
/// which become deeper so that a circle of the cloth keeps about its length. The folds are Chebyshev's polynomial of
/// the cosine of the direction.
LOOKS_FUNCTION float cloth_radius(float x, float y, float drop)
{
    const float along = root_of(x * x + y * y);
    const float c = along > 0 ? x / along : 1, c3 = c * (4 * c * c - 3), c6 = 2 * c3 * c3 - 1, c12 = 2 * c6 * c6 - 1;
    return TABLE_RADIUS + drop * (0.16f + 0.19f * c12);
}

/// The way from the hanging cloth outwards to a place; negative inside.
LOOKS_FUNCTION float beyond_cloth(float x, float y, float z)
{
    return root_of(x * x + y * y) - cloth_radius(x, y, TABLE_HEIGHT - z);
}

/// The part of a ray from (x, y, z) on at which it meets the cloth, or -1: the top, or else the first change of side
/// among even steps where the cloth hangs, halved until it is a point.
LOOKS_FUNCTION float cloth_hit(float x, float y, float z, float dx, float dy, float dz)
{
    const float top = dz < 0 ? (TABLE_HEIGHT - z) / dz : -1;
    const float tx = x + top * dx, ty = y + top * dy;
    if (top > 0 && tx * tx + ty * ty <= TABLE_RADIUS * TABLE_RADIUS) return top;
    const float beside =
        (x * dy - y * dx) * (x * dy - y * dx); // the squared distance from the axis, times that of (dx, dy)
    if (beside > CLOTH_REACH * CLOTH_REACH * (dx * dx + dy * dy)) return -1;
    // The ray between the heights of the table and of the hem, where the cloth can be; no ray of these views is level.
    const float nearest = -(x * dx + y * dy) / (dx * dx + dy * dy + dz * dz);
    const float at_table = (TABLE_HEIGHT - z) / dz, at_hem = (TABLE_HEIGHT - CLOTH_DROP - z) / dz;
    const float from = within(nearest - 1.3f, dz < 0 ? at_table : at_hem, dz < 0 ? at_hem : at_table);
    const float until = within(nearest + 1.3f, from, dz < 0 ? at_hem : at_table);
    float last = beyond_cloth(x + from * dx, y + from * dy, z + from * dz);
    for (int i = 1; i <= 200; ++i) {
        const float t = from + (until - from) * (float)i / 200;
        const float here = beyond_cloth(x + t * dx, y + t * dy, z + t * dz);
        if ((last > 0 && here < 0) || (last < 0 && here > 0)) {
            float low = t - (until - from) / 200, high = t;
            for (int halving = 0; halving < 12; ++halving) {
                const float middle = (low + high) / 2;
                const float side = beyond_cloth(x + middle * dx, y + middle * dy, z + middle * dz);
                if ((side > 0) == (last > 0))
                    low = middle;
                else
                    high = middle;
            }
            return high;
        }
        last = here;
    }
    return -1;
}

/// The light of a surface with this normal, which is turned towards the eye's ray.
LOOKS_FUNCTION float table_light(float nx, float ny, float nz, float dx, float dy, float dz)
{
    const float length = root_of(nx * nx + ny * ny + nz * nz) * (nx * dx + ny * dy + nz * dz > 0 ? -1 : 1);
    const float facing = (-0.48f * nx - 0.36f * ny + 0.8f * nz) / length;
    return 0.4f + 0.6f * (facing > 0 ? facing : 0);
}

/// The place of the cloth, unrolled, or of the floor that is seen at (x, y): metres from the axis.
LOOKS_FUNCTION struct SurfacePlace table_place(uint view, float x, float y)
{
    struct SurfacePlace place = {0, 0, 0, 1, 0};
    const float fall = (EYE_HEIGHT - AIM_HEIGHT) / EYE_AWAY, flat = 1 / root_of(1 + fall * fall);
    // The eye looks along +y and down; its ray is the way ahead, and VIEW_SLOPE to the right and up.
    const float right = x * VIEW_SLOPE, up = y * VIEW_SLOPE;
    const float dx = right, dy = flat + up * fall * flat, dz = -fall * flat + up * flat;
    const float t = cloth_hit(0, -EYE_AWAY, EYE_HEIGHT, dx, dy, dz);
    if (view == VIEW_CLOTH && t > 0) {
        const float px = t * dx, py = t * dy - EYE_AWAY, pz = EYE_HEIGHT + t * dz;
        const float away = root_of(px * px + py * py);
        place.is_there = 1;
        if (away <= TABLE_RADIUS && pz > TABLE_HEIGHT - 1e-4f) {
            place.x = px, place.y = py, place.light = table_light(0, 0, 1, dx, dy, dz);
            return place;
        }
        const float drop = TABLE_HEIGHT - pz, unrolled = (TABLE_RADIUS + drop) / away, d = 0.002f;
        const float here = beyond_cloth(px, py, pz);
        place.x = px * unrolled, place.y = py * unrolled;
        place.light = table_light(beyond_cloth(px + d, py, pz) - here, beyond_cloth(px, py + d, pz) - here,
                                  beyond_cloth(px, py, pz + d) - here, dx, dy, dz);
    }
    if (view == VIEW_FLOOR && t <= 0 && dz < 0) {
        const float s = -EYE_HEIGHT / dz;
        place.x = s * dx, place.y = s * dy - EYE_AWAY, place.is_there = 1;
        const float tx = place.x - 0.6f * TABLE_HEIGHT, ty = place.y - 0.45f * TABLE_HEIGHT; // towards the light
        const uint is_dark =
            tx * tx + ty * ty < TABLE_RADIUS * TABLE_RADIUS || cloth_hit(place.x, place.y, 0, -0.48f, -0.36f, 0.8f) > 0;
        place.light = is_dark ? 0.4f : 0.88f;
    }
    return place;
}

/// The place of a view's body that is seen at (x, y), -1 to 1 over the picture's height.
LOOKS_FUNCTION struct SurfacePlace surface_place(uint view, float x, float y)
{
    struct SurfacePlace place = {x, y, 0, 1, 0};
    float nx, ny, nz;
    if (view == VIEW_CLOTH || view == VIEW_FLOOR) return table_place(view, x, y);
    if (view == VIEW_SPHERE) {
        const float left = 0.96f - x * x - y * y;
        if (left < 0) return place;
        nx = x, ny = y, nz = place.z = root_of(left);
    } else {
        place.z = 1.1f;
        float away = 1;
        for (int i = 0; i < 80 && away > 0.0005f && place.z > -1.1f; ++i) {
            away = torus_distance(x, y, place.z);
            place.z -= away;
        }
        if (place.z <= -1.1f) return place;
        const float d = 0.002f, here = torus_distance(x, y, place.z);
        nx = torus_distance(x + d, y, place.z) - here;
        ny = torus_distance(x, y + d, place.z) - here;
        nz = torus_distance(x, y, place.z + d) - here;
    }
    const float length = root_of(nx * nx + ny * ny + nz * nz);
    const float facing = (-0.4f * nx + 0.6f * ny + 0.69f * nz) / (length > 0 ? length : 1);
    place.light = 0.25f + 0.75f * (facing > 0 ? facing : 0), place.is_there = 1;
    return place;
}

END_CONTRACT
