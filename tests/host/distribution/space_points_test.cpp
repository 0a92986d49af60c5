// Points in regions of space by each method, in the regions' own units, and what is refused.
#include "host/distribution/regions/region_points.hpp"
#include "host/distribution/regions/space_points.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "host/sampling/optimized/sample_elimination.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

const DistributionPlace by_plain_code{.engine = Engine::reference, .device = {}};
const DistributionPlace by_kernels{.engine = Engine::opencl, .device = []() -> Device& {
                                       static Device opened = Device::open();
                                       return opened;
                                   }};

RegionPointSettings space_settings(const std::string& region, RegionMethod method)
{
    RegionPointSettings settings;
    settings.method = method;
    settings.place.region = region;
    return settings;
}

double space_gap(const PointSet& points, std::size_t i, std::size_t j)
{
    return std::sqrt(std::pow(points[i][0] - points[j][0], 2) + std::pow(points[i][1] - points[j][1], 2) +
                     std::pow(points[i][2] - points[j][2], 2));
}

/// Computes distances by all pairs, as a user would.
NearestDistances by_all_pairs_in_space(const PointSet& points)
{
    NearestDistances distances{HUGE_VAL, 0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        double nearest = HUGE_VAL;
        for (std::size_t j = 0; j < points.size(); ++j)
            if (j != i) nearest = std::min(nearest, space_gap(points, i, j));
        distances.least = std::min(distances.least, nearest);
        distances.mean += nearest / static_cast<double>(points.size());
    }
    return distances;
}

double from_origin(const PointSet& points, std::size_t i)
{
    return std::hypot(points[i][0], points[i][1], points[i][2]);
}

TEST(SpacePoints, AreAsFarApartAsIsAsked)
{
    for (const char* region : {"box 500000 5640000 7 500060 5640040 27", "ball -7 1e-3 500 15",
                               "solid -20 -20 -20 20 20 20 200-x*x-y*y-z*z"}) {
        RegionPointSettings settings = space_settings(region, RegionMethod::darts);
        settings.place.min_distance = 4.5;
        const RegionDarts darts = make_region_points(settings, 3, by_plain_code);
        EXPECT_TRUE(darts.is_saturated);
        const NearestDistances found = by_all_pairs_in_space(darts.points),
                               told = nearest_in_space(*darts.space, darts.points);
        EXPECT_GE(found.least, 4.5) << region;
        EXPECT_LT(found.least, 4.5 * 1.05) << region;
        EXPECT_DOUBLE_EQ(told.least, found.least);
        EXPECT_NEAR(told.mean, found.mean, 1e-9);
    }
}

/// Points that are few, and farther apart than half of the torus.
TEST(SpacePoints, AreMeasuredWhereTheyAreFew)
{
    RegionPointSettings settings = space_settings("box 0 0 0 1 1 1", RegionMethod::bridson);
    settings.place.min_distance = 0.9;
    const RegionDarts darts = make_region_points(settings, 3, by_plain_code);
    ASSERT_GE(darts.points.size(), 2U);
    EXPECT_NEAR(nearest_in_space(*darts.space, darts.points).mean, by_all_pairs_in_space(darts.points).mean, 1e-12);
}

/// Zhang and Torquato 2013: saturated spheres of half the distance fill 0.3841 of space. In a box they can reach half a
/// distance beyond it.
TEST(SpacePoints, AreAsManyAsRandomSequentialAdditionHas)
{
    RegionPointSettings settings = space_settings("box 0 0 0 20 20 20", RegionMethod::darts);
    settings.place.min_distance = 1;
    const auto count = static_cast<double>(make_region_points(settings, 1, by_kernels).points.size());
    const double density = 0.3841 / (M_PI / 6);
    EXPECT_GT(count, density * 20 * 20 * 20);
    EXPECT_LT(count, density * 21 * 21 * 21);
}

TEST(SpacePoints, StopAtANumberByEachMethod)
{
    using enum RegionMethod;
    for (const RegionMethod method : {darts, relaxation, elimination}) {
        RegionPointSettings settings = space_settings("ball 0 0 0 3", method);
        settings.place.points = 300;
        const RegionDarts made = make_region_points(settings, 1, by_plain_code);
        ASSERT_EQ(made.points.size(), 300U);
        EXPECT_EQ(make_region_points(settings, 1, by_kernels).points, made.points) << region_methods[method];
        EXPECT_NE(make_region_points(settings, 2, by_plain_code).points, made.points);
        for (std::size_t i = 0; i < made.points.size(); ++i) EXPECT_LE(from_origin(made.points, i), 3 + 1e-9);
        const double least = by_all_pairs_in_space(made.points).least;
        EXPECT_GE(least, made.sure_distance) << region_methods[method];
        // Random points have less than a tenth of the densest packing's distance.
        EXPECT_GT(least, 0.4 * std::cbrt(std::sqrt(2.0) * 36 * M_PI / 300)) << region_methods[method];
    }
}

/// The part of points that lie in the outer part of a ball, over what its volume has, is near 1 with the correction of
/// weights at the boundary, and well above without.
TEST(SpacePoints, AreNoDenserBesideTheBoundaryByElimination)
{
    RegionPointSettings settings = space_settings("ball 0 0 0 1", RegionMethod::elimination);
    settings.place.points = 4000;
    const PointSet points = make_region_points(settings, 1, by_kernels).points;
    int outer = 0;
    for (std::size_t i = 0; i < points.size(); ++i) outer += from_origin(points, i) > 0.85;
    EXPECT_NEAR(outer / 4000.0 / (1 - std::pow(0.85, 3)), 1, 0.06);
}

