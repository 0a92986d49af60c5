#include "analysis/regions/boundary_edges.hpp"

#include "analysis/regions/framed_region.hpp"
#include "base/errors/errors.hpp"
#include "base/regions/region_text.hpp"
#include "tests/analysis/regions/spatstat_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using Place = std::array<double, 2>;

double distance_plainly(const std::vector<RegionEdge>& edges, const Place& p)
{
    double least = 10;
    for (const RegionEdge& e : edges) {
        const double dx = e.to[0] - e.from[0], dy = e.to[1] - e.from[1];
        const double t =
            std::clamp(((p[0] - e.from[0]) * dx + (p[1] - e.from[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        least = std::min(least, std::hypot(p[0] - e.from[0] - t * dx, p[1] - e.from[1] - t * dy));
    }
    return least;
}

TEST(BoundaryEdges, DistancesAreThoseOfAllEdges)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> coordinate(0, 1);
    for (const PlaneRegion& region : {test::spatstat_polygon, read_region("disk 4 3 2")}) {
        const FramedRegion framed(region, "region");
        const BoundaryEdges& boundary = framed.boundary();
        for (int i = 0; i < 300; ++i) {
            const Place place{coordinate(random), coordinate(random)};
            const double distance = distance_plainly(boundary.edges(), place);
            EXPECT_NEAR(boundary.distance(place, 2), distance, 1e-15);
            EXPECT_EQ(boundary.distance(place, distance / 2), distance / 2);
            EXPECT_EQ(boundary.edges_near(place, distance * 0.999).size(), 0);
            EXPECT_GE(boundary.edges_near(place, distance * 1.001).size(), 1);
        }
    }
}

TEST(ShareOfCircle, IsThatOfManyPlacesOnIt)
{
    constexpr int steps = 20'000;
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> coordinate(0, 1);
    const FramedRegion framed(test::spatstat_polygon, "region");
    int cut = 0;
    for (int i = 0; i < 60; ++i) {
        const Place place{coordinate(random), coordinate(random)};
        if (!framed.contains(place)) continue;
        const double radius = 0.3 * coordinate(random);
        int inside = 0;
        for (int k = 0; k < steps; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / steps;
            inside += framed.contains({place[0] + radius * std::cos(angle), place[1] + radius * std::sin(angle)});
        }
        const double share = share_of_circle(place, radius, framed.boundary().edges_near(place, radius));
        // Each of at most 20 crossings misses half a step.
        EXPECT_NEAR(share, static_cast<double>(inside) / steps, 10.0 / steps);
        cut += share < 1;
    }
    EXPECT_GT(cut, 10);
}

TEST(FramedRegion, TakesPlacesBesideTheBoundaryForPlacesOnIt)
{
    const FramedRegion framed(
        {{{{{500'000, 5'300'000}, {500'800, 5'300'000}, {500'800, 5'300'400}, {500'000, 5'300'400}}}}}, "field");
    EXPECT_NEAR(framed.own_area(), 320'000, 1e-6);
    EXPECT_NEAR(framed.unit_length() * framed.side(), std::sqrt(320'000.0), 1e-9);
    const PointSet set = framed.framed({2, {500'800.0005, 5'300'000, 500'400, 5'300'399.9}}, "trees");
    EXPECT_NEAR(framed.own({set[1][0], set[1][1]})[1], 5'300'399.9, 2e-9);
    try {
        framed.framed({2, {500'400, 5'300'100, 500'400, 5'300'401}}, "trees");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "trees: 1 of 2 points lies outside the region field: the first is point 2, (500400, 5300401)");
    }
}

}
}
