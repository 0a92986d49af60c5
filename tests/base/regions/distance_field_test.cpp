// Distances that vary: what is read of formulas and pictures, the slope, bounds over boxes, and the packing integral.
#include "base/regions/distance_field.hpp"

#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

DistanceTable table_of(const std::string& region, const std::string& formula)
{
    const PlaneRegion plane = read_region(region, {.is_planar = true});
    return distance_table(FixedRegion(plane), distance_of_text(formula, "light", {0, 1}, box_of(plane)), "it");
}

TEST(DistanceTables, KnowTheLargestSlope)
{
    EXPECT_NEAR(table_of("rectangle 0 0 1 1", "0.01+0.3*x-0.4*y+0.5").slope, 0.5, 1e-9);
    EXPECT_NEAR(table_of("rectangle 500 -20 540 10", "3+abs(x-520)").slope, 1, 1e-9);
    // x y / 10 is bilinear: its slope is that of the farthest corner, and the cell there reaches 1/256 beyond the
    // region.
    const DistanceTable bilinear = table_of("rectangle 0 0 2 1", "1+x*y/10");
    EXPECT_NEAR(bilinear.slope, std::hypot(2, 1 + 1.0 / 256) / 10, 1e-9);
    EXPECT_NEAR(bilinear.steepest[0], 2, 0.01);
    EXPECT_NEAR(bilinear.steepest[1], 1, 0.01);
    EXPECT_NEAR(table_of("disk 0 0 1", "0.3+0.2*sin(3*x)").slope, 0.6, 1e-3);
    // Where there is no region, nobody asks.
    const std::string two = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((3 0, 4 0, 4 1, 3 1, 3 0)))";
    const DistanceTable parts = table_of(two, "x < 2 ? 0.1 : 0.5");
    EXPECT_EQ(parts.slope, 0);
    EXPECT_GT(parts.slope_of_box, 10);
    EXPECT_TRUE(std::isinf(table_of(two, "abs(x-2)-0.5").slope_of_box));
}

TEST(DistanceTables, AddUpWhatIsPacked)
{
    EXPECT_NEAR(table_of("rectangle 0 0 2 1", "0.1").packing, 200, 1e-6);
    // Integral of 1 / (0.1 + x)^2 over [0, 1]: 1 / 0.1 - 1 / 1.1.
    EXPECT_NEAR(table_of("rectangle 0 0 1 1", "0.1+x").packing, 10 - 1 / 1.1, 1e-3);
    EXPECT_NEAR(table_of("disk 0 0 1", "0.1").packing, 100 * std::numbers::pi, 0.1);
    const DistanceTable table = table_of("rectangle 0 0 1 1", "0.1+x");
    EXPECT_NEAR(table.least, 0.1, 1e-9);
    EXPECT_NEAR(table.most, 1.1, 1e-9);
}

/// Distances are compared with bilinear interpolation in doubles, at random places and boxes.
TEST(DistanceFields, AreBilinearInWholeNumbersWithBounds)
{
    const FixedRegion region(read_region("rectangle 0 0 1 0.6", {.is_planar = true}));
    const std::string formula = "0.05+0.1*sin(4*x)^2+0.05*y";
    const DistanceAt distance = distance_of_text(formula, "light", {0, 1}, region.box());
    const DistanceField field(distance_table(region, distance, "it"), region, 2.0);
    std::mt19937 random(1);
    const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
    std::uniform_int_distribution<std::uint32_t> bits(0, 30);
    for (int i = 0; i < 2000; ++i) {
        const TorusPoint<2> place{below(region.extent().high[0]), below(region.extent().high[1])};
        const auto [x, y] = region.own(place);
        const double exact = 2 * distance(x, y), read = field.at(place) * region.unit();
        EXPECT_GE(read, exact);            // raised where the formula is curved
        EXPECT_LT(read, exact + 2 * 4e-6); // 1.25 + 1 times h^2 / 8 times the second derivative, 0.1 * 32, h = 1 / 512
        const std::uint32_t size = bits(random);
        const TorusPoint<2> low{place[0] >> size << size, place[1] >> size << size};
        const std::uint32_t least = field.least_in(low, size);
        EXPECT_LE(least, field.at(place)) << size;
        if (size < 20) {
            EXPECT_GE(least + 2 + (2u << size), field.at(place)) << size; // its slope is below sqrt(2)
        }
        if (size == 0) {
            EXPECT_EQ(least, field.at(place));
        }
    }
    EXPECT_EQ(field.least_in({0, 0}, 31), field.least());
}

TEST(DistancesOfPictures, LieBetweenPixelsOverTheBox)
{
    const TemporaryFolder folder;
    folder.write("ramp.pgm", "P2 3 1 255 0 255 255\n"); // 0, 1, 1
    const std::string file = (folder.path() / "ramp.pgm").string();
    const DistanceAt distance = distance_of_text(file, "light", {2, 6}, RegionBox{{10, 0}, {13, 5}});
    EXPECT_NEAR(distance(10.2, 3), 2, 1e-6);
    EXPECT_NEAR(distance(11, 3), 4, 1e-6); // between the middles of the first two pixels
    EXPECT_NEAR(distance(11.5, 3), 6, 1e-6);
    EXPECT_NEAR(distance(13, 5), 6, 1e-6);
    EXPECT_NEAR(distance_of_text(file, "ink", {2, 6}, RegionBox{{10, 0}, {13, 5}})(10, 0), 6, 1e-6);
}

TEST(DistanceTables, RefuseWhatIsNoDistance)
{
    EXPECT_THAT(message_of([] { table_of("rectangle 0 0 1 1", "x-0.5"); }),
                testing::HasSubstr("it is -0.5 at 0, 0, in or beside the region: must be above 0"));
    EXPECT_THAT(message_of([] { table_of("rectangle 0 0 1 1", "0.1+"); }), testing::HasSubstr("formula \"0.1+\""));
    EXPECT_THAT(message_of([] { table_of("rectangle 0 0 1 1", "none.png"); }), testing::HasSubstr("none.png"));
    EXPECT_THAT(message_of([] { table_of("rectangle 0 0 1 1", "x=1"); }), testing::HasSubstr("has an assignment"));
}

}
}