/// Neighbours count as far as on the torus, whatever part of it the region is: sets are as good as there (0.69), where
/// a reach of 0.7 of that leaves 0.66.
TEST(SpacePoints, AreAsFarApartByEliminationAsOnTheTorus)
{
    RegionPointSettings settings = space_settings("box 0 0 0 1 1 1", RegionMethod::elimination);
    settings.place.points = 4000;
    const double least = by_all_pairs_in_space(make_region_points(settings, 1, by_kernels).points).least;
    SampleRequest request{4000, 3, 1};
    const SamplerSpec spec = sample_elimination_sampler();
    const PointSet on_torus =
        spec.create(Parameters(spec.parameters), request, Engine::opencl, by_kernels.device)->sample(0);
    EXPECT_GT(least, 0.98 * min_toroidal_distance(on_torus));
}

TEST(SpacePoints, OfBridsonFillTheRegion)
{
    RegionPointSettings settings = space_settings("ball 0 0 0 1", RegionMethod::bridson);
    settings.place.min_distance = 0.2;
    const PointSet points = make_region_points(settings, 1, by_plain_code).points;
    EXPECT_GE(by_all_pairs_in_space(points).least, 0.2);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LE(from_origin(points, i), 1 + 1e-9);
    settings.method = RegionMethod::darts;
    const std::size_t saturated = make_region_points(settings, 1, by_plain_code).points.size();
    // Darts around points leave gaps that all darts would find: a quarter of the points, as in the plane.
    EXPECT_GT(static_cast<double>(points.size()), 0.65 * static_cast<double>(saturated));
    EXPECT_LT(points.size(), saturated);
}

TEST(SpacePoints, HaveWholeBallsInside)
{
    for (const char* region : {"ball 0 0 0 1", "solid -4 -4 -4 4 4 4 1-x*x-y*y-z*z"}) {
        RegionPointSettings settings = space_settings(region, RegionMethod::darts);
        settings.place.min_distance = 0.3;
        settings.place.boundary = RegionBoundary::disks;
        const PointSet points = make_region_points(settings, 1, by_plain_code).points;
        double farthest = 0;
        for (std::size_t i = 0; i < points.size(); ++i) farthest = std::max(farthest, from_origin(points, i));
        EXPECT_LE(farthest, 1 - 0.15 + 1e-9);
        EXPECT_GT(farthest, 1 - 0.15 - 0.04);
    }
}

/// Little solids in large boxes take no longer than large ones: darts fall into the box of their cells. Two corners of
/// a box have a large one around them.
TEST(SpacePoints, FallIntoLittleSolids)
{
    const std::string little = "solid -25 -25 -25 25 25 25 16-x*x-y*y-z*z",
                      corners = "solid 0 0 0 128 128 128 max(4-x-y-z,x+y+z-380)";
    for (const RegionMethod method : {RegionMethod::relaxation, RegionMethod::elimination, RegionMethod::bridson}) {
        RegionPointSettings settings = space_settings(little, method);
        if (method == RegionMethod::bridson)
            settings.place.min_distance = 1;
        else
            settings.place.points = 100;
        const PointSet points = make_region_points(settings, 1, by_plain_code).points;
        EXPECT_GE(points.size(), 100U);
        EXPECT_EQ(make_region_points(settings, 1, by_kernels).points, points);
        for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LE(from_origin(points, i), 4 + 1e-6);
        settings.place.region = corners;
        if (settings.place.points) settings.place.points = 20;
        const PointSet apart = make_region_points(settings, 1, by_plain_code).points;
        EXPECT_GE(apart.size(), 20U);
        EXPECT_EQ(make_region_points(settings, 1, by_kernels).points, apart);
        for (std::size_t i = 0; i < apart.size(); ++i) {
            const double sum = apart[i][0] + apart[i][1] + apart[i][2];
            EXPECT_TRUE(sum <= 4 + 1e-6 || sum >= 380 - 1e-6) << sum;
        }
    }
}

TEST(SpacePoints, AreRefusedWhereThereIsNoRoom)
{
    RegionPointSettings settings = space_settings("box 0 0 0 30 20 10", RegionMethod::darts);
    const auto told = [&] { return message_of([&] { make_region_points(settings, 1, by_plain_code); }); };
    settings.place.min_distance = 31;
    EXPECT_THAT(told(), HasSubstr("31 is more than the region's longest side, 30: there is room for few points"));
    settings.place.min_distance = 1e-3;
    EXPECT_THAT(told(),
                HasSubstr("a minimum distance of 0.001 leaves room for more points in the region than there is memory "
                          "for; at least some "));
    settings.place.min_distance = 15;
    settings.place.boundary = RegionBoundary::disks;
    EXPECT_THAT(told(), HasSubstr("the region has no room for a ball of diameter 15"));
    settings.place.boundary = RegionBoundary::inside;
    settings.place.min_distance = 8;
    settings.place.points = 500;
    EXPECT_THAT(told(), ContainsRegex("the region is saturated with [1-4][0-9] of 500 points: no further one fits; a "
                                      "minimum distance of about [2-5]\\.[0-9]+ can be reached"));
}

}
}
