// Squares that cover regions: all that is inside is in one of them, and they are no larger than is said.
#include "base/regions/region_squares.hpp"

#include "base/regions/region_text.hpp"
#include "tests/support/random_region.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace poissonlab {
namespace {

PlaneRegion covered_plane(const std::string& name)
{
    return name == "star" ? test::star_with_holes(5, 60, 0x1p31) : read_region(name);
}

class RegionsInSquares : public testing::TestWithParam<std::string>
{
};

TEST_P(RegionsInSquares, AreCoveredByThem)
{
    const FixedRegion region(covered_plane(GetParam()));
    for (const std::size_t most : {std::size_t{100}, std::size_t{100'000}}) {
        const RegionSquares<FixedRegion> squares = squares_of(region, most);
        ASSERT_LE(squares.corners.size(), most);
        const std::set<TorusPoint<2>> corners(squares.corners.begin(), squares.corners.end());
        EXPECT_EQ(corners.size(), squares.corners.size());
        // Positions of the region beside its edges, found by all edges.
        std::mt19937 random(3);
        std::size_t inside = 0;
        for (const FixedEdge& e : region.directed_boundary())
            for (int i = 0; i < 20; ++i) {
                const double part = std::uniform_real_distribution<double>(0, 1)(random);
                TorusPoint<2> place;
                for (std::size_t k = 0; k < 2; ++k) {
                    const double at = e[k] + part * (double{1} * e[k + 2] - e[k]);
                    const double beside = std::uniform_real_distribution<double>(-0x1p12, 0x1p12)(random);
                    place[k] = static_cast<std::uint32_t>(std::clamp(at + beside, 0.0, 0x1p31 - 1));
                }
                if (!region.contains_plainly(place)) continue;
                ++inside;
                for (std::size_t k = 0; k < 2; ++k) place[k] = place[k] >> squares.shift << squares.shift;
                EXPECT_TRUE(corners.contains(place));
            }
        EXPECT_GT(inside, 0U);
        if (most == 100) continue;
        const double positions = static_cast<double>(squares.corners.size()) * std::exp2(2 * squares.shift);
        EXPECT_GT(region.area() / (region.unit() * region.unit()), 0.24 * positions);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, RegionsInSquares,
    testing::Values("rectangle 0 0 3 2", "star", "rectangle 0 0 10000 1",
                    "POLYGON ((0 0, 9000 7000, 9000 7003, 0 3, 0 0))",
                    "MULTIPOLYGON (((0 0,1 0,0 1,0 0)),((9000 9000,9001 9000,9001 9001,9000 9000)))"));

TEST(SpaceInCubes, IsCoveredByThem)
{
    const FixedSpace space(read_space_region("box 0 0 0 3000 2 1"));
    const RegionSquares<FixedSpace> cubes = squares_of(space, 100'000);
    const double positions = static_cast<double>(cubes.corners.size()) * std::exp2(3 * cubes.shift);
    EXPECT_NEAR(positions * std::pow(space.unit(), 3), space.volume(), space.volume());
    const std::set<TorusPoint<3>> corners(cubes.corners.begin(), cubes.corners.end());
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        TorusPoint<3> place;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t in_box = space.extent().high[k] + 1;
            place[k] = static_cast<std::uint32_t>(random() % in_box) >> cubes.shift << cubes.shift;
        }
        EXPECT_TRUE(corners.contains(place));
    }
}

}
}
