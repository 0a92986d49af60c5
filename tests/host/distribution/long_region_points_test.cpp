// Points by all methods in a road of 30,000 minimum distances: kernels against the plain algorithms, what is inside,
// what is promised, and what is refused.
#include "host/distribution/regions/nearest_in_plane.hpp"
#include "host/distribution/regions/region_points.hpp"
#include "host/distribution/regions/space_points.hpp"
#include "tests/support/errors.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace poissonlab {
namespace {

using testing::HasSubstr;

/// A road of that length, 4 wide, up a slope of 3 in 4.
constexpr auto slanting_road = "POLYGON ((0 0, 24000 18000, 24000 18005, 0 5, 0 0))";
constexpr double road_area = 24'000 * 5;

const DistributionPlace plain_on_road{.engine = Engine::reference, .device = {}};

DistributionPlace device_on_road()
{
    return {.engine = Engine::opencl, .device = []() -> Device& {
                static Device opened = Device::open();
                return opened;
            }};
}

RegionPointSettings road_settings(RegionMethod method, bool has_distance)
{
    RegionPointSettings settings;
    settings.method = method;
    settings.place.region = slanting_road;
    settings.place.reading.is_planar = true;
    if (method == RegionMethod::gaussian) settings.iterations = 10;
    if (has_distance)
        settings.place.min_distance = 1;
    else
        settings.place.points = 20'000; // spaced like 2.4, at 0.7: 1.8
    return settings;
}

/// The share of points that are farther than `margin` from the road's sides is that of area, nearly; none is outside.
void expect_on_road(const PointSet& points, double margin = 0)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = points[i][0], above = points[i][1] - 0.75 * x;
        ASSERT_GE(x, margin - 1e-4);
        ASSERT_LE(x, 24'000 - margin + 1e-4);
        ASSERT_GE(above * 0.8, margin - 1e-4);
        ASSERT_LE(above * 0.8, 4 - margin + 1e-4);
    }
}

/// All parts of the road have some: its twentieths about as many each.
void expect_everywhere(const PointSet& points, double tolerance)
{
    std::array<double, 20> counts{};
    for (std::size_t i = 0; i < points.size(); ++i)
        ++counts[static_cast<std::size_t>(std::clamp(points[i][0] / 1200, 0.0, 19.0))];
    const double mean = static_cast<double>(points.size()) / 20;
    for (const double count : counts) EXPECT_NEAR(count, mean, tolerance * mean);
}

class MethodsOnRoads : public testing::TestWithParam<RegionMethod>
{
};

