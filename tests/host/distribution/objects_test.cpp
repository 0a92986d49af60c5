// Pictures of objects: kernels/objects.cl against its plain twin, and shares that are known.
#include "host/distribution/objects.hpp"

#include "base/errors/errors.hpp"
#include "host/distribution/object_shapes.hpp"
#include "host/settings/distributions/distribution_config.hpp"
#include "kernels/common/fields/object_views.h"
#include "tests/support/errors.hpp"
#include "tests/support/exhibits.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>

namespace poissonlab {
namespace {

using namespace contract::objects;
using testing::HasSubstr;

/// Tiles with a proven minimum distance that ship: 64 points a tile in the plane, 128 in space.
const ObjectTileSet& shipped_tiles(int dimension)
{
    const auto read = [](const char* name) {
        return ObjectTileSet(read_tile_set(source_folder() + "/runtime/tile_sets/" + name));
    };
    static const ObjectTileSet plane = read("corner-c3-n64-r075.ptiles"), space = read("sphere-c2-n128-r075.ptiles");
    return dimension == 3 ? space : plane;
}

/// A picture of some tiles.
ObjectScene scene_of(const std::string& look, int dimension, std::uint32_t pixels, double tiles)
{
    ObjectScene scene{};
    scene.width = scene.height = pixels;
    scene.samples = 2;
    scene.step = static_cast<long>(tiles * 0x1p32 / (2 * pixels));
    scene.left = -5 * (std::int64_t{1} << 32) + 12345;
    scene.bottom = std::int64_t{70'000} << 32;
    scene.z = 1 << 30;
    scene.radius = static_cast<float>(shipped_tiles(dimension).radius());
    scene.extent = static_cast<float>(tiles);
    scene.size = {SPREAD_UNIFORM, 0.6f, 1};
    scene.turn = {SPREAD_NORMAL, 0.1f, 0.05f};
    scene.aspect = {SPREAD_CONSTANT, 1.2f, 0};
    set_look(scene, look, dimension);
    return scene;
}

class ObjectPictures : public testing::TestWithParam<int>
{
};

/// Identities and disks are equal; colours may differ by what rounding of their mixtures is on another compiler.
TEST_P(ObjectPictures, AreTheSameByKernelAndTwin)
{
    const int dimension = GetParam();
    for (const std::string& look : object_looks(dimension))
        for (const std::uint32_t view :
             {std::uint32_t{VIEW_PLANE}, std::uint32_t{VIEW_SPHERE}, std::uint32_t{VIEW_TORUS},
              std::uint32_t{VIEW_CLOTH}, std::uint32_t{VIEW_FLOOR}}) {
            if (view != VIEW_PLANE && (view >= VIEW_CLOTH) != (dimension == 2)) continue;
            ObjectScene scene = scene_of(look, dimension, 24, 1.3);
            scene.view = view;
            const PoissonTiling tiling{7, view == VIEW_SPHERE ? 2 : 0};
            const ObjectTileSet& tiles = shipped_tiles(dimension);
            const ObjectPicture drawn = ObjectPainter(Device::open(), tiles, object_shapes(), 7).draw(tiling, scene);
            const ObjectPicture expected = reference::draw_objects(tiles, tiling, scene, object_shapes());
            EXPECT_EQ(drawn.ids, expected.ids) << look;
            ASSERT_EQ(drawn.pixels.size(), expected.pixels.size());
            for (std::size_t i = 0; i < drawn.pixels.size(); ++i)
                ASSERT_LE(std::abs(drawn.pixels[i] - expected.pixels[i]), i % 4 == 3 ? 0 : 1)
                    << look << " " << view << " " << i;
        }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, ObjectPictures, testing::Values(2, 3));

/// Disks do not overlap: of a whole period they cover N pi R^2, in space, where planes cut them, 4/3 N pi R^3. A
/// lattice of 2,048 x 2,048 places in 4 x 4 tiles errs by less than 1e-4 of a disk's share; in space one layer of
/// places is not the mean of all, so that many layers are drawn.
TEST(Objects, CoverTheirDisks)
{
    for (const double size : {1.0, 0.5}) {
        ObjectScene scene = scene_of("dots", 2, 1024, 4);
        scene.left = scene.bottom = 0;
        scene.size = {SPREAD_CONSTANT, static_cast<float>(size), 0};
        const ObjectTileSet& tiles = shipped_tiles(2);
        const ObjectPicture picture = ObjectPainter(Device::open(), tiles, object_shapes()).draw({3, 4}, scene);
        double inside = 0;
        for (std::size_t i = 3; i < picture.pixels.size(); i += 4) inside += picture.pixels[i];
        const double expected = 64 * std::numbers::pi * std::pow(tiles.radius() * size, 2);
        EXPECT_NEAR(inside / 2048 / 2048, expected, 2e-4);
    }
    const ObjectTileSet& spheres = shipped_tiles(3);
    ObjectPainter painter(Device::open(), spheres, object_shapes());
    double inside = 0;
    constexpr int layers = 64;
    for (int layer = 0; layer < layers; ++layer) {
        ObjectScene scene = scene_of("dots", 3, 64, 1);
        scene.left = scene.bottom = scene.step / 2;
        scene.z = (std::int64_t{1} << 32) * layer / layers + (1 << 24);
        scene.size = {SPREAD_CONSTANT, 1, 0};
        for (std::size_t i = 3; const std::uint8_t count : painter.draw({3, 1}, scene).pixels)
            if (i++ % 4 == 2) inside += count;
    }
    EXPECT_NEAR(inside / (128.0 * 128 * layers), 128 * 4.0 / 3 * std::numbers::pi * std::pow(spheres.radius(), 3),
                2e-3);
}

/// A picture's identities are those of ptiles_nearest, where no two points are equally near as floats.
TEST(Objects, AreThoseOfTheNearestPoint)
{
    for (const int dimension : {2, 3}) {
        const ObjectScene scene = scene_of("dots", dimension, 64, 3);
        const ObjectTileSet& tiles = shipped_tiles(dimension);
        const ObjectPicture picture = ObjectPainter(Device::open(), tiles, object_shapes()).draw({9, 0}, scene);
        const ptiles_tiling tiling = runtime_tiling(tiles.tiles(), {9, 0});
        int differences = 0;
        for (std::uint32_t pixel = 0; pixel < 64 * 64; ++pixel) {
            const double at[3] = {static_cast<double>(scene.left + 2 * scene.step * (pixel % 64)) / 0x1p32,
                                  static_cast<double>(scene.bottom + 2 * scene.step * (63 - pixel / 64)) / 0x1p32,
                                  static_cast<double>(scene.z) / 0x1p32};
            ptiles_point nearest;
            ptiles_nearest(&tiling, at, &nearest);
            differences += nearest.id != picture.ids[pixel];
        }
        EXPECT_LE(differences, 2) << dimension;
    }
}

/// Places that are equal modulo the period have equal objects.
TEST(Objects, RepeatAfterThePeriod)
{
    ObjectScene scene = scene_of("stars", 2, 48, 2);
    ObjectPainter painter(Device::open(), shipped_tiles(2), object_shapes());
    scene.ripples = scene.background; // noise has no period
    const ObjectPicture here = painter.draw({5, 3}, scene);
    scene.left += 3 * (std::int64_t{1} << 32);
    scene.bottom -= 6 * (std::int64_t{1} << 32);
    const ObjectPicture there = painter.draw({5, 3}, scene);
    EXPECT_EQ(here.ids, there.ids);
    EXPECT_EQ(here.pixels, there.pixels);
}

/// The largest radii of superformulas: 2^((n/2 - 1)/n1) for even n above 2, in the directions between axes.
TEST(ObjectShapes, HaveTheirLargestRadius)
{
    const auto largest = [](double m, double n1, double n) {
        double radius = 0;
        for (int i = 0; i < 100'000; ++i)
            radius = std::max(radius, superformula(2 * std::numbers::pi * i / 100'000, m, n1, n));
        return radius;
    };
    EXPECT_NEAR(largest(3, 6.7, 12), 1.6774, 1e-4);
    EXPECT_NEAR(largest(4, 12, 12), 1.3348, 1e-4);
    EXPECT_NEAR(largest(5, 2, 7), 2.3784, 1e-4);
    EXPECT_NEAR(largest(5, 2, 13), 6.7272, 1e-4);
}

/// The table goes around in equal quotients; between its steps radii are linear.
TEST(ObjectShapes, AreFoundByDirection)
{
    const float* radii = object_shapes().radii.data();
    for (int i = 0; i < 1000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 1000;
        const auto x = static_cast<float>(std::cos(angle)), y = static_cast<float>(std::sin(angle));
        EXPECT_NEAR(shape_radius(radii, 0, x, y), 1, 1e-6);
        // Abstract squares, figure 7.12 g: m = 4, n1 = n2 = n3 = 8; the corners are at the distance 2^(3/8).
        const double square = std::pow(std::pow(std::cos(angle), 8) + std::pow(std::sin(angle), 8), -1.0 / 8);
        EXPECT_NEAR(shape_radius(radii, 5, x, y), square / std::pow(2, 3.0 / 8), 1e-3) << i;
    }
    for (std::uint32_t i = 0; i < object_shapes().size() * SHAPE_STEPS; ++i) {
        EXPECT_GE(radii[i], 0);
        EXPECT_LE(radii[i], 1.0001f);
    }
}

TEST(ObjectLooks, HaveCosines)
{
    for (int i = -2000; i < 2000; ++i)
        EXPECT_NEAR(turn_cosine(static_cast<float>(i) / 777), std::cos(2 * std::numbers::pi * i / 777), 3e-6);
}

/// The outputs of the function, figure 7.7, against the nearest points by ptiles_nearest.
TEST(ObjectLooks, OfOutputsShowWhatALookUpReturns)
{
    for (const int dimension : {2, 3}) {
        const ObjectTileSet& tiles = shipped_tiles(dimension);
        const ptiles_tiling tiling = runtime_tiling(tiles.tiles(), {9, 0});
        std::map<std::string, ObjectPicture> pictures;
        ObjectScene scene;
        for (const std::string name : {"inside", "coordinates", "number", "distance"}) {
            scene = scene_of(name, dimension, 64, 1.3);
            scene.samples = 1;
            scene.step *= 2;
            scene.size = {SPREAD_CONSTANT, 1, 0};
            pictures[name] = ObjectPainter(Device::open(), tiles, object_shapes()).draw({9, 0}, scene);
        }
        const double low[3] = {static_cast<double>(scene.left) / 0x1p32, static_cast<double>(scene.bottom) / 0x1p32,
                               static_cast<double>(scene.z) / 0x1p32};
        std::map<std::uint32_t, std::set<std::uint32_t>> colors;
        for (std::uint32_t pixel = 0; pixel < 64 * 64; ++pixel) {
            const double at[3] = {low[0] + 1.3 * (pixel % 64) / 64, low[1] + 1.3 * (63 - pixel / 64) / 64, low[2]};
            ptiles_point nearest;
            ptiles_nearest(&tiling, at, &nearest);
            double squared = 0;
            for (int a = 0; a < dimension; ++a) squared += std::pow(nearest.position[a] - at[a], 2);
            const auto color = [&](const char* name, int channel) {
                return static_cast<int>(pictures[name].pixels[4 * pixel + static_cast<std::uint32_t>(channel)]);
            };
            const double away = std::sqrt(squared) / tiles.radius();
            if (std::abs(away - 1) > 1e-3) {
                ASSERT_EQ(color("inside", 0), away < 1 ? 0 : 255) << pixel;
            }
            ASSERT_NEAR(color("distance", 1), std::min(1.0, away / 3) * 255, 1) << pixel;
            if (pictures["number"].ids[pixel] != nearest.id) continue; // two points are about equally near
            for (int a = 0; a < dimension; ++a) {
                const double part = (nearest.position[a] - low[a]) / 1.3 + (a < 2 ? 0.5 / 64 : 0.5);
                ASSERT_NEAR(color("coordinates", a), std::clamp(part, 0.0, 1.0) * 255, 1) << pixel << " " << a;
            }
            colors[nearest.id].insert(
                static_cast<std::uint32_t>(color("number", 0) << 16 | color("number", 1) << 8 | color("number", 2)));
        }
        std::set<std::uint32_t> all;
        for (const auto& [id, own] : colors) {
            EXPECT_EQ(own.size(), 1) << id;
            all.insert(own.begin(), own.end());
        }
        EXPECT_GE(all.size() + 1, colors.size()); // 24 bits for about a hundred
    }
}

/// Section 7.6.2.1: by the rule of the text, a look-up near a corner visits four tiles and one near an edge two. The
/// text has about 10, 40 and 50 % for a radius of 0.16; random places say 8.0, 45.7 and 46.2 %.
TEST(Objects, VisitTheTilesThatTheLargestEmptyCircleReaches)
{
    ObjectSettings settings;
    settings.tiles = source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles";
    settings.pixels = 16, settings.has_timing = true;
    DistributionPlace place;
    place.engine = Engine::reference;
    const TemporaryFolder folder;
    std::map<std::string, double> numbers;
    for (const DistributionNumber& number : made_of(settings, 1, folder.path(), place).numbers)
        numbers[number.key] = number.value;
    const double radius = numbers.at("largest_empty_radius");
    EXPECT_GT(radius, shipped_tiles(2).radius() * 2 * 0.7); // disks of the minimum distance nearly cover the plane
    EXPECT_LT(radius, shipped_tiles(2).radius() * 2 * 1.3);
    const ptiles_set set = shipped_tiles(2).distribution({}).tiling.set;
    const double out = std::max(set.below, set.above) / 65536.0; // points of this set leave their tiles
    EXPECT_GT(out, 0);
    std::mt19937_64 random(4);
    std::array<double, 3> counts{};
    constexpr int places = 400'000;
    for (int i = 0; i < places; ++i) {
        const double x = static_cast<double>(random() >> 11) * 0x1p-53,
                     y = static_cast<double>(random() >> 11) * 0x1p-53;
        const double u = std::max(std::min(x, 1 - x) - out, 0.0), v = std::max(std::min(y, 1 - y) - out, 0.0);
        ++counts[std::hypot(u, v) < radius ? 2 : std::min(u, v) < radius ? 1 : 0];
    }
    const char* const keys[] = {"one_tile", "two_tiles", "four_tiles"};
    for (std::size_t i = 0; i < 3; ++i) // five standard errors of a share
        EXPECT_NEAR(numbers.at(keys[i]), counts[i] / places, 5 * 0.5 / std::sqrt(places)) << keys[i];
}

TEST(Objects, NeedAMinimumDistance)
{
    PoissonTileSet tiles = random_tile_set(PoissonTileKind::corner, 2, 2, 8);
    tiles.squared_min_distance = 0;
    EXPECT_THAT(message_of([&] { ObjectTileSet{tiles}; }), HasSubstr("promise no minimum distance"));
}

}
}
