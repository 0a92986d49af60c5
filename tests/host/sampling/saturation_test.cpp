// Saturated sets: nothing fits any more, and they cover what random sequential addition is known to cover.
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"
#include "base/geometry/torus_delaunay.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "tests/support/statistics.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using Integer = boost::multiprecision::int512_t;

DartThrowingRequest saturation(double min_distance, std::uint64_t seed)
{
    DartThrowingRequest request;
    request.min_distance = min_distance;
    request.stream = stream_key(seed, Purpose::dart_throwing, 0);
    return request;
}

/// Is the circumradius R of a triangle below the minimum distance? In integers: R = a b c / (4 area), so
/// a^2 b^2 c^2 < 4 (2 area)^2 d^2.
bool is_covered(const DelaunaySimplex<2>& triangle, std::uint64_t squared_min_distance)
{
    std::array<Integer, 3> x, y;
    const auto fixed = [](double position, int image) { // exact: multiples of 2^-32
        return static_cast<std::int64_t>(std::ldexp(position + image, 32));
    };
    for (int i = 0; i < 3; ++i) {
        x[i] = fixed(triangle[i].position[0], triangle[i].image[0]);
        y[i] = fixed(triangle[i].position[1], triangle[i].image[1]);
    }
    const auto squared_edge = [&](int i, int j) {
        return Integer((x[i] - x[j]) * (x[i] - x[j]) + (y[i] - y[j]) * (y[i] - y[j]));
    };
    const Integer twice_area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    return squared_edge(0, 1) * squared_edge(1, 2) * squared_edge(2, 0) <
           4 * twice_area * twice_area * squared_min_distance;
}

/// The number of Delaunay triangles of a set whose circumcircle leaves room for another point.
std::size_t uncovered_places(const PointSet& points, double min_distance)
{
    std::size_t uncovered = 0, triangles = 0;
    visit_triangles(points, [&](const DelaunaySimplex<2>& triangle) {
        uncovered += !is_covered(triangle, squared_threshold(min_distance));
        ++triangles;
    });
    EXPECT_EQ(triangles, 2 * points.size()); // Euler: every point is a vertex
    return uncovered;
}

TEST(Saturation, LeavesNoUncoveredPlace)
{
    // A gap between coordinates, narrower than 2^-32, would be found here although no point fits: for sets of
    // this size about one run in a thousand has one.
    const double d = min_distance_for(saturation_relative_radius(2), 16384, 2);
    DartThrower thrower(Device::open());
    for (const std::uint64_t seed : {1, 2, 3}) {
        EXPECT_EQ(uncovered_places(thrower.throw_darts(saturation(d, seed)), d), 0u);
    }
}

TEST(Saturation, TheOracleSeesAMissingPoint)
{
    const double d = min_distance_for(saturation_relative_radius(2), 4096, 2);
    PointSet points = DartThrower(Device::open()).throw_darts(saturation(d, 4));
    points.coordinates.resize(points.coordinates.size() - 2);
    EXPECT_GT(uncovered_places(points, d), 0u);
}

TEST(Saturation, CoversWhatRandomSequentialAdditionCovers)
{
    // 40 sets of about 16,384 points. Their mean has a standard error of about 0.547 sqrt(0.059 / 16384 /
    // 40), 1.6e-4, which the sets themselves tell; correlations end after a few diameters, so size effects
    // are far smaller.
    const double d = min_distance_for(saturation_relative_radius(2), 16384, 2);
    DartThrower thrower(Device::open());
    std::vector<double> fractions;
    for (std::uint64_t seed = 100; seed < 140; ++seed) {
        fractions.push_back(covered_fraction(d, thrower.throw_darts(saturation(d, seed)).size(), 2));
    }
    const test::Mean mean = test::mean_of(fractions);
    EXPECT_NEAR(mean.standard_error, 1.6e-4, 0.8e-4);
    EXPECT_NEAR(mean.value, saturation_covered_fraction(2), test::z_bound(1) * mean.standard_error);
}

TEST(Saturation, CoversWhatRandomSequentialAdditionCoversIn3D)
{
    const double d = min_distance_for(saturation_relative_radius(3), 2000, 3);
    DartThrower thrower(Device::open());
    std::vector<double> fractions;
    for (std::uint64_t seed = 100; seed < 120; ++seed) {
        DartThrowingRequest request = saturation(d, seed);
        request.dimension = 3;
        fractions.push_back(covered_fraction(d, thrower.throw_darts(request).size(), 3));
    }
    const test::Mean mean = test::mean_of(fractions);
    EXPECT_NEAR(mean.value, saturation_covered_fraction(3), test::z_bound(1) * mean.standard_error);
}

TEST(Saturation, ALargerSetSaturatesToo)
{
    // S(0) N is 0.059 * 65536, so one set deviates by 1e-3 of its size.
    const double d = min_distance_for(saturation_relative_radius(2), 65536, 2);
    const PointSet points = DartThrower(Device::open()).throw_darts(saturation(d, 9));
    const double deviation = covered_fraction(d, points.size(), 2) / saturation_covered_fraction(2) - 1;
    EXPECT_LT(std::abs(deviation), test::z_bound(1) * std::sqrt(0.059 / 65536));
    EXPECT_EQ(uncovered_places(points, d), 0u);
}

}
}
