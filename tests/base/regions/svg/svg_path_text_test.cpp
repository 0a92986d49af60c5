// Paths of SVG as regions: areas in closed form, how far curves are from their lines, fill rules, and what is refused.
#include "base/regions/region_text.hpp"

#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using testing::HasSubstr;

double area_of_path(const std::string& text) { return area_of(read_region("path " + text)); }

TEST(SvgPathRegions, HaveTheAreasOfTheirCurves)
{
    EXPECT_DOUBLE_EQ(area_of_path("M 1 1 h 3 v 2 H 1 z"), 6);
    EXPECT_DOUBLE_EQ(area_of_path("m10,10 4,0 0-3-4,0"), 12); // lines that are not said, and no end
    EXPECT_DOUBLE_EQ(area_of_path("M0 0 2 0 2 2 0 2z m 5 0 l1 0 0 1z"), 4.5);
    // A quadratic curve has two thirds of its box, this cubic one three fifths, arcs what circles and ellipses have.
    EXPECT_NEAR(area_of_path("tolerance 1e-6 M0 0 Q1 2 2 0z"), 4 / 3.0, 2e-5);
    EXPECT_NEAR(area_of_path("tolerance 1e-6 M0 0 C0 1 1 1 1 0z"), 0.6, 2e-5);
    EXPECT_NEAR(area_of_path("tolerance 1e-6 M0 0 C0 1 1 1 1 0 S2 -1 2 0 L2 -1 0 -1 0 0"), 2, 2e-5);
    EXPECT_NEAR(area_of_path("tolerance 1e-6 M3 0 A3 3 0 0 1 -3 0 A3 3 0 0 1 3 0"), 9 * M_PI, 3e-5);
    EXPECT_NEAR(area_of_path("tolerance 1e-6 M-2 0 A2 1 0 0 0 2 0 2 1 0 0 0 -2 0z"), 2 * M_PI, 3e-5);
    EXPECT_NEAR(area_of_path("tolerance 1e-6 M3 0 A3 3 0 1 1 0 -3 L0 0z"), 9 * M_PI * 3 / 4, 3e-5);
}

