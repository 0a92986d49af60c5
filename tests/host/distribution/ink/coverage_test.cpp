// Covered parts of pixels against closed forms and counted places.
#include "host/distribution/ink/coverage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace poissonlab {
namespace {

using std::numbers::pi;

ConvexPolygon rectangle_of(double x0, double y0, double x1, double y1)
{
    ConvexPolygon polygon;
    polygon.add({x0, y0});
    polygon.add({x1, y0});
    polygon.add({x1, y1});
    polygon.add({x0, y1});
    return polygon;
}

TEST(DiskInPolygon, IsExactForPartsOfADisk)
{
    EXPECT_NEAR(disk_in_polygon(2, rectangle_of(-3, -3, 3, 3)), 4 * pi, 1e-12);
    EXPECT_NEAR(disk_in_polygon(2, rectangle_of(0, 0, 3, 3)), pi, 1e-12);
    EXPECT_NEAR(disk_in_polygon(2, rectangle_of(-3, 1, 3, 3)), 4 * pi / 3 - std::sqrt(3.0), 1e-12); // a cap of 120°
    EXPECT_NEAR(disk_in_polygon(2, rectangle_of(-0.5, -0.5, 0.5, 0.5)), 1, 1e-12);
    EXPECT_EQ(disk_in_polygon(2, rectangle_of(2, 2, 3, 3)), 0);
    ConvexPolygon triangle; // a sixth of a hexagon whose inscribed circle is the disk
    triangle.add({0, 0});
    triangle.add({2 / std::sqrt(3.0), 2});
    triangle.add({-2 / std::sqrt(3.0), 2});
    EXPECT_NEAR(disk_in_polygon(2, triangle), 4 * pi / 6, 1e-12);
}

/// Places of a fine lattice in the pixel that are in the stroke: the error of their share is below that of a border
/// through some 3,000 cells of 1e-6.
TEST(StrokeInPixel, IsTheShareOfItsPlaces)
{
    std::mt19937 random(3);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
    };
    int partial = 0;
    for (int repeat = 0; repeat < 40; ++repeat) {
        const std::array<double, 5> stroke{number(-1, 2), number(-1, 2), number(-1, 2), number(-1, 2), number(0.1, 2)};
        int inside = 0;
        for (int row = 0; row < 1000; ++row)
            for (int column = 0; column < 1000; ++column) {
                const double x = (column + 0.5) / 1000 - stroke[0], y = (row + 0.5) / 1000 - stroke[1];
                const double ax = stroke[2] - stroke[0], ay = stroke[3] - stroke[1];
                const double part = std::clamp((x * ax + y * ay) / (ax * ax + ay * ay), 0.0, 1.0);
                inside += std::hypot(x - part * ax, y - part * ay) < stroke[4] / 2;
            }
        EXPECT_NEAR(stroke_in_pixel(stroke, 0, 0), inside * 1e-6, 3e-4) << repeat;
        partial += inside > 0 && inside < 1'000'000 ? 1 : 0;
    }
    EXPECT_GT(partial, 20);
}

TEST(Coverage, AddsUpToTheAreaOfMarks)
{
    MarkGroup marks;
    marks.disks = {{5.3, 4.2, 2.1}, {14.1, 6.6, 0.3}};
    marks.strokes = {{22.5, 3.5, 29.1, 8.2, 1.7}};
    const Coverage coverage = coverage_of(marks, 40, 12, 1);
    const double stroke = std::hypot(6.6, 4.7) * 1.7 + pi * 0.85 * 0.85;
    EXPECT_NEAR(coverage.covered, pi * (2.1 * 2.1 + 0.3 * 0.3) + stroke, 1e-10);
    EXPECT_NEAR(coverage.laid, coverage.covered, 1e-10);
    EXPECT_EQ(coverage.parts[4 * 40 + 5], 1);
    // At twice the scale, four times the area.
    EXPECT_NEAR(coverage_of(marks, 80, 24, 2).covered, 4 * coverage.covered, 1e-10);
}

/// Disks that touch have nothing in common; a disk at the frame is cut in halves.
TEST(Coverage, IsExactForDisksThatTouch)
{
    MarkGroup marks;
    marks.disks = {{3.25, 5, 2}, {7.25, 5, 2}, {0, 11, 1.5}};
    const Coverage coverage = coverage_of(marks, 20, 14, 1);
    EXPECT_NEAR(coverage.covered, 8 * pi + pi * 2.25 / 2, 1e-10);
}

/// A viewer decodes sRGB (IEC 61966-2-1): the part that is covered comes back, within half of the largest step between
/// two bytes, (1 - f(254 / 255)) / 2.
TEST(Coverage, IsShownAsItIs)
{
    const auto light = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    EXPECT_EQ(shown_byte(0), 255);
    EXPECT_EQ(shown_byte(1), 0);
    EXPECT_EQ(shown_byte(0.5), 188);
    for (int i = 0; i <= 1000; ++i) {
        const double part = i / 1000.0, seen = 1 - light(shown_byte(part) / 255.0);
        EXPECT_NEAR(seen, part, 0.5 * (1 - light(254.0 / 255)));
        EXPECT_NEAR(shown_part(shown_byte(part)), seen, 0.5 / 65535 + 1e-12);
    }
}

/// The union of two disks, by the lens that they have in common.
TEST(Coverage, CountsWhatOverlapsOnce)
{
    constexpr double radius = 6, apart = 5;
    MarkGroup marks;
    marks.disks = {{10, 10, radius}, {10 + apart, 10, radius}};
    const Coverage coverage = coverage_of(marks, 30, 20, 1);
    const double lens = 2 * radius * radius * std::acos(apart / 2 / radius) -
                        apart / 2 * std::sqrt(4 * radius * radius - apart * apart);
    EXPECT_NEAR(coverage.laid, 2 * pi * radius * radius, 1e-10);
    // A border of some 30 pixels, each counted at 256 places.
    EXPECT_NEAR(coverage.covered, 2 * pi * radius * radius - lens, 30 * 1.0 / 64);
    EXPECT_NEAR(coverage.covered, 2 * pi * radius * radius - lens, 0.2);
}

}
}
