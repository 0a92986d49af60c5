// The picture of the points: which points are shown, and where.
#include "reports/drawings/points_image.hpp"

#include "tests/reports/support/drawn.hpp"
#include "tests/support/point_patterns.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

TEST(PointsImage, SmallSetsAreShownWhole)
{
    const auto view = choose_points_view(test::square_lattice(16, 2));
    EXPECT_EQ(view.window, 1);
    EXPECT_EQ(view.shown(), 256);
}

TEST(PointsImage, LargeSetsAreShownInAWindow)
{
    const auto view = choose_points_view(test::square_lattice(128, 2));
    EXPECT_EQ(view.total, 16384);
    EXPECT_DOUBLE_EQ(view.window, 0.30);
    EXPECT_EQ(view.shown(), 39 * 39); // multiples of 1/128 below 0.30
    for (const int side : {45, 300, 1000}) {
        const auto shown = choose_points_view(test::square_lattice(side, 2)).shown();
        EXPECT_GE(shown, 1000);
        EXPECT_LE(shown, 2000);
    }
}

TEST(PointsImage, VolumesAreShownAsASlab)
{
    const auto view = choose_points_view(test::square_lattice(40, 3));
    EXPECT_NEAR(view.depth, 0.0281, 0.0001); // max_min_distance(64000, 3)
    EXPECT_EQ(view.shown(), 2 * 40 * 40);    // two layers, at 0 and at 1/40
}

TEST(PointsImage, DotsLieWhereThePointsAre)
{
    PointSet points{2, {0.25, 0.75, 0.5, 0.125}};
    const auto view = choose_points_view(points);
    const auto image = test::drawn(draw_points(view), 1024);
    const auto at = [&](double x, double y) {
        return image.at(static_cast<int>(x * image.width), static_cast<int>((1 - y) * image.height));
    };
    EXPECT_EQ(at(0.25, 0.75), "#000000");
    EXPECT_EQ(at(0.5, 0.125), "#000000");
    EXPECT_EQ(at(0.25, 0.25), "#ffffff");
    EXPECT_EQ(at(0.5, 0.875), "#ffffff");
}

TEST(PointsImage, DotsDoNotTouchInGoodSets)
{
    // Dots have a third of the diameter of the largest possible disks.
    const auto view = choose_points_view(test::square_lattice(40, 2));
    EXPECT_NEAR(view.dot_diameter, 1.0746 / 40 / 3, 1e-4);
}

TEST(PointsImage, SvgHasADotAPoint)
{
    const auto svg = drawing_svg(draw_points(choose_points_view(PointSet{2, {0.25, 0.75, 0.5, 0.125}})));
    EXPECT_THAT(svg, testing::HasSubstr("M250 250h0M500 875h0"));
}

}
}