TEST_P(MethodsOnRoads, AreTheSameByKernelInsideAndEverywhere)
{
    const bool has_distance = GetParam() == RegionMethod::darts || GetParam() == RegionMethod::bridson;
    const RegionPointSettings settings = road_settings(GetParam(), has_distance);
    const RegionDarts made = make_region_points(settings, 3, plain_on_road);
    EXPECT_EQ(make_region_points(settings, 3, device_on_road()).points, made.points);
    expect_on_road(made.points);
    expect_everywhere(made.points, GetParam() == RegionMethod::lloyd ? 0.15 : 0.05);
    const double least = nearest_distances(made.points).least;
    if (has_distance) {
        // Random sequential addition covers 0.547 of the plane by disks of half the distance; the boundary takes more.
        EXPECT_GT(static_cast<double>(made.points.size()), road_area * 0.6);
        EXPECT_GE(least, 1);
    } else {
        EXPECT_EQ(made.points.size(), 20'000U);
    }
    EXPECT_GE(least, made.sure_distance);
}

INSTANTIATE_TEST_SUITE_P(All, MethodsOnRoads,
                         testing::Values(RegionMethod::darts, RegionMethod::relaxation, RegionMethod::elimination,
                                         RegionMethod::lloyd, RegionMethod::gaussian, RegionMethod::bridson),
                         [](const auto& method) { return std::string(region_methods[method.param]); });

TEST(DartsOnRoads, KeepDisksInsideAndAwayFromObstacles)
{
    RegionPointSettings settings = road_settings(RegionMethod::darts, true);
    settings.place.boundary = RegionBoundary::disks;
    settings.place.obstacles = "MULTIPOINT ((12000 9002), (400 302))";
    settings.place.obstacle_distance = 30;
    const RegionDarts made = make_region_points(settings, 3, plain_on_road);
    EXPECT_EQ(make_region_points(settings, 3, device_on_road()).points, made.points);
    expect_on_road(made.points, 0.5);
    for (std::size_t i = 0; i < made.points.size(); ++i)
        for (const auto& [x, y] : {std::array{12000.0, 9002.0}, {400, 302}})
            ASSERT_GE(std::hypot(made.points[i][0] - x, made.points[i][1] - y), 30);
}

/// With the boundary first, no place on it is the distance from all points.
TEST(DartsOnRoads, BeginOnTheBoundary)
{
    RegionPointSettings settings = road_settings(RegionMethod::darts, true);
    settings.place.boundary = RegionBoundary::on;
    const RegionDarts made = make_region_points(settings, 3, plain_on_road);
    EXPECT_EQ(make_region_points(settings, 3, device_on_road()).points, made.points);
    EXPECT_GE(nearest_distances(made.points).least, 1);
    std::vector<double> lower; // along the lower side, whose length is 30,000
    for (std::size_t i = 0; i < made.points.size(); ++i)
        if (made.points[i][1] - 0.75 * made.points[i][0] < 1e-3) lower.push_back(made.points[i][0] / 0.8);
    std::ranges::sort(lower);
    ASSERT_GT(lower.size(), 10'000U);
    for (std::size_t i = 1; i < lower.size(); ++i) ASSERT_LT(lower[i] - lower[i - 1], 2 + 1e-4);
}

TEST(DartsOnRoads, TakeDistancesThatVary)
{
    RegionPointSettings settings = road_settings(RegionMethod::darts, true);
    settings.place.min_distance.reset();
    settings.place.varying.text = "1 + x/24000";
    const RegionDarts made = make_region_points(settings, 3, plain_on_road);
    EXPECT_EQ(make_region_points(settings, 3, device_on_road()).points, made.points);
    expect_on_road(made.points);
    EXPECT_GE(nearest_distances(made.points).least, 1);
}

/// Turns points by an angle, so that a strip at that angle lies along x.
std::vector<std::array<double, 2>> turned_back(const PointSet& points, double degrees)
{
    const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
    std::vector<std::array<double, 2>> turned;
    for (std::size_t i = 0; i < points.size(); ++i)
        turned.push_back({points[i][0] * c + points[i][1] * s, points[i][1] * c - points[i][0] * s});
    return turned;
}

/// Gaussian blue noise in a strip at an angle, 10,000 times as long as wide, spaced like 1.
PointSet gaussian_strip(double degrees)
{
    const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
    RegionPointSettings settings;
    settings.method = RegionMethod::gaussian;
    settings.place.reading.is_planar = true;
    settings.place.points = 16'900;
    settings.place.region = fmt::format("POLYGON ((0 0, {} {}, {} {}, {} {}, 0 0))", 13000 * c, 13000 * s,
                                        13000 * c - 1.3 * s, 13000 * s + 1.3 * c, -1.3 * s, 1.3 * c);
    return make_region_points(settings, 7, device_on_road()).points;
}

/// Sets of a square have mean nearest distances of 0.89 of the densest packing's beside the boundary, where all points
/// of a strip are. Random points would have 20 in a piece for 20 with a standard deviation of 4.5.
TEST(GaussianBlueNoiseInStrips, IsAsGoodAsBesideTheBoundaryOfSquaresAtAnyAngle)
{
    for (const double degrees : {0.0, 30.0, 71.0}) {
        const PointSet points = gaussian_strip(degrees);
        ASSERT_EQ(points.size(), 16'900U);
        const NearestDistances near = nearest_distances(points);
        const double densest = std::sqrt(2 / std::sqrt(3.0));
        EXPECT_NEAR(near.mean / densest, 0.89, 0.02) << degrees;
        EXPECT_GT(near.least / densest, 0.4) << degrees;
        std::array<double, 845> counts{};
        double below_middle = 0, at_sides = 0;
        for (const auto& [x, y] : turned_back(points, degrees)) {
            ASSERT_TRUE(x > -1e-4 && x < 13000 + 1e-4 && y > -1e-4 && y < 1.3 + 1e-4) << x << ' ' << y;
            ++counts[static_cast<std::size_t>(std::clamp(x / 13000 * 845, 0.0, 844.0))];
            below_middle += y < 0.65;
            at_sides += y < 0.325 || y > 0.975;
        }
        double variance = 0;
        for (const double count : counts) variance += (count - 20) * (count - 20) / 845;
        EXPECT_LT(std::sqrt(variance), 1.5) << degrees;
        EXPECT_NEAR(below_middle / 16'900, 0.5, 0.01) << degrees;
        EXPECT_GT(at_sides / 16'900, 0.5) << degrees; // they repel each other
    }
}

/// Islands that are far from each other have what their areas have, and each is a set by itself.
TEST(GaussianBlueNoiseInStrips, FillsIslandsFarApart)
{
    RegionPointSettings settings;
    settings.method = RegionMethod::gaussian;
    settings.place.points = 2500;
    settings.place.reading.is_planar = true;
    settings.place.region = "MULTIPOLYGON (((0 0, 40 0, 40 40, 0 40, 0 0)), ((90000 50, 90030 50, 90030 80, 90000 80, "
                            "90000 50), (90010 60, 90010 70, 90020 70, 90020 60, 90010 60)))";
    const RegionDarts made = make_region_points(settings, 3, device_on_road());
    double near = 0;
    for (std::size_t i = 0; i < made.points.size(); ++i) {
        const double x = made.points[i][0], y = made.points[i][1];
        near += x < 100;
        ASSERT_FALSE(x > 90010 + 1e-3 && x < 90020 - 1e-3 && y > 60 + 1e-3 && y < 70 - 1e-3);
    }
    EXPECT_NEAR(near, 2500.0 * 1600 / 2400, 25);
    const double densest = std::sqrt(2 / std::sqrt(3.0) * 2400 / 2500);
    EXPECT_NEAR(nearest_distances(made.points).mean / densest, 0.83, 0.02);
}

TEST(PointsOfLongRegions, AreRefusedByTheirTrueCause)
{
    RegionPointSettings settings = road_settings(RegionMethod::darts, true);
    settings.place.min_distance = 1e-3;
    EXPECT_THAT(message_of([&] { make_region_points(settings, 3, plain_on_road); }),
                HasSubstr("is too short for a region of this extent, along which 2^31 positions are told apart"));
}

TEST(PointsOfLongSpaces, AreTheSameByKernelAndInside)
{
    for (const RegionMethod method :
         {RegionMethod::darts, RegionMethod::relaxation, RegionMethod::elimination, RegionMethod::bridson}) {
        RegionPointSettings settings;
        settings.method = method;
        settings.place.region = "box 0 0 0 3000 2 3";
        if (method == RegionMethod::darts || method == RegionMethod::bridson)
            settings.place.min_distance = 1;
        else
            settings.place.points = 3000;
        const RegionDarts made = make_region_points(settings, 3, plain_on_road);
        EXPECT_EQ(make_region_points(settings, 3, device_on_road()).points, made.points);
        ASSERT_GE(made.points.size(), 3000U);
        for (std::size_t i = 0; i < made.points.size(); ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_GE(made.points[i][k], 0);
                EXPECT_LE(made.points[i][k], (std::array{3000.0, 2.0, 3.0})[k] + 1e-5);
            }
        const double least = nearest_in_space(*made.space, made.points).least;
        EXPECT_GE(least, made.sure_distance);
        if (settings.place.min_distance) {
            EXPECT_GE(least, 1);
        }
    }
}

}
}
