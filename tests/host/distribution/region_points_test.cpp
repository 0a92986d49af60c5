// Points in regions by all methods: kernels against the plain algorithms, what is promised, and what the boundary does.
#include "host/distribution/regions/region_points.hpp"

#include "base/geometry/relative_radius.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

using testing::HasSubstr;

constexpr auto far_square_with_hole =
    "POLYGON ((500000 5400000, 500300 5400010, 500200 5400200, 500000 5400190, 500000 5400000), "
    "(500100 5400050, 500150 5400050, 500150 5400100, 500100 5400100, 500100 5400050))";

const DistributionPlace plain_place{.engine = Engine::reference, .device = {}};

DistributionPlace device_place()
{
    return {.engine = Engine::opencl, .device = []() -> Device& {
                static Device opened = Device::open();
                return opened;
            }};
}

RegionPointSettings region_settings(RegionMethod method, const std::string& region, double points_or_distance)
{
    RegionPointSettings settings;
    settings.method = method;
    settings.place.region = region;
    settings.place.reading.is_planar = true;
    if (method == RegionMethod::bridson)
        settings.place.min_distance = points_or_distance;
    else
        settings.place.points = static_cast<std::size_t>(points_or_distance);
    return settings;
}

double least_of_all_pairs(const PointSet& points)
{
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(
                least, std::sqrt(std::pow(points[i][0] - points[j][0], 2) + std::pow(points[i][1] - points[j][1], 2)));
    return least;
}

class MethodsInRegions : public testing::TestWithParam<RegionMethod>
{
};

TEST_P(MethodsInRegions, AreTheSameByKernelInsideAndKeepWhatTheyPromise)
{
    const bool is_bridson = GetParam() == RegionMethod::bridson;
    RegionPointSettings settings = region_settings(GetParam(), far_square_with_hole, is_bridson ? 9 : 300);
    settings.place.obstacles = "MULTIPOINT ((500050 5400150), (500200 5400030))";
    settings.place.obstacle_distance = 20;
    const RegionDarts made = make_region_points(settings, 3, plain_place);
    EXPECT_EQ(make_region_points(settings, 3, device_place()).points, made.points);
    EXPECT_NE(make_region_points(settings, 4, plain_place).points, made.points);
    if (is_bridson) {
        EXPECT_GT(made.points.size(), 300U); // saturated sets have about 410
        EXPECT_EQ(made.sure_distance, 9);
    } else {
        EXPECT_EQ(made.points.size(), 300U);
    }
    const FixedRegion whole(read_region(far_square_with_hole, {.is_planar = true}));
    for (std::size_t i = 0; i < made.points.size(); ++i) {
        const double x = made.points[i][0], y = made.points[i][1];
        EXPECT_TRUE(whole.contains_place({x, y}));
        EXPECT_GE(std::hypot(x - 500050, y - 5400150), 20);
        EXPECT_GE(std::hypot(x - 500200, y - 5400030), 20);
    }
    const double least = least_of_all_pairs(made.points);
    EXPECT_GE(least, made.sure_distance);
    // Distances are parts of the densest packing's in the region's area. The boundary lets all be a little farther
    // apart.
    const double densest = max_min_distance(300, 2) * std::sqrt(whole.area());
    if (GetParam() == RegionMethod::relaxation) {
        EXPECT_LT(least, made.sure_distance * 1.02);
        EXPECT_GT(least, 0.7 * densest);
    }
    if (GetParam() == RegionMethod::elimination) {
        EXPECT_GT(least, 0.55 * densest);
    }
    if (GetParam() == RegionMethod::lloyd) {
        EXPECT_GT(least, 0.55 * densest);
    }
    if (GetParam() == RegionMethod::gaussian) {
        EXPECT_GT(least, 0.45 * densest); // it evens out power, not the least distance
    }
}

INSTANTIATE_TEST_SUITE_P(All, MethodsInRegions,
                         testing::Values(RegionMethod::relaxation, RegionMethod::elimination, RegionMethod::lloyd,
                                         RegionMethod::gaussian, RegionMethod::bridson),
                         [](const auto& each) { return std::string(region_methods[each.param]); });

/// The number of points in a strip along the boundary, over that of its area if the set were even.
double density_beside_boundary(const PointSet& points, double side, double strip)
{
    double count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = points[i][0], y = points[i][1];
        count += std::min(std::min(x, side - x), std::min(y, side - y)) < strip;
    }
    const double inner = side - 2 * strip;
    return count / static_cast<double>(points.size()) / (1 - inner * inner / (side * side));
}

/// Points repel each other and the region attracts them: strips beside the boundary have what their area has.
TEST(GaussiansInRegions, AreAsDenseBesideTheBoundary)
{
    const RegionDarts made =
        make_region_points(region_settings(RegionMethod::gaussian, "rectangle 0 0 100 100", 3000), 1, device_place());
    const double mean = std::sqrt(100.0 * 100 / 3000);
    EXPECT_NEAR(density_beside_boundary(made.points, 100, mean), 1, 0.1);
    EXPECT_NEAR(density_beside_boundary(made.points, 100, 5 * mean), 1, 0.02);
}

