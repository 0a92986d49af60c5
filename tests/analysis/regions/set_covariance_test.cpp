#include "analysis/regions/set_covariance.hpp"

#include "analysis/regions/framed_region.hpp"
#include "base/regions/obstacles.hpp"
#include "tests/analysis/regions/spatstat_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

/// Two polygons, one with a hole, with edges in all directions, upright and level ones among them.
const PlaneRegion two_polygons{{{{{0.05, 0.1}, {0.6, 0.1}, {0.6, 0.5}, {0.45, 0.9}, {0.2, 0.45}, {0.05, 0.8}},
                                 {{{0.2, 0.2}, {0.2, 0.35}, {0.4, 0.3}}}},
                                {{{0.7, 0.3}, {0.95, 0.2}, {0.9, 0.7}}}}};

/// The area that CGAL's exact arithmetic leaves of both.
double common_area(const PlaneRegion& region, double x, double y)
{
    PlaneRegion moved = region;
    for (RegionPolygon& polygon : moved.polygons) {
        for (auto& corner : polygon.outline) corner = {corner[0] + x, corner[1] + y};
        for (RegionRing& hole : polygon.holes)
            for (auto& corner : hole) corner = {corner[0] + x, corner[1] + y};
    }
    return area_of(region) - area_of(without_polygons(region, moved.polygons));
}

TEST(SetCovariance, IsTheAreaThatARegionAndTheMovedOneHaveInCommon)
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> vector(-0.7, 0.7);
    for (const PlaneRegion& region : {two_polygons, test::spatstat_polygon}) {
        const FramedRegion framed(region, "polygons");
        const SetCovariance covariance(framed.boundary().edges());
        EXPECT_NEAR(covariance.area(), framed.area(), 1e-15);
        for (int i = 0; i < 40; ++i) {
            // Some vectors lie along an axis, where edges move along themselves.
            const double x = i % 5 == 1 ? 0 : vector(random), y = i % 5 == 2 ? 0 : vector(random);
            EXPECT_NEAR(covariance.exact(x, y), common_area(framed.polygons(), x, y), 1e-14) << x << ", " << y;
            EXPECT_NEAR(covariance.exact(x, y), covariance.exact(-x, -y), 1e-15);
        }
    }
}

TEST(SetCovariance, OfARectangleIsAProduct)
{
    const FramedRegion framed({{{{{-3, 2}, {5, 2}, {5, 6}, {-3, 6}}}}}, "rectangle");
    const SetCovariance covariance(framed.boundary().edges());
    const double width = 8 / framed.side(), height = 4 / framed.side();
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {0.25, 0.125}, {-0.9, 0.4}, {0.3, -0.6}})
        EXPECT_NEAR(covariance.exact(x, y), std::max(0.0, width - std::abs(x)) * std::max(0.0, height - std::abs(y)),
                    1e-15);
}

TEST(SetCovariance, TableKnowsItsError)
{
    std::mt19937_64 random(5);
    const double reach = 0.1;
    std::uniform_real_distribution<double> vector(-reach, reach);
    const FramedRegion framed(two_polygons, "polygons");
    SetCovariance covariance(framed.boundary().edges());
    covariance.expect(1000, reach);
    EXPECT_EQ(covariance.table_error(), 0) << "few calls are worth no table";
    covariance.expect(1e9, reach);
    ASSERT_GT(covariance.table_error(), 0);
    EXPECT_LT(covariance.table_error(), 1e-3);
    double largest = 0;
    for (int i = 0; i < 2000; ++i) {
        const double x = vector(random), y = vector(random);
        largest = std::max(largest, std::abs(covariance.at(x, y) - covariance.exact(x, y)) / framed.area());
    }
    // Errors of convex and concave pieces are largest in the middle of cells, those of edges along themselves nearly.
    EXPECT_LT(largest, 2 * covariance.table_error());
    EXPECT_EQ(covariance.at(2 * reach, 0), covariance.exact(2 * reach, 0)) << "beyond the table";
}

TEST(SetCovariance, ReachEndsWhereAShareIsLeft)
{
    const FramedRegion framed({{{{{0, 0}, {1, 0}, {1, 0.1}, {0, 0.1}}}}}, "strip");
    const SetCovariance covariance(framed.boundary().edges());
    EXPECT_NEAR(covariance.reach(0.1, 1), 0.09, 1.0 / (16 * 256));
    EXPECT_EQ(covariance.reach(0.1, 0.05), 0.05);
}

TEST(SetCovariance, NarrowRegionsHaveAReach)
{
    for (const double height : {1e-2, 1e-3, 1e-5}) {
        const FramedRegion framed({{{{{0, 0}, {1, 0}, {1, height}, {0, height}}}}}, "strip");
        const double expected = 0.9 * box_of(framed.polygons()).height();
        EXPECT_NEAR(SetCovariance(framed.boundary().edges()).reach(0.1, 1.4), expected, expected / 128) << height;
    }
}

}
}
