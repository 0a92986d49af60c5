// Points on lines are measured: against closed forms of random points and equal steps, and all pairs by brute force.
#include "host/distribution/regions/line_set.hpp"

#include "base/regions/region_text.hpp"
#include "host/distribution/regions/line_points.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;

LineSet measured(const std::string& lines, const PointSet& points)
{
    return measure_line_set(read_region(lines, {.is_along = true}), points);
}

/// Closed forms for random points on a straight line of length L: a mean gap of L / (n + 1), a mean nearest-neighbour
/// distance of nearly L / (2 n), and a variation of gaps of 1.
TEST(LineSets, OfRandomPointsHaveTheirClosedForms)
{
    constexpr std::size_t count = 20'000;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part;
    PointSet points{2, {}};
    for (std::size_t i = 0; i < count; ++i) {
        const double at = part(random);
        points.coordinates.insert(points.coordinates.end(), {3000 * at, 4000 * at});
    }
    const LineSet set = measured("LINESTRING (0 0, 1200 1600, 3000 4000)", points);
    EXPECT_NEAR(set.length, 5000, 1e-9);
    ASSERT_EQ(set.gaps.size(), count - 1);
    const double each = 5000.0 / count, error = 5 / std::sqrt(double{count});
    EXPECT_NEAR(set.mean_nearest, each / 2, each / 2 * error);
    const double sum = std::accumulate(set.gaps.begin(), set.gaps.end(), 0.0);
    EXPECT_LT(5000 - sum, 20 * each); // the two ends, whose lengths are exponential, are missing
    double longer = 0;
    for (const double gap : set.gaps) longer += gap > 2 * each;
    EXPECT_NEAR(longer / count, std::exp(-2.0), error);
}

TEST(LineSets, MeasureCrossingsClosedLinesAndRepeatedEdges)
{
    // Two streets that cross, a square, one of whose edges is there again, and points at known places.
    const std::string lines = "GEOMETRYCOLLECTION (LINESTRING (0 0, 10 0), LINESTRING (5 -5, 5 5), "
                              "POLYGON ((20 0, 24 0, 24 4, 20 4, 20 0)), LINESTRING (20 0, 24 0))";
    const PointSet points{2, {1, 0, 4, 0, 5, 3, 5, 0.5, 24, 1, 20, 2}};
    const LineSet set = measured(lines, points);
    EXPECT_EQ(set.lines, 4U);
    EXPECT_NEAR(set.length, 10 + 10 + 16, 1e-12);
    EXPECT_NEAR(set.least, std::hypot(1, 0.5), 1e-12);
    EXPECT_THAT(set.gaps, testing::Pointwise(testing::DoubleNear(1e-12), std::vector<double>{2.5, 3, 7, 9}));
    double nearest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double least = HUGE_VAL;
        for (std::size_t j = 0; j < points.size(); ++j)
            if (j != i) least = std::min(least, std::hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]));
        nearest += least / static_cast<double>(points.size());
    }
    EXPECT_NEAR(set.mean_nearest, nearest, 1e-12);
}

/// Rounded points on an edge of two lines, as parcels have, all belong to the first one.
TEST(LineSets, GivePointsOnASharedEdgeToOneLine)
{
    PointSet points{2, {}};
    for (int i = 0; i <= 100; ++i)
        points.coordinates.insert(points.coordinates.end(), {std::round(3e5 * i) * 1e-6, std::round(1e5 * i) * 1e-6});
    const LineSet set = measured("GEOMETRYCOLLECTION (LINESTRING (0 0, 30 10), LINESTRING (30 10, 0 0))", points);
    ASSERT_EQ(set.gaps.size(), 100U);
    EXPECT_NEAR(set.gaps.back() / set.gaps.front(), 1, 1e-4);
}

/// Darts until no further one fits: gaps are between one and two distances, and L over the distance times 0.7476 points
/// fit.
TEST(LineSets, OfDartsThatLeaveNoRoomAreJammedAsRenyiSays)
{
    DartSettings settings;
    settings.region = "LINESTRING (0 0, 6000 8000)";
    settings.reading.is_along = true;
    settings.min_distance = 1;
    const RegionDarts made = throw_line_darts(settings, 3);
    const LineSet set = measured(settings.region, made.points);
    const double share = set.least * static_cast<double>(made.points.size()) / set.length;
    EXPECT_NEAR(share, 0.7475979, 5 * std::sqrt(0.0381564 / 10'000));
    EXPECT_GE(set.gaps.front(), 1 - 1e-9);
    EXPECT_LT(set.gaps.back(), 2 + 1e-6);
    EXPECT_NEAR(set.least, set.gaps.front(), 1e-9);
}

TEST(LineSets, RefusePointsBesideTheLines)
{
    const PointSet points{2, {1, 0, 2, 1e-6, 3, 0.1, 40, 0}};
    EXPECT_THAT(message_of([&] { measured("LINESTRING (0 0, 10 0)", points); }),
                HasSubstr("2 of 4 points are not on the lines: the first is point 3, (3, 0.1)"));
}

/// Points of a fine curve are found on it, however its corners lie in the grid.
TEST(LineSets, FindPointsOfCurves)
{
    std::string text = "LINESTRING (";
    PointSet points{2, {}};
    double length = 0;
    for (int i = 0; i <= 20'000; ++i) {
        const double t = i * 1e-3;
        if (i > 0)
            length += std::hypot(t * std::cos(t) - points.coordinates[points.coordinates.size() - 2],
                                 t * std::sin(t) - points.coordinates.back());
        points.coordinates.insert(points.coordinates.end(), {t * std::cos(t), t * std::sin(t)});
        text += (i > 0 ? ", " : "") + std::to_string(points.coordinates[points.coordinates.size() - 2]) + " " +
                std::to_string(points.coordinates.back());
    }
    const LineSet set = measured(text + ")", points);
    ASSERT_EQ(set.gaps.size(), 20'000U);
    EXPECT_NEAR(std::accumulate(set.gaps.begin(), set.gaps.end(), 0.0) / length, 1, 1e-4);
}

}
}