/// A rectangle that is thinner than a tenth of a cell of the density, which no place of a cell may hit.
TEST(GaussiansInRegions, FillWhatIsVeryThin)
{
    RegionPointSettings settings = region_settings(RegionMethod::gaussian, "rectangle 0 0 20000 1", 200);
    settings.iterations = 10;
    const RegionDarts made = make_region_points(settings, 1, plain_place);
    EXPECT_EQ(make_region_points(settings, 1, device_place()).points, made.points);
    ASSERT_EQ(made.points.size(), 200U);
    const FixedRegion whole(read_region(settings.place.region));
    std::array<int, 4> in_quarters{};
    for (std::size_t i = 0; i < made.points.size(); ++i) {
        ASSERT_TRUE(whole.contains_place({made.points[i][0], made.points[i][1]})) << made.points[i][0];
        ++in_quarters[std::min<std::size_t>(static_cast<std::size_t>(made.points[i][0] / 5000), 3)];
    }
    for (const int count : in_quarters) EXPECT_NEAR(count, 50, 25) << "four deviations of random points";
}

/// Elimination without factors, written anew in Python with SciPy's trees, has 2.1 and 1.037 times as many.
TEST(EliminationInRegions, IsNotMuchDenserBesideTheBoundary)
{
    const RegionDarts made = make_region_points(
        region_settings(RegionMethod::elimination, "rectangle 0 0 100 100", 3000), 1, device_place());
    const double spacing = max_min_distance(3000, 2) * 100;
    EXPECT_LT(density_beside_boundary(made.points, 100, 0.25 * spacing), 1.6);
    EXPECT_NEAR(density_beside_boundary(made.points, 100, 5 * spacing), 1, 0.025);
}

TEST(BridsonInRegions, ComesToAllPolygons)
{
    const RegionDarts made = make_region_points(
        region_settings(
            RegionMethod::bridson,
            "MULTIPOLYGON (((0 0,10 0,10 10,0 10,0 0)),((50 50,55 50,55 55,50 50)),((90 0,99 9,90 9,90 0)))", 1),
        1, plain_place);
    int far = 0, top = 0;
    for (std::size_t i = 0; i < made.points.size(); ++i) {
        far += made.points[i][0] > 80;
        top += made.points[i][1] > 45;
    }
    EXPECT_GT(far, 20);
    EXPECT_GT(top, 8);
}

class BoundaryFirst : public testing::TestWithParam<const char*>
{
};

/// Every place on the boundary, and in the region, is nearer than the minimum distance to a point; corners are points.
TEST_P(BoundaryFirst, IsCoveredByItsOwnPoints)
{
    DartSettings settings;
    settings.region = GetParam();
    settings.boundary = RegionBoundary::on;
    settings.min_distance = 3;
    const RegionDarts made = throw_region_darts(settings, 1, plain_place);
    EXPECT_EQ(throw_region_darts(settings, 1, device_place()).points, made.points);
    EXPECT_GE(least_of_all_pairs(made.points), 3);
    const std::size_t first = made.request.on_boundary.size();
    ASSERT_GT(first, 10U);
    const auto nearest = [&](double x, double y, std::size_t count) {
        double least = HUGE_VAL;
        for (std::size_t i = 0; i < count; ++i)
            least = std::min(least, std::hypot(made.points[i][0] - x, made.points[i][1] - y));
        return least;
    };
    const PlaneRegion& plane = made.request.land->rest;
    const auto check_ring = [&](const RegionRing& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            for (int part = 0; part < 400; ++part) {
                const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
                const double x = a[0] + (b[0] - a[0]) * part / 400, y = a[1] + (b[1] - a[1]) * part / 400;
                ASSERT_LT(nearest(x, y, first), 3 * (1 + 1e-7));
            }
    };
    for (const RegionPolygon& polygon : plane.polygons) {
        check_ring(polygon.outline);
        for (const RegionRing& hole : polygon.holes) check_ring(hole);
    }
    const FixedRegion region(plane);
    const RegionBox box = region.box();
    for (double x = box.low[0]; x < box.high[0]; x += 0.3)
        for (double y = box.low[1]; y < box.high[1]; y += 0.3)
            if (region.contains_place({x, y})) {
                ASSERT_LT(nearest(x, y, made.points.size()), 3 * (1 + 1e-7));
            }
    // A number of points is that of all, and those of fewer are the first.
    settings.points = first + 7;
    const RegionDarts fewer = throw_region_darts(settings, 1, plain_place);
    EXPECT_EQ(fewer.points.size(), first + 7);
    EXPECT_TRUE(std::ranges::equal(fewer.points.coordinates,
                                   std::span(made.points.coordinates).first(fewer.points.coordinates.size())));
}

INSTANTIATE_TEST_SUITE_P(Regions, BoundaryFirst,
                         testing::Values("rectangle 0 0 30 20", "disk 10 10 12",
                                         "POLYGON ((0 0, 40 5, 30 40, 5 30, 0 0), (10 10, 12 25, 25 12, 10 10))"));

TEST(BoundaryFirst, BeginsWithCornersAndEqualParts)
{
    DartSettings settings;
    settings.region = "rectangle 0 0 30 20";
    settings.boundary = RegionBoundary::on;
    settings.min_distance = 3.9;
    const RegionDarts made = throw_region_darts(settings, 1, plain_place);
    ASSERT_EQ(made.request.on_boundary.size(), 4U + 2 * 6 + 2 * 4); // edges in 7 and 5 parts
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(made.points[i][0] == 0 || std::abs(made.points[i][0] - 30) < 1e-7);
        EXPECT_TRUE(made.points[i][1] == 0 || std::abs(made.points[i][1] - 20) < 1e-7);
    }
}

}
}
