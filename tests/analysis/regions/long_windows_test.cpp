// Windows that are very long: neighbours in grids of which only cells with points are listed, random points and places
// by squares, and transforms of long boundaries.
#include "analysis/regions/plane_neighbours.hpp"
#include "analysis/regions/random_in_region.hpp"
#include "analysis/regions/region_distances.hpp"
#include "analysis/regions/region_transform.hpp"
#include "base/regions/region_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

const std::string slanting = "POLYGON ((0 0, 100000 70000, 100000 70010, 0 10, 0 0))";

/// Points of the slanting strip's frame; every tenth is anywhere in the square.
PointSet scattered_points(std::size_t count)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0, 0.999999);
    PointSet points{2, {}};
    for (std::size_t i = 0; i < count; ++i) {
        const double x = part(random), y = i % 10 == 0 ? part(random) : 0.7 * x + 1e-4 * part(random);
        points.coordinates.insert(points.coordinates.end(), {x, y});
    }
    return points;
}

TEST(NeighboursInLongWindows, AreThoseOfAllPoints)
{
    const PointSet points = scattered_points(2000);
    const PlaneNeighbours sorted(points, 1e-4);
    ASSERT_EQ(sorted.size(), points.size());
    std::mt19937 random(5);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto& at = sorted.place(sorted.number_of(i));
        ASSERT_EQ(at, (std::array{points[i][0], points[i][1]}));
        double nearest = 10;
        for (std::size_t j = 0; j < points.size(); ++j)
            if (j != i)
                nearest =
                    std::min(nearest, std::sqrt(std::pow(points[j][0] - at[0], 2) + std::pow(points[j][1] - at[1], 2)));
        EXPECT_EQ(sorted.nearest(at, sorted.number_of(i)), nearest);
        if (i % 20 != 0) continue;
        for (const double reach : {1e-4, 1e-2, 0.5}) {
            std::size_t expected = 0, found = 0;
            for (std::size_t j = 0; j < points.size(); ++j)
                expected += std::pow(points[j][0] - at[0], 2) + std::pow(points[j][1] - at[1], 2) <= reach * reach;
            sorted.for_each_near(at, reach, [&](std::size_t, double) { ++found; });
            EXPECT_EQ(found, expected);
        }
    }
}

/// Counts in equal parts along the strip.
template <typename Places>
std::array<double, 50> counts_along(std::size_t count, const Places& place)
{
    std::array<double, 50> counts{};
    for (std::size_t i = 0; i < count; ++i) ++counts[static_cast<std::size_t>(std::min(place(i)[0] * 50, 49.0))];
    return counts;
}

TEST(RandomPointsInLongWindows, AreUniform)
{
    const FramedRegion region(read_region(slanting), "strip");
    constexpr std::size_t count = 50'000;
    const PointSet points = RandomInRegion(region, nullptr).points(count, 1);
    double chi_squared = 0;
    for (const double found : counts_along(count, [&](std::size_t i) { return points[i]; }))
        chi_squared += (found - 1000) * (found - 1000) / 1000;
    EXPECT_LT(chi_squared, 100); // of 49 degrees of freedom: once in 40,000 times
    for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(region.contains({points[i][0], points[i][1]}));
}

TEST(PlacesInLongWindows, AreEven)
{
    const FramedRegion region(read_region(slanting), "strip");
    const RegionPlaces places(region, 50'000, 1e-3);
    const auto& all = places.places();
    EXPECT_NEAR(static_cast<double>(all.size()), 50'000, 500);
    // Deviations are less than those of chance, of which the sum would be 49.
    const double mean = static_cast<double>(all.size()) / 50;
    double chi_squared = 0;
    for (const double found : counts_along(all.size(), [&](std::size_t i) { return all[i]; }))
        chi_squared += (found - mean) * (found - mean) / mean;
    EXPECT_LT(chi_squared, 25);
    double across = 0;
    for (const auto& place : all) across += (place[1] - 0.7 * place[0]) / 1e-4;
    EXPECT_NEAR(across / static_cast<double>(all.size()), 0.5, 0.005);
}

/// A rectangle that is so long that its window is summed over its edges, and a road with many corners, whose places are
/// transformed in parts.
TEST(TransformsOfLongWindows, AreThoseOfTheSumOverEdges)
{
    RegionRing road;
    for (int i = 0; i <= 4000; ++i) road.push_back({1e4 * i, 0.1 * (i % 2)});
    for (int i = 4000; i >= 0; --i) road.push_back({1e4 * i, 1.0});
    for (const PlaneRegion& polygons : {read_region("rectangle 0 0 40000000 1"), PlaneRegion{{{road, {}}}}}) {
        const FramedRegion region(polygons, "region");
        constexpr int reach = 40;
        NonuniformTransform transform(reach);
        const HalfPlane found = region_transforms(region, reach, transform);
        const double length = 2 * 4e7 / region.side() / region.unit_length();
        for (int v = -reach; v <= reach; v += 7)
            for (int u = 0; u <= reach; u += 5) {
                if (u == 0 && v == 0) continue;
                EXPECT_LT(std::abs(found.at(u, v) - region_transform(region, u, v)),
                          2e-7 * length / (2 * std::numbers::pi * std::hypot(u, v)))
                    << u << ", " << v;
            }
    }
}

}
}
