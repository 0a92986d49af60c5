#include "analysis/regions/region_transform.hpp"

#include "analysis/regions/random_in_region.hpp"
#include "base/regions/region_text.hpp"
#include "tests/analysis/regions/spatstat_numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

double plain_sinc(double t) { return t == 0 ? 1 : std::sin(std::numbers::pi * t) / (std::numbers::pi * t); }

TEST(RegionTransform, OfARectangleIsAProduct)
{
    const FramedRegion region({{{{{0, 0}, {2, 0}, {2, 0.5}, {0, 0.5}}}}}, "rectangle"); // of area 1
    for (int u = -3; u <= 3; ++u)
        for (int v = -3; v <= 3; ++v) {
            const std::complex<double> expected =
                plain_sinc(2 * u) * plain_sinc(0.5 * v) * std::polar(1.0, -2 * std::numbers::pi * (u + 0.25 * v));
            EXPECT_NEAR(std::abs(region_transform(region, u, v) - expected), 0, 1e-14) << u << ", " << v;
        }
}

TEST(RegionTransform, OfADiskIsABesselFunction)
{
    const FramedRegion region(read_region("disk 0 0 3"), "disk");
    const double radius = 1 / std::sqrt(std::numbers::pi);
    for (const double f : {1.0, 2.0, 5.0}) {
        // The polygon's area is 6.3e-6 less, and its outline as much nearer at most: with the transform's slope that is
        // 2 pi f R times 6.3e-6.
        const double expected =
            std::cyl_bessel_j(1, 2 * std::numbers::pi * f * radius) / (std::numbers::pi * f * radius);
        EXPECT_NEAR(std::abs(region_transform(region, f, 0)), std::abs(expected), 7e-6 * (1 + 2 * f * radius));
    }
}

TEST(RegionTransforms, AreThoseOfTheSumOverEdges)
{
    for (const PlaneRegion& polygons : {test::spatstat_polygon, read_region("disk 1 2 5")}) {
        const FramedRegion region(polygons, "region");
        constexpr int reach = 40;
        NonuniformTransform transform(reach);
        const HalfPlane found = region_transforms(region, reach, transform);
        double length = 0;
        for (const RegionEdge& e : region.boundary().edges())
            length += std::hypot(e.to[0] - e.from[0], e.to[1] - e.from[1]) / region.unit_length();
        for (int v = -reach; v <= reach; ++v)
            for (int u = 0; u <= reach; ++u) {
                if (u == 0 && v == 0) continue;
                const double f = std::hypot(u, v);
                EXPECT_LT(std::abs(found.at(u, v) - region_transform(region, u, v)),
                          2e-7 * length / (2 * std::numbers::pi * f))
                    << u << ", " << v;
            }
    }
}

TEST(RegionPeriodogram, OfRandomPointsIsOne)
{
    const auto region = std::make_shared<const FramedRegion>(test::spatstat_polygon, "polygon");
    constexpr int size = 32, sets = 200;
    constexpr std::size_t n = 300;
    const RandomInRegion random(*region, nullptr);
    RegionPeriodogram fast(region, size, false), exact(region, size, true);
    HalfSpectrum power, same;
    std::vector<double> mean(17 * 33);
    for (int k = 0; k < sets; ++k) {
        const PointSet points = random.points(n, static_cast<std::uint32_t>(k));
        fast.compute(points, power);
        if (k == 0) {
            exact.compute(points, same);
            for (std::size_t i = 0; i < mean.size(); ++i) EXPECT_NEAR(power.power[i], same.power[i], 1e-5) << i;
            // The expectation that is taken away has as many points: nothing is left at frequency 0.
            EXPECT_EQ(same.power[16], 0);
            EXPECT_NEAR(power.power[16], 0, 1e-5);
        }
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += power.power[i] / sets;
    }
    // The expectation of independent points is 1 - |W(f)|^2 exactly, and powers vary by their mean.
    for (int u = 0; u <= 16; ++u)
        for (int v = -16; v <= 16; ++v) {
            if (u == 0 && v <= 0) continue;
            const double expected = 1 - std::norm(region_transform(*region, u, v));
            EXPECT_NEAR(mean[static_cast<std::size_t>(u * 33 + v + 16)], expected, 5 * expected / std::sqrt(sets))
                << u << ", " << v;
        }
}

}
}
