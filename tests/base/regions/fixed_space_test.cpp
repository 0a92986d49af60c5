// Regions of space in whole numbers: what is inside, sides of boxes, volumes, margins, and what is refused.
#include "base/regions/fixed_space.hpp"

#include "base/regions/region_text.hpp"
#include "base/regions/region_words.hpp"
#include "base/regions/solid_lattice.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;

FixedSpace space_of(const std::string& text, double margin = 0) { return FixedSpace(read_space_region(text), margin); }

TorusPoint<3> random_in_space(std::mt19937& random)
{
    TorusPoint<3> position;
    for (std::uint32_t& c : position) c = static_cast<std::uint32_t>(random()) >> 1;
    return position;
}

double gap_in_space(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

TEST(FixedSpaces, HaveTheVolumesOfTheirShapes)
{
    EXPECT_DOUBLE_EQ(space_of("box -1 0 2 1 3 6").volume(), 24);
    EXPECT_NEAR(space_of("ball 5 5 5 2").volume(), 4 / 3.0 * M_PI * 8, 1e-12);
    // Linear functions are exact; spheres lose what lies between them and their chords.
    EXPECT_NEAR(space_of("solid 0 0 0 1 1 1 1-x-y-z").volume(), 1 / 6.0, 1e-6);
    EXPECT_NEAR(space_of("solid -1 -1 -1 1 1 1 1-x*x-y*y-z*z").volume(), 4 / 3.0 * M_PI, 1e-3);
    EXPECT_NEAR(space_of("solid 0 0 0 3 1 1 1").volume(), 3, 0.02) << "cells at the border are counted by places";
    const double torus = 2 * M_PI * M_PI * 0.7 * 0.09;
    EXPECT_NEAR(space_of("solid -1.1 -1.1 -0.4 1.1 1.1 0.4 0.09-(sqrt(x^2+y^2)-0.7)^2-z^2").volume(), torus,
                3e-3 * torus);
}

/// Away from the surface by what a chord of a cell can be, a solid is the ball that its formula says.
TEST(FixedSpaces, AreWhatTheirFormulasSay)
{
    const FixedSpace ball = space_of("ball 0 0 0 1"), solid = space_of("solid -1 -1 -1 1 1 1 1-x*x-y*y-z*z");
    std::mt19937 random(3);
    int inside = 0;
    for (int i = 0; i < 20'000; ++i) {
        const TorusPoint<3> p = random_in_space(random);
        const double r = gap_in_space(ball.own(p), {0, 0, 0});
        EXPECT_EQ(ball.contains(p), r <= 1) << r;
        if (std::abs(r - 1) > 1e-4) {
            EXPECT_EQ(solid.contains(p), r < 1) << r;
        }
        inside += ball.contains(p);
    }
    EXPECT_NEAR(inside / 20'000.0, M_PI / 6, 0.02);
}

/// Whatever side_of() says holds for positions of the box, and small boxes far from the surface are never crossed.
TEST(FixedSpaces, SayTheSidesOfBoxes)
{
    std::mt19937 random(5);
    for (const char* text : {"box 0 0 0 3 2 1", "ball 0 0 0 1", "solid -1 -1 -1 1 1 1 1-x*x-y*y-z*z",
                             "solid 0 0 0 2 2 1 sin(5*x)+cos(7*y)+sin(9*z)"}) {
        const FixedSpace space = space_of(text, text[0] == 's' ? 0 : 0.01); // solids take time for margins
        int crossed = 0, others = 0;
        for (int i = 0; i < 20'000; ++i) {
            FixedSpaceBox box{random_in_space(random), {}};
            const int bits = static_cast<int>(random() % 29);
            for (std::size_t k = 0; k < 3; ++k)
                box.high[k] =
                    std::min(box.low[k] + (static_cast<std::uint32_t>(random()) & ((1u << bits) - 1)), 0x7fffffffu);
            const RegionSide side = space.side_of(box);
            TorusPoint<3> p;
            for (std::size_t k = 0; k < 3; ++k)
                p[k] =
                    box.low[k] + static_cast<std::uint32_t>(random() % (std::uint64_t{box.high[k]} - box.low[k] + 1));
            if (side != RegionSide::crossed) {
                ASSERT_EQ(space.contains(p), side == RegionSide::inside) << text;
            }
            if (bits < 22) ++(side == RegionSide::crossed ? crossed : others);
        }
        EXPECT_LT(crossed, others / 10) << text;
    }
}

constexpr double tested_margin = 0.008; // of the torus: 0.016 of a side

TEST(FixedSpaces, KeepMarginsOfBoxesAndBalls)
{
    std::mt19937 random(8);
    const FixedSpace ball = space_of("ball 1 2 3 1", tested_margin), box = space_of("box 0 0 0 4 2 2", tested_margin);
    const double in_ball = tested_margin * 0x1p32 * ball.unit(), in_box = tested_margin * 0x1p32 * box.unit();
    EXPECT_NEAR(in_ball, 0.032, 1e-6);
    for (int i = 0; i < 20'000; ++i) {
        const TorusPoint<3> p = random_in_space(random);
        const double from_ball = 1 - gap_in_space(ball.own(p), {1, 2, 3});
        if (std::abs(from_ball - in_ball) > 1e-8) {
            EXPECT_EQ(ball.contains(p), from_ball > in_ball);
        }
        const auto [x, y, z] = box.own(p);
        EXPECT_EQ(box.contains(p), std::min({x, y, z, 4 - x, 2 - y, 2 - z}) >= in_box - 1e-8);
    }
    EXPECT_FALSE(space_of("ball 0 0 0 1", 0.3).contains({0x3fffffff, 0x3fffffff, 0x3fffffff}));
    EXPECT_EQ(space_of("box 0 0 0 1 1 1", 0.3).side_of({{}, {0x7fffffff, 0x7fffffff, 0x7fffffff}}),
              RegionSide::outside);
}

/// Positions that are allowed with a margin have all within it inside; those with more room around them than the
/// margin, and what is said to be lost, are allowed. Cells are an eighth wide here: chords of the sphere are off by 3/8
/// of its square, and so is a mean of distances.
TEST(FixedSpaces, KeepMarginsOfSolids)
{
    constexpr double lost = 3 / 8.0 / 64;
    std::mt19937 random(9);
    const FixedSpace solid = space_of("solid -8 -8 -8 8 8 8 1-x*x-y*y-z*z", tested_margin),
                     hole = space_of("solid -8 -8 -8 8 8 8 x*x+y*y+z*z-1", tested_margin);
    const double margin = tested_margin * 0x1p32 * solid.unit();
    const double spare = spare_distance(margin * 8) / 8;
    EXPECT_LT(spare, 0.2 / 8);
    for (int i = 0; i < 40'000; ++i) {
        TorusPoint<3> p = random_in_space(random);
        for (std::uint32_t& coordinate : p) coordinate = 0x34000000u + coordinate / 0x80 * 0x18; // from -1.5 to 1.5
        const double r = gap_in_space(solid.own(p), {0, 0, 0});
        if (solid.contains(p)) {
            EXPECT_GE(1 - r, margin);
        }
        if (1 - r > margin + spare + 2 * lost) {
            EXPECT_TRUE(solid.contains(p)) << r;
        }
        if (hole.contains(p)) {
            EXPECT_GE(r - 1 + lost, margin) << r;
        }
        if (r - 1 > margin + spare + 2 * lost) {
            EXPECT_TRUE(hole.contains(p)) << r;
        }
    }
}

/// Positions of regions lie in their boxes, and those of a little solid in the box of its cells, a sixteenth of a unit
/// wide.
TEST(FixedSpaces, HaveExtentsThatDoNotGoBeyondThem)
{
    for (const char* text : {"box 0 0 0 3 2 1", "box -1 0 2 1.7 3.1 6.2", "box 0 0 0 900 1 1", "ball 1 2 3 0.7"}) {
        const FixedSpace space = space_of(text);
        const std::array<double, 3> end = space.own(space.extent().high);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_LE(end[k], space.box().high[k] + 1e-15 * space.box().longest()) << text;
            EXPECT_GT(end[k], space.box().high[k] - 1.001 * space.unit()) << text;
        }
    }
    const FixedSpace ball = space_of("solid -4 -4 -4 4 4 4 0.25-(x-1)^2-(y+2)^2-z^2");
    const std::array<double, 3> low = ball.own(ball.extent().low), high = ball.own(ball.extent().high);
    for (std::size_t k = 0; k < 3; ++k) {
        const double middle = std::array{1.0, -2.0, 0.0}[k];
        EXPECT_NEAR(low[k], middle - 0.5 - 1 / 32.0, 1.01 / 32);
        EXPECT_NEAR(high[k], middle + 0.5 + 1 / 32.0, 1.01 / 32);
    }
}

/// Nodes where a formula is infinite are inside or outside, and leave the others their digits; numbers whose
/// reciprocals are infinite keep their zeros.
TEST(FixedSpaces, MayHaveInfiniteAndLeastValues)
{
    // It is infinite where x is 0, on both sides of the surface, which lies between nodes.
    EXPECT_NEAR(space_of("solid 0 0 0 1 1 1 (0.253-y)/x").volume(), 0.253, 1e-3);
    EXPECT_NEAR(space_of("solid -1 -1 -1 1 1 1 (1-x*x-y*y-z*z)*1e-300*1e-10").volume(), 4 / 3.0 * M_PI, 1e-3);
}

TEST(FixedSpaces, AreRefusedWhereThereAreNone)
{
    const auto told = [](const std::string& text) { return message_of([&] { space_of(text); }); };
    EXPECT_EQ(told("box 0 0 0 1 1"), "box 0 0 0 1 1: must be box X0 Y0 Z0 X1 Y1 Z1 with X0 < X1, Y0 < Y1 and Z0 < Z1");
    EXPECT_THAT(told("box 0 0 0 1 0 1"), HasSubstr("must be box X0 Y0 Z0"));
    EXPECT_THAT(told("box 0 0 0 1 1 1 1"), HasSubstr("must be box X0 Y0 Z0"));
    EXPECT_THAT(told("ball 0 0 0 -1"), HasSubstr("must be ball X Y Z RADIUS with RADIUS > 0"));
    EXPECT_THAT(told("ball 0 0 0 nan"), HasSubstr("must be ball X Y Z RADIUS"));
    EXPECT_THAT(told("solid 0 0 0 1 1 1"), HasSubstr("must be solid X0 Y0 Z0 X1 Y1 Z1 EXPRESSION"));
    EXPECT_EQ(told("solid 0 0 0 1 1 1 x-2"), "formula \"x-2\": is nowhere above 0 in its box");
    EXPECT_THAT(told("solid 0 0 0 1 1 1 x+w"), HasSubstr("formula \"x+w\": "));
    EXPECT_THAT(message_of([] { space_of("solid 0 0 0 1 1 1 sin(400*x)*sin(370*y)*sin(380*z)", 0.01); }),
                HasSubstr("sin(380*z)\": the solid's surface has more than 4000000 triangles on its lattice"));
    EXPECT_EQ(message_of([] { read_region("ball 0 0 0 1"); }),
              "ball 0 0 0 1: is a region of space; this takes regions of the plane");
    const TemporaryFolder folder;
    const std::string file = folder.write("ball.txt", "  ball 0 0 0 1\n").string();
    EXPECT_EQ(message_of([&] { read_region(file); }), file + ": is a region of space; this takes regions of the plane");
    EXPECT_FALSE(is_space_region_text("ball.geojson"));
    EXPECT_FALSE(is_space_region_text("ball park.geojson"));
    EXPECT_FALSE(is_region_text("solid rock.wkt"));
    EXPECT_FALSE(is_region_text("triangle (1).svg"));
    EXPECT_TRUE(is_region_text("triangle ((0 0, 1 0, 0 1, 0 0))\n"));
    EXPECT_TRUE(is_space_region_text(" ball -.5 0"));
    EXPECT_FALSE(is_space_region_text("rectangle 0 0 1 1"));
}

}
}