/// Corners lie on a circle, and chords are off by what was asked for at most, and not by much less.
TEST(SvgPathRegions, AreAsNearToCurvesAsIsAsked)
{
    for (const double tolerance : {0.1, 1e-3, 1e-5, 0.0}) {
        const std::string option = tolerance > 0 ? "tolerance " + std::to_string(tolerance) + " " : "";
        const PlaneRegion region = read_region("path " + option + "M100 0 A100 100 0 0 1 -100 0 A100 100 0 0 1 100 0");
        const RegionRing& ring = region.polygons.at(0).outline;
        double farthest = 0;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
            EXPECT_NEAR(std::hypot(a[0], a[1]), 100, 1e-9);
            farthest = std::max(farthest, 100 - std::hypot((a[0] + b[0]) / 2, (a[1] + b[1]) / 2));
        }
        // The default tolerance is a ten-thousandth of the longest side.
        const double asked = tolerance > 0 ? tolerance : 0.02;
        EXPECT_LE(farthest, asked * (1 + 1e-6));
        EXPECT_GT(farthest, asked / 4);
    }
    // A curve whose bend varies is looked at in many places.
    const PlaneRegion region = read_region("path tolerance 0.01 M0 0 C0 30 1 -20 10 0 L10 -30 0 -30z");
    double farthest = 0;
    for (int i = 0; i <= 5000; ++i) {
        const double t = i / 5000.0, s = 1 - t;
        const double x = 3 * s * t * t * 1 + t * t * t * 10, y = 3 * s * s * t * 30 - 3 * s * t * t * 20;
        double nearest = HUGE_VAL;
        const RegionRing& ring = region.polygons.at(0).outline;
        for (std::size_t j = 0; j < ring.size(); ++j) {
            const auto &a = ring[j], &b = ring[(j + 1) % ring.size()];
            const double dx = b[0] - a[0], dy = b[1] - a[1];
            const double at = std::clamp(((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
            nearest = std::min(nearest, std::hypot(x - a[0] - at * dx, y - a[1] - at * dy));
        }
        farthest = std::max(farthest, nearest);
    }
    EXPECT_LE(farthest, 0.01);
    EXPECT_GT(farthest, 0.001);
}

/// The usual tolerance is a ten-thousandth of the longest side of the box around the arc itself. Its ends alone, or the
/// middle of its circle, would have other boxes.
TEST(SvgPathRegions, HaveAToleranceOfTheirArcsExtent)
{
    // The box is 2 wide, and the middle of the circle 100 away.
    const double angle = 2 * std::asin(0.01);
    const PlaneRegion shallow = read_region("path M1 0 A100 100 0 0 1 -1 0 L-1 -1 1 -1z");
    EXPECT_NEAR(area_of(shallow), 2 + 100 * 100 / 2.0 * (angle - std::sin(angle)), 2 * 2e-4);
    EXPECT_EQ(corner_count(shallow), 4 + std::ceil(angle / (2 * std::acos(1 - 2e-4 / 100))) - 1);
    // An ellipse of radii 4 and 1, turned by 30 degrees: 2 sqrt(16 cos^2 + sin^2) = 7 wide, and its ends 6.93.
    const double half_turn_pieces = std::ceil(M_PI / (2 * std::acos(1 - 7e-4 / 4)));
    const PlaneRegion turned = read_region("path M3.4641016151377544 2 A4 1 30 0 1 -3.4641016151377544 -2 "
                                           "A4 1 30 0 1 3.4641016151377544 2");
    EXPECT_EQ(corner_count(turned), 2 * half_turn_pieces);
    EXPECT_GT(std::ceil(M_PI / (2 * std::acos(1 - 6.93e-4 / 4))), half_turn_pieces);
    EXPECT_NEAR(area_of(turned), 4 * M_PI, 7e-4 * 17.2); // the tolerance times the circumference
}

/// A square in a square, in the same direction and in the other, and a third one in that.
TEST(SvgPathRegions, AreFilledByTheRuleOfSvg)
{
    const std::string outer = "M0 0 10 0 10 10 0 10z ", same = "M2 2 8 2 8 8 2 8z ", other = "M2 2 2 8 8 8 8 2z ",
                      inner = "M4 4 5 4 5 5 4 5z ";
    EXPECT_DOUBLE_EQ(area_of_path(outer + same), 100);
    EXPECT_DOUBLE_EQ(area_of_path("nonzero " + outer + same), 100);
    EXPECT_DOUBLE_EQ(area_of_path("evenodd " + outer + same), 64);
    EXPECT_DOUBLE_EQ(area_of_path(outer + other), 64);
    EXPECT_DOUBLE_EQ(area_of_path("evenodd " + outer + other), 64);
    EXPECT_DOUBLE_EQ(area_of_path(outer + other + inner), 65);
    EXPECT_DOUBLE_EQ(area_of_path(outer + same + inner), 100);
    EXPECT_DOUBLE_EQ(area_of_path("evenodd " + outer + same + inner), 65);
}

TEST(SvgPathRegions, AreRefusedWhereTheyAreNone)
{
    const auto told = [](const std::string& text) { return message_of([&] { read_region("path " + text); }); };
    EXPECT_THAT(told("M0 0 L1 0 1 1 x"), HasSubstr("path M0 0 L1 0 1 1 x: is not a path of SVG: "));
    EXPECT_THAT(told("M0 0 L1 0"), HasSubstr("has no closed path: must be path M... of SVG, with an area"));
    EXPECT_THAT(told("evenodd"), HasSubstr("has no closed path"));
    EXPECT_THAT(told("M0 0 2 2 2 0 0 2z"), HasSubstr("cross"));
    EXPECT_THAT(told("M0 0 4 0 4 4 0 4z M2 2 6 2 6 6 2 6z"), HasSubstr("cross"));
    // The middle of the second one's first edge is twice inside, so that this ring alone would be left out.
    EXPECT_THAT(told("M0 0 4 0 4 4 0 4z M2 2 3 2 6 6 2 6z"), HasSubstr("cross"));
    // They cross in corners of one of them.
    EXPECT_THAT(told("M0 0 4 0 4 4 0 4z M2 2 4 2 6 3 4 3 3 3z"), HasSubstr("cross"));
    EXPECT_THAT(told("M0 0 4 0 4 4 0 4z M0 0 4 0 4 4 0 4z"), HasSubstr("share a piece of a line"));
    EXPECT_THAT(told("tolerance -1 M0 0 1 0 1 1z"), HasSubstr("tolerance: must be followed by a number above 0"));
    EXPECT_THAT(told("tolerance 1e-16 M3 0 A3 3 0 0 1 -3 0z"), HasSubstr("a tolerance of 1e-16 is too small"));
    std::string disks = "tolerance 1e-9 "; // of 70,000 pieces each
    for (int i = 0; i < 30; ++i) disks += "M0 0 a1 1 0 0 1 2 0 a1 1 0 0 1 -2 0z ";
    EXPECT_THAT(told(disks), HasSubstr("a tolerance of 1e-09 is too small: curves would have more than 1e+06 pieces"));
}

}
}
