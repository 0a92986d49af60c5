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

/// Squares that cover a strip 5,000 times as long as wide: their distances are those of a formula which changes many
/// times over a 512th of its length, and its integral is known.
TEST(DistanceFields, FollowTheFormulaInLongRegions)
{
    for (const std::string text :
         {"POLYGON ((0 0, 4000 3000, 3999.4 3000.8, -0.6 0.8, 0 0))", "rectangle 0 7 5000 8"}) {
        const PlaneRegion plane = read_region(text, {.is_planar = true});
        const FixedRegion region(plane);
        const std::string formula = "0.5+0.25*sin(x)";
        const DistanceAt distance = distance_of_text(formula, "light", {0, 1}, region.box());
        const DistanceTable table = distance_table(region, distance, "it");
        ASSERT_FALSE(table.squares.empty());
        const double side = region.unit() * (1u << table.shift), slack = 2.25 * side * side / 8 * 0.25 + 2e-5;
        EXPECT_LT(side, 0.5);
        EXPECT_NEAR(table.least, 0.25, slack);
        EXPECT_NEAR(table.most, 0.75, slack);
        EXPECT_NEAR(table.slope, 0.25, slack / side); // nodes are raised by less
        // The mean of 1 / (a + b sin)^2 over whole periods is a / (a^2 - b^2)^(3 / 2); the rest is at most 1 / 0.25^2
        // of a period of 2 pi.
        const double packing = 0.5 / std::pow(0.25 - 0.0625, 1.5) * region.area();
        EXPECT_NEAR(table.packing / packing, 1, 2 * std::numbers::pi * 16 / packing + 4 * slack);
        const DistanceField field(table, region, 1.0);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> part;
        for (int i = 0; i < 20'000; ++i) {
            const double along = 5000 * part(random), across = part(random);
            const std::array<double, 2> at = text[0] == 'r'
                                                 ? std::array{along, 7 + across}
                                                 : std::array{0.8 * along - 0.6 * across, 0.6 * along + 0.8 * across};
            TorusPoint<2> position;
            for (std::size_t k = 0; k < 2; ++k)
                position[k] =
                    static_cast<std::uint32_t>(std::max(0.0, (at[k] - region.own({0, 0})[k]) / region.unit() + 0.5));
            if (!region.contains(position)) continue;
            const double exact = distance(at[0], at[1]), read = field.at(position) * region.unit();
            ASSERT_GE(read, exact - 1e-6) << at[0]; // a position is 2e-6
            ASSERT_LT(read, exact + slack) << at[0];
            const std::uint32_t size = random() % 32;
            ASSERT_LE(field.least_in({position[0] >> size << size, position[1] >> size << size}, size),
                      field.at(position));
        }
    }
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
