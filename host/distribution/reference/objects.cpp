// The plain C++ twin of kernels/objects.cl: a loop over pixels and samples, and of each all points of all tiles around.
#include "host/distribution/objects.hpp"

#include "kernels/common/fields/object_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace poissonlab::reference {
namespace {

using namespace contract::objects;

struct FoundObject
{
    std::array<float, 3> offset{};
    std::uint32_t id = 0;
};

struct SamplePlace
{
    std::array<std::int32_t, 3> tile{};
    std::array<float, 3> f{};
    std::array<float, 3> part{}; ///< of the picture
    float light = 1;
    bool is_there = true;
};

/// Calls visit(offset) for the tiles around, by rings, and in these by layers and rows.
template <class Visit>
void for_each_tile_around(int rings, bool in_space, const Visit& visit)
{
    for (int ring = 0; ring <= rings; ++ring)
        for (int k = in_space ? -ring : 0; k <= (in_space ? ring : 0); ++k)
            for (int j = -ring; j <= ring; ++j)
                for (int i = -ring; i <= ring; ++i)
                    if (std::max({std::abs(i), std::abs(j), std::abs(k)}) == ring) visit(std::array{i, j, k});
}

FoundObject nearest_object(const ptiles_tiling& t, const SamplePlace& place)
{
    const bool in_space = t.set.dimension == 3;
    float least = std::numeric_limits<float>::infinity();
    FoundObject found;
    for_each_tile_around(t.set.below + t.set.above > 0 ? 2 : 1, in_space, [&](const std::array<int, 3>& offset) {
        std::array<std::int32_t, 3> tile{};
        for (std::size_t a = 0; a < 3; ++a) tile[a] = place.tile[a] + offset[a];
        const std::uint16_t* numbers = ptiles_points(&t.set, ptiles_tile(&t, tile[0], tile[1], tile[2]));
        for (std::uint32_t n = 0; n < t.set.points_per_tile; ++n, numbers += t.set.dimension) {
            std::array<float, 3> away{};
            float sum = 0;
            for (std::size_t a = 0; a < t.set.dimension; ++a) {
                const float coordinate = static_cast<float>(t.set.low + t.set.step * numbers[a]) / 65536.0f;
                away[a] = coordinate + static_cast<float>(offset[a]) - place.f[a];
                sum += away[a] * away[a];
            }
            if (sum >= least) continue;
            least = sum;
            for (std::size_t a = 0; a < 3; ++a) found.offset[a] = -away[a];
            found.id = ptiles_point_at(&t, tile.data(), n, numbers).id;
        }
    });
    return found;
}

float fraction_of_place(std::int64_t place)
{
    return static_cast<float>(static_cast<std::uint32_t>(place) >> 8) / 16777216.0f;
}

SamplePlace plane_place(const ObjectScene& scene, std::uint32_t i, std::uint32_t j, bool in_space)
{
    const std::array<std::int64_t, 3> at{scene.left + i * scene.step, scene.bottom + j * scene.step,
                                         in_space ? scene.z : 0};
    SamplePlace place;
    place.part = {(static_cast<float>(i) + 0.5f) / static_cast<float>(scene.width * scene.samples),
                  (static_cast<float>(j) + 0.5f) / static_cast<float>(scene.height * scene.samples), 0.5f};
    for (std::size_t a = 0; a < 3; ++a) {
        place.tile[a] = static_cast<std::int32_t>(at[a] >> 32);
        place.f[a] = fraction_of_place(at[a]);
    }
    return place;
}

SamplePlace body_place(const ObjectScene& scene, std::uint32_t i, std::uint32_t j, bool in_space)
{
    const float half_height = static_cast<float>(scene.height * scene.samples) / 2;
    const SurfacePlace seen = surface_place(
        scene.view, (static_cast<float>(i) + 0.5f - static_cast<float>(scene.width * scene.samples) / 2) / half_height,
        (static_cast<float>(j) + 0.5f - half_height) / half_height);
    SamplePlace place;
    place.is_there = seen.is_there != 0;
    place.light = seen.light;
    place.part = {(seen.x + 1) / 2, (seen.y + 1) / 2, (seen.z + 1) / 2};
    const float scale = scene.extent / 2;
    const std::array<float, 3> at{seen.x * scale, seen.y * scale, in_space ? seen.z * scale : 0};
    for (std::size_t a = 0; a < 3; ++a) {
        place.tile[a] = static_cast<std::int32_t>(whole_part(at[a]));
        place.f[a] = at[a] - whole_part(at[a]);
    }
    return place;
}

}

ObjectPicture draw_objects(const ObjectTileSet& tiles, const PoissonTiling& tiling, const ObjectScene& scene,
                           const ObjectShapes& shapes)
{
    const ptiles_tiling t = runtime_tiling(tiles.tiles(), tiling);
    const bool in_space = t.set.dimension == 3;
    const std::size_t count = std::size_t{scene.width} * scene.height;
    ObjectPicture picture{std::vector<std::uint8_t>(4 * count), std::vector<std::uint32_t>(count)};
    const std::uint32_t samples = scene.samples * scene.samples;
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        const auto column = static_cast<std::uint32_t>(pixel % scene.width);
        const auto row = static_cast<std::uint32_t>(scene.height - 1 - pixel / scene.width);
        std::array<std::uint32_t, 4> sums{};
        for (std::uint32_t sample = 0; sample < samples; ++sample) {
            const std::uint32_t i = column * scene.samples + sample % scene.samples;
            const std::uint32_t j = row * scene.samples + sample / scene.samples;
            const SamplePlace place =
                scene.view == VIEW_PLANE ? plane_place(scene, i, j, in_space) : body_place(scene, i, j, in_space);
            std::uint32_t color = 0xffffff, inside = 0;
            if (place.is_there) {
                const FoundObject object = nearest_object(t, place);
                if (sample == 0) picture.ids[pixel] = object.id;
                std::array<float, 3> at{};
                for (std::size_t a = 0; a < 3; ++a) at[a] = static_cast<float>(place.tile[a]) + place.f[a];
                const ObjectCoordinates point{place.part[0] - object.offset[0] / scene.extent,
                                              place.part[1] - object.offset[1] / scene.extent,
                                              place.part[2] - object.offset[2] / scene.extent};
                const std::uint32_t behind = background_color(&scene, at[0], at[1], at[2]);
                color = object_color(&scene, shapes.radii.data(), object.id, object.offset[0], object.offset[1],
                                     object.offset[2], point, behind, &inside);
                if (color != behind) color = modulated(&scene, color, at[0], at[1], at[2]);
                color = mixed(0, color, place.light);
            }
            for (std::size_t c = 0; c < 3; ++c) sums[c] += color >> (16 - 8 * c) & 255;
            sums[3] += inside;
        }
        for (std::size_t c = 0; c < 3; ++c)
            picture.pixels[4 * pixel + c] = static_cast<std::uint8_t>((sums[c] + samples / 2) / samples);
        picture.pixels[4 * pixel + 3] = static_cast<std::uint8_t>(sums[3]);
    }
    return picture;
}

}
