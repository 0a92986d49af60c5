#include "analysis/measures/distance_statistics.hpp"

#include "base/geometry/relative_radius.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/set_features.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <numbers>

namespace poissonlab {
namespace {

using namespace test;

// Rounding of differences, squares, their sum and the root: below 5 * 2^-53 < 1e-15.
constexpr double rounding = 1e-15;

void expect_brute_force_distance(const PointSet& points)
{
    const double expected = brute_force_min_distance(points);
    EXPECT_NEAR(min_toroidal_distance(points), expected, rounding * expected)
        << points.size() << " points in " << points.dimension << "D";
}

TEST(MinToroidalDistance, IsInfiniteForFewerThanTwoPoints)
{
    EXPECT_EQ(min_toroidal_distance({2, {}}), std::numeric_limits<double>::infinity());
    EXPECT_EQ(min_toroidal_distance({3, {0.1, 0.2, 0.3}}), std::numeric_limits<double>::infinity());
}

TEST(MinToroidalDistance, WrapsAroundEveryBorder)
{
    EXPECT_EQ(min_toroidal_distance({2, {0.0, 0.0, 0.75, 0.0}}), 0.25);
    EXPECT_EQ(min_toroidal_distance({2, {0.5, 0.125, 0.5, 0.875}}), 0.25);
    EXPECT_EQ(min_toroidal_distance({2, {0.0, 0.0, 0.5, 0.5}}), std::sqrt(0.5));
    EXPECT_EQ(min_toroidal_distance({3, {0.0, 0.0, 0.0, 0.5, 0.5, 0.5}}), std::sqrt(0.75));
    EXPECT_EQ(min_toroidal_distance({3, {0.3, 0.3, 0.0, 0.3, 0.3, 1.0 - 0x1p-53}}), 0x1p-53);
    // Across a border the two small parts add up without rounding each other away.
    EXPECT_NEAR(min_toroidal_distance({2, {0x1p-60, 0.5, 1.0 - 0x1p-53, 0.5}}), 0x1p-53 + 0x1p-60, 1e-15 * 0x1p-53);
}

TEST(MeanNearestDistance, AgreesWithAllPairs)
{
    std::mt19937_64 random(6);
    for (int i = 0; i < 40; ++i) {
        const int dimension = i % 2 + 2;
        const std::size_t n = 2 + random() % (i < 30 ? 40 : 1000);
        PointSet points = i % 4 < 2 ? random_points(n, dimension, random) : random_points_32(n, dimension, random);
        if (i % 3 == 0) // all but one in a small corner
            for (std::size_t k = static_cast<std::size_t>(dimension); k < points.coordinates.size(); ++k)
                points.coordinates[k] = std::floor(points.coordinates[k] * 0x1p20) * 0x1p-30;
        double sum = 0;
        for (std::size_t a = 0; a < n; ++a) {
            double least = 10;
            for (std::size_t b = 0; b < n; ++b)
                if (a != b) least = std::min(least, squared_distance(points[a], points[b]));
            sum += std::sqrt(least);
        }
        const double expected = sum / static_cast<double>(n);
        EXPECT_NEAR(mean_nearest_distance(points), expected, 1e-12 * expected)
            << n << " points in " << dimension << "D";
    }
    EXPECT_EQ(mean_nearest_distance({2, {}}), std::numeric_limits<double>::infinity());
}

TEST(MeanNearestDistance, IsThatOfAPoissonProcess)
{
    // 1 / 2 in mean spacings, of the variance 1 / pi - 1 / 4 (Clark and Evans 1954), in 3D Gamma(4 / 3) (3 / 4
    // pi)^(1/3) of the deviation 0.2013; nearest distances of neighbours depend on each other, for which twice that is
    // taken.
    std::mt19937_64 random(8);
    constexpr std::size_t n = 40000;
    EXPECT_NEAR(mean_nearest_distance(random_points(n, 2, random)) * std::sqrt(n), 0.5,
                4 * 2 * std::sqrt((std::numbers::inv_pi - 0.25) / n));
    const double in_space = std::tgamma(4.0 / 3) * std::cbrt(0.75 * std::numbers::inv_pi);
    EXPECT_NEAR(mean_nearest_distance(random_points(n, 3, random)) * std::cbrt(n), in_space, 4 * 2 * 0.2013 / 200);
    EXPECT_NEAR(in_space / max_min_distance(1, 3), 0.494, 5e-4); // as the catalogue says
}

TEST(MeanNearestDistance, OfAWindowGoesAcrossNoBorder)
{
    const PointSet points{2, {0.125, 0.5, 0.875, 0.5}};
    EXPECT_EQ(mean_nearest_distance(points), 0.25);
    EXPECT_EQ(mean_nearest_distance_in_window(points), 0.75);
}

TEST(MinToroidalDistance, AgreesWithAllPairsOnRandomSets)
{
    std::mt19937_64 random(1);
    for (int i = 0; i < 60; ++i) {
        const int dimension = i % 2 + 2;
        expect_brute_force_distance(random_points(2 + random() % (i < 40 ? 40 : 1500), dimension, random));
    }
}

TEST(MinToroidalDistance, IsExactForFixedPointCoordinates)
{
    std::mt19937_64 random(2);
    for (int i = 0; i < 60; ++i) {
        const int dimension = i % 2 + 2;
        const PointSet points = random_points_32(2 + random() % (i < 40 ? 40 : 1500), dimension, random);
        EXPECT_EQ(min_toroidal_distance(points), brute_force_min_distance(points));
    }
}

TEST(MinToroidalDistance, AgreesWithAllPairsOnClusters)
{
    std::mt19937_64 random(3);
    for (const double width : {1e-2, 1e-4, 1e-8, 1e-12}) {
        for (const int dimension : {2, 3}) {
            for (const std::size_t clusters : {1, 3, 50}) {
                expect_brute_force_distance(clustered_points(600, dimension, clusters, width, random));
            }
        }
    }
}

TEST(MinToroidalDistance, IsZeroForCoincidingPoints)
{
    std::mt19937_64 random(4);
    for (const int dimension : {2, 3}) {
        PointSet points = random_points(500, dimension, random);
        const PointSet copy = points;
        for (const double x : copy[123]) points.coordinates.push_back(x);
        EXPECT_EQ(min_toroidal_distance(points), 0.0);
        EXPECT_EQ(min_toroidal_distance({dimension, std::vector<double>(3000, 0.5)}), 0.0);
    }
}

TEST(MinToroidalDistance, AgreesWithAllPairsOnLattices)
{
    for (const int n : {2, 3, 5, 8, 30}) expect_brute_force_distance(square_lattice(n, 2));
    for (const int n : {2, 3, 5, 10}) expect_brute_force_distance(square_lattice(n, 3));
}

TEST(MinToroidalDistance, DensestPackingsHaveRelativeRadiusOne)
{
    // 112/97 differs from 2/sqrt 3 by 5.3e-5, so the rows are that much too far apart or too close.
    const PointSet hexagonal = staggered_lattice(97, 112);
    const double row = 1.0 / 112.0, half_column = 0.5 / 97.0;
    const double expected = std::min(1.0 / 97.0, std::hypot(row, half_column));
    // Coordinates such as x / 97 are rounded to 2^-53, so distances near 0.01 to 2e-14 relative.
    EXPECT_NEAR(min_toroidal_distance(hexagonal), expected, 4e-14 * expected);
    EXPECT_NEAR(relative_radius(min_toroidal_distance(hexagonal), hexagonal.size(), 2), 1.0, 5.4e-5);

    // The cubic torus fits the face-centred cubic lattice; n = 8 makes all coordinates exact.
    const PointSet cubic = face_centred_cubic_lattice(8);
    EXPECT_NEAR(relative_radius(min_toroidal_distance(cubic), cubic.size(), 3), 1.0, rounding);
}

TEST(MinToroidalDistance, StaysFastOnClusteredSets)
{
    // All pairs of 200,000 points would take more than ten seconds; the grid needs a fraction of one.
    std::mt19937_64 random(5);
    for (const double width : {1e-3, 1e-9}) {
        const PointSet points = clustered_points(200'000, 2, 1, width, random);
        const auto start = std::chrono::steady_clock::now();
        EXPECT_GT(min_toroidal_distance(points), 0.0);
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(8));
    }
}

TEST(MinToroidalDistance, StaysFastWhenDistancesShrinkPointByPoint)
{
    // Each point halves the smallest distance: the grid is rebuilt again and again.
    PointSet points{2, {}};
    for (double x = 0.5; x > 0x1p-45; x *= 0.5) points.coordinates.insert(points.coordinates.end(), {x, 0.25});
    std::mt19937_64 random(6);
    const PointSet others = random_points(20'000, 2, random);
    points.coordinates.insert(points.coordinates.end(), others.coordinates.begin(), others.coordinates.end());
    EXPECT_EQ(min_toroidal_distance(points), 0x1p-44);
}

}
}
