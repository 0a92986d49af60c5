// Even points over rectangles: grids of tiles, and methods that make theirs for a square.
#include "host/distribution/even_points.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/tile_points/tile_points.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace poissonlab {
namespace {

using testing::HasSubstr;

DistributionPlace work_on(Engine engine)
{
    return {engine, []() -> Device& {
                static Device device = Device::open();
                return device;
            }};
}

std::string grid_text(std::size_t points, double width, double height)
{
    const EvenTileGrid grid = tile_grid(points, 32, width, height);
    return std::to_string(grid.columns) + " x " + std::to_string(grid.rows);
}

/// The numbers of lights and dots in the dissertation's figures 7.1 and 7.3 are whole tiles of 32 points.
TEST(EvenTileGrid, HasTheTilesOfTheDissertation)
{
    EXPECT_EQ(grid_text(288, 1, 1), "3 x 3");
    EXPECT_EQ(grid_text(3200, 1, 1), "10 x 10");
    EXPECT_EQ(grid_text(12'800, 512, 512), "20 x 20");
    EXPECT_EQ(grid_text(256, 2, 1), "4 x 2");
    EXPECT_EQ(grid_text(256, 1, 2), "2 x 4");
    EXPECT_EQ(grid_text(1, 1, 1), "1 x 1");
    EXPECT_EQ(grid_text(320, 1000, 1), "10 x 1");
}

TEST(EvenTileGrid, IsRefusedBeyond65536TilesAlongASide)
{
    EXPECT_THAT(message_of([] { tile_grid(3'000'000, 32, 1e9, 1); }), HasSubstr("65536 tiles"));
}

TEST(EvenPoints, OfTilesAreThoseOfTheTiling)
{
    const PoissonTileSet tiles = random_tile_set(PoissonTileKind::corner, 2, 3, 8);
    const SquarePoints points = even_points(tiles, 48, 3, 2, 5, work_on(Engine::reference));
    ASSERT_EQ(points.size(), 2 * 48);
    EXPECT_EQ(even_points(tiles, 48, 3, 2, 5, work_on(Engine::opencl)), points);
    EXPECT_NE(even_points(tiles, 48, 3, 2, 6, work_on(Engine::reference)), points);
    // Each of the 3 x 2 tiles holds the points of one tile of the set.
    for (std::size_t tile = 0; tile < 6; ++tile) {
        std::vector<std::uint16_t> units;
        for (std::size_t n = 0; n < 16; ++n) {
            const std::uint64_t side = n % 2 == 0 ? 3 : 2;
            const std::uint64_t unit = (points[16 * tile + n] * side * 65536 + 0xffffffff) >> 32;
            EXPECT_EQ(unit >> 16, n % 2 == 0 ? tile % 3 : tile / 3);
            units.push_back(static_cast<std::uint16_t>(unit));
        }
        bool is_of_the_set = false;
        for (std::uint32_t t = 0; t < tiles.parameters.tiles; ++t)
            is_of_the_set = is_of_the_set || std::ranges::equal(tiles.tile(t), units);
        EXPECT_TRUE(is_of_the_set) << tile;
    }
}

/// The least distance of two points; over the left and right border as well where it closes there.
double least_distance(const SquarePoints& points, double width, double height, bool closes)
{
    double least = INFINITY;
    for (std::size_t i = 0; i < points.size(); i += 2)
        for (std::size_t k = 0; k < i; k += 2) {
            double x = std::abs(points[i] / 0x1p32 - points[k] / 0x1p32);
            if (closes) x = std::min(x, 1 - x);
            least = std::min(least, std::hypot(x * width, (points[i + 1] / 0x1p32 - points[k + 1] / 0x1p32) * height));
        }
    return least;
}

/// Numbers that are no whole tiles, one point, and proportions that leave less than a tile along a side.
TEST(EvenPoints, OfTilesAreAsManyAsAreAskedFor)
{
    const PoissonTileSet tiles = read_tile_set(source_folder() + "/runtime/tile_sets/corner-c3-n64-r075.ptiles");
    for (const Seam seam : {Seam::open, Seam::closed})
        for (const auto& [points, width, height] :
             {std::tuple{1, 1, 1}, {3, 2, 1}, {1000, 3, 2}, {1001, 2, 1}, {777, 40, 1}, {1000, 1, 1}, {1500, 1, 3}}) {
            const auto count = static_cast<std::size_t>(points);
            const SquarePoints square = even_points(tiles, count, width, height, 5, work_on(Engine::reference), seam);
            ASSERT_EQ(square.size(), 2 * count);
            EXPECT_EQ(even_points(tiles, count, width, height, 5, work_on(Engine::opencl), seam), square);
            if (points < 700 || height > width) continue;
            // The distance of the tiling, 0.75 of the largest one of so many points, but for as many as a border has;
            // closed strips are of whole tiles, which are not square then.
            const double largest = std::sqrt(2 / std::sqrt(3.0) * width * height / points);
            const double allowed = seam == Seam::closed ? 0.8 : 0.96;
            EXPECT_GE(least_distance(square, width, height, seam == Seam::closed), 0.75 * allowed * largest)
                << points << " " << width << " " << height;
        }
}

/// A lattice of 16 x 16, of which the lower half has 128 places: the rectangle's sides are whole.
TEST(EvenPoints, OfOtherMethodsAreCutOutOfASquare)
{
    const SamplerSpec& grid = *find_sampler("regular");
    const SquarePoints points =
        even_points(SamplerChoice{&grid, Parameters(grid.parameters)}, 128, 2, 1, 1, work_on(Engine::opencl));
    ASSERT_EQ(points.size(), 256);
    std::set<std::uint32_t> xs, ys;
    for (std::size_t i = 0; i < points.size(); i += 2) {
        xs.insert(points[i]);
        ys.insert(points[i + 1]);
    }
    EXPECT_EQ(xs.size(), 16);
    EXPECT_EQ(ys.size(), 8);
    EXPECT_EQ(*std::next(ys.begin()) - *ys.begin(), 2 * (*std::next(xs.begin()) - *xs.begin()));
}

/// The square around a thin rectangle has far more points than it.
TEST(EvenPoints, OfOtherMethodsAreRefusedWhereTheSquareHasTooMany)
{
    const SamplerSpec& grid = *find_sampler("regular");
    const SamplerChoice method{&grid, Parameters(grid.parameters)};
    EXPECT_THAT(message_of([&] { even_points(method, 1'000'000, 1, 1000, 1, work_on(Engine::reference)); }),
                HasSubstr("are 1000000000 in the square around them; must be at most 134217728"));
}

TEST(EvenPoints, AreRefusedOfMethodsInSpace)
{
    const SamplerSpec& spheres = *find_sampler("sphere-tiles");
    const SamplerChoice method{&spheres, Parameters(spheres.parameters)};
    EXPECT_THAT(message_of([&] { even_points(method, 128, 1, 1, 1, work_on(Engine::reference)); }),
                HasSubstr("has no sets in the plane"));
}

}
}
