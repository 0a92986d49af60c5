// Instances by window: parts and the whole are the same, and numbers are those of their distributions.
#include "host/distribution/instances/instance_files.hpp"
#include "host/distribution/instances/instance_view.hpp"
#include "host/distribution/instances/instances.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

const ObjectTileSet& plane_instance_tiles()
{
    static const ObjectTileSet tiles(read_tile_set(source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles"));
    return tiles;
}

const ObjectTileSet& space_instance_tiles()
{
    static const ObjectTileSet tiles(read_tile_set(source_folder() + "/runtime/tile_sets/sphere-c2-n128-r075.ptiles"));
    return tiles;
}

InstanceSettings some_trees(const std::array<double, 4>& window)
{
    InstanceSettings settings;
    settings.density = 50;
    settings.models = 5;
    settings.scale = {SpreadChoice::Kind::uniform, 0.5, 1};
    settings.tilt = 0.2;
    settings.window = window;
    settings.terrain = "x*y";
    settings.terrain_area = {-1, -2, 3, 2};
    return settings;
}

InstanceSettings a_belt()
{
    InstanceSettings settings;
    settings.scene = "asteroids";
    settings.density = 20'000;
    settings.window = {-1, -1, 2, 2};
    settings.ring = {0.5, 0.9, 0.1};
    return settings;
}

/// By the plain twin.
std::vector<Instance> made(const ObjectTileSet& tiles, const InstanceSettings& settings)
{
    return instances_in(tiles, {7, 0}, settings, {Engine::reference, {}});
}

std::vector<Instance> in_order(std::vector<Instance> instances)
{
    std::ranges::sort(instances, {}, [](const Instance& i) { return std::tuple(i.tile, i.index); });
    return instances;
}

struct PlacedCase
{
    const char* name;
    const ObjectTileSet& (*tiles)();
    InstanceSettings settings;
    PoissonTiling tiling;
    std::size_t work_group_size = 0;
};

/// Tiles whose points lie up to half a tile outside of their squares.
const ObjectTileSet& overhanging_tiles()
{
    static const ObjectTileSet tiles = [] {
        PoissonTileSet set = random_chain_set(3, 6);
        set.squared_min_distance = 1;
        return ObjectTileSet(std::move(set));
    }();
    return tiles;
}

/// Trees with normal scales, some of which are cut off at both ends.
InstanceSettings normal_trees()
{
    InstanceSettings settings = some_trees({-0.3, -70, 0.7, 0.4});
    settings.terrain.clear();
    settings.scale = {SpreadChoice::Kind::normal, 0.5, 0.4};
    return settings;
}

InstanceSettings part_of_a_belt()
{
    InstanceSettings settings = a_belt();
    settings.window = {0, -1, 0.8, 1.5};
    settings.models = 65'536;
    return settings;
}

class PlacedInstances : public testing::TestWithParam<PlacedCase>
{
};

TEST_P(PlacedInstances, AreTheSameByKernelAndTwin)
{
    const auto& [name, tiles, settings, tiling, work_group_size] = GetParam();
    const auto placed = InstancePlacer(Device::open(), tiles(), work_group_size).place(tiling, settings);
    EXPECT_FALSE(placed.empty());
    EXPECT_EQ(placed, reference::place_instances(tiles(), tiling, settings));
}

const auto name_of_case = [](const auto& info) { return std::string(info.param.name); };

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(
    Small, PlacedInstances,
    testing::Values(PlacedCase{"trees", plane_instance_tiles, some_trees({-0.5, -0.25, 1, 0.5}), {7, 0}},
                    PlacedCase{"normal", plane_instance_tiles, normal_trees(), {8, 5}, 3},
                    PlacedCase{"overhang", overhanging_tiles, normal_trees(), {9, 0}, 64}),
    name_of_case);
// More than are placed at a time.
INSTANTIATE_TEST_SUITE_P(
    Large, PlacedInstances,
    testing::Values(PlacedCase{"forest", plane_instance_tiles, some_trees({-30, 1000, 60, 60}), {7, 0}},
                    PlacedCase{"belt", space_instance_tiles, part_of_a_belt(), {7, 0}, 100}),
    name_of_case);

TEST(Instances, AreTheSameInPartsAndAtOnce)
{
    std::vector<Instance> parts;
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 3; ++x) {
            const auto part = made(plane_instance_tiles(), some_trees({x - 1.0, y * 0.5 - 2, 1, 0.5}));
            parts.insert(parts.end(), part.begin(), part.end());
        }
    const auto whole = made(plane_instance_tiles(), some_trees({-1, -2, 3, 2}));
    EXPECT_EQ(in_order(parts), in_order(whole));
    // Files are equal byte for byte as well.
    EXPECT_EQ(instances_csv(in_order(parts)), instances_csv(in_order(whole)));
    EXPECT_NEAR(static_cast<double>(whole.size()), 300, 4 * std::sqrt(300));
}

TEST(Instances, OfABeltAreTheSameInPartsAndAtOnce)
{
    InstanceSettings settings = a_belt();
    const auto whole = made(space_instance_tiles(), settings);
    std::vector<Instance> parts;
    for (const double x : {-1.0, 0.0}) {
        settings.window = {x, -1, 1, 2};
        const auto part = made(space_instance_tiles(), settings);
        parts.insert(parts.end(), part.begin(), part.end());
    }
    EXPECT_EQ(in_order(parts), in_order(whole));
}

/// D 7.5 has several thousand: N pi (R1^2 - R0^2) h of them. Even points scatter less than random ones.
TEST(Instances, OfABeltFillARing)
{
    const InstanceSettings settings = a_belt();
    const auto belt = made(space_instance_tiles(), settings);
    const double expected = 20'000 * std::numbers::pi * (0.81 - 0.25) * 0.1;
    EXPECT_NEAR(expected_instances(settings), expected, 1e-3 * expected);
    EXPECT_NEAR(static_cast<double>(belt.size()), expected, 3 * std::sqrt(expected));
    for (const Instance& rock : belt) {
        const auto& [x, y, z] = rock.position;
        EXPECT_TRUE(x * x + y * y >= 0.25 && x * x + y * y < 0.81 && std::abs(z) <= 0.05);
    }
    const double least = 2 * instance_radius(space_instance_tiles(), settings);
    for (std::size_t i = 0; i < 1500; ++i)
        for (std::size_t k = 0; k < i; ++k) {
            double squared = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                squared += std::pow(belt[i].position[axis] - belt[k].position[axis], 2);
            EXPECT_GE(std::sqrt(squared), least * (1 - 1e-12));
        }
}

/// Means over some 20,000 instances, within four standard errors; no two are nearer than two disk radii.
TEST(Instances, HaveEvenNumbersAndTheirDistance)
{
    InstanceSettings settings = some_trees({0, 0, 20, 20});
    settings.terrain.clear();
    const auto instances = made(plane_instance_tiles(), settings);
    const auto n = static_cast<double>(instances.size());
    std::array<double, 5> models{};
    double turn = 0, scale = 0;
    for (const Instance& i : instances) {
        ++models.at(i.model);
        turn += i.turn / n;
        scale += i.scale / n;
        EXPECT_TRUE(i.tilt >= 0 && i.tilt < 0.2 && i.position[2] == 0);
    }
    for (const double count : models) EXPECT_NEAR(count / n, 0.2, 4 * std::sqrt(0.16 / n));
    EXPECT_NEAR(turn, std::numbers::pi, 4 * std::numbers::pi / std::sqrt(3 * n));
    EXPECT_NEAR(scale, 0.75, 4 * 0.5 / std::sqrt(12 * n));
    const double least = 2 * instance_radius(plane_instance_tiles(), settings);
    for (std::size_t i = 0; i < 1000; ++i)
        for (std::size_t k = 0; k < i; ++k)
            EXPECT_GE(std::hypot(instances[i].position[0] - instances[k].position[0],
                                 instances[i].position[1] - instances[k].position[1]),
                      least * (1 - 1e-12));
}

/// x y over an area of 4 by 2 around the middle of the formula's rectangle, which is -1 to 1 along its longest side.
TEST(Instances, StandOnTheirTerrain)
{
    InstanceSettings settings = some_trees({-1, -2, 4, 2});
    settings.terrain_area = settings.window;
    settings.height = 5;
    for (const Instance& i : made(plane_instance_tiles(), settings)) {
        const double x = (i.position[0] - 1) / 2, y = (i.position[1] + 1) / 2;
        if (std::abs(x) > 0.99 || std::abs(y) > 0.49) continue; // beyond the middles of pixels heights are those there
        EXPECT_NEAR(i.position[2], 5 * x * y, 1e-12); // linear between pixels, and so is the formula along each axis
    }
    settings.terrain = "1/x/0";
    EXPECT_THAT(message_of([&] { terrain_of(settings); }), testing::HasSubstr("must be finite"));
    settings.terrain = "1e7 * y";
    EXPECT_THAT(message_of([&] { terrain_of(settings); }), testing::HasSubstr("must be at most 1000000 up or down"));
}

/// A million units of a hair's breadth have few instances, and their tiles far too many points.
TEST(Instances, AreRefusedInWindowsThatAreTooThin)
{
    InstanceSettings settings = some_trees({0, 0, 1e6, 1e-3});
    settings.terrain.clear();
    settings.density = 1000;
    EXPECT_LE(expected_instances(settings), 1e6);
    EXPECT_THAT(message_of([&] { made(plane_instance_tiles(), settings); }),
                testing::HasSubstr("points: must be at most 33554432; a window that is less thin"));
}

TEST(Instances, AreWrittenForOtherPrograms)
{
    const InstanceSettings settings = some_trees({0, 0, 1, 1});
    const auto instances = made(plane_instance_tiles(), settings);
    const std::string csv = instances_csv(instances), ply = instances_ply(instances);
    EXPECT_EQ(std::ranges::count(csv, '\n'), static_cast<std::ptrdiff_t>(instances.size() + 1));
    EXPECT_NE(ply.find("element vertex " + std::to_string(instances.size()) + "\n"), std::string::npos);
    const std::string usda = instances_usda(instances, settings, 0.1);
    EXPECT_NE(usda.find("def PointInstancer \"Instances\""), std::string::npos);
    EXPECT_NE(usda.find("</Instances/Prototypes/Model_4>]"), std::string::npos);
    EXPECT_EQ(std::ranges::count(usda, '{'), std::ranges::count(usda, '}'));
    EXPECT_EQ(std::ranges::count(usda, '['), std::ranges::count(usda, ']'));
}

std::array<std::uint8_t, 3> colour_at(const PngPixels& view, int column, int row)
{
    return {view.values[view.at(column, row, 0)], view.values[view.at(column, row, 1)],
            view.values[view.at(column, row, 2)]};
}

TEST(Instances, AreSeenFromAbove)
{
    InstanceSettings settings = some_trees({0, 0, 1, 0.5});
    settings.terrain.clear();
    settings.pixels = 120;
    const auto instances = made(plane_instance_tiles(), settings);
    const PngPixels view = view_from_above(instances, settings, instance_radius(plane_instance_tiles(), settings));
    EXPECT_EQ(view.width, 120);
    EXPECT_EQ(view.height, 60);
    EXPECT_EQ(view.values.size(), 120 * 60 * 3);
    // The middle of each instance differs from the ground.
    const PngPixels empty = view_from_above({}, settings, 0.1);
    for (const Instance& i : instances) {
        const auto column = static_cast<int>(i.position[0] * 120), row = 59 - static_cast<int>(i.position[1] * 120);
        EXPECT_NE(colour_at(view, column, row), colour_at(empty, column, row));
    }
    settings.window = {0, 0, 0.01, 1};
    EXPECT_THAT(message_of([&] { view_from_above({}, settings, 0.1); }), testing::HasSubstr("at most 4096"));
}

}
}
