// The radius specification against closed forms, against packings that we can lay out, and against the
// constants of random sequential addition.
#include "base/geometry/relative_radius.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace poissonlab {
namespace {

using std::numbers::pi;

/// Each value comes from a few roots and products, each off by half a unit in the last place at most.
constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

TEST(RelativeRadius, IsThatOfTheDissertation)
{
    // Equations 4.2 and 4.5 give rmax, half of the distance: sqrt(1 / (2 sqrt(3) N)) and cbrt(1 / (4 sqrt(2)
    // N)).
    EXPECT_NEAR(max_min_distance(1, 2), std::sqrt(2 / std::sqrt(3.0)), rounding);
    EXPECT_NEAR(max_min_distance(1, 3), std::pow(2.0, 1.0 / 6.0), rounding);
    for (const std::size_t n : {2, 100, 16384, 100000000}) {
        const auto count = static_cast<double>(n);
        EXPECT_NEAR(max_min_distance(n, 2) / (max_min_distance(1, 2) / std::sqrt(count)), 1, rounding);
        EXPECT_NEAR(max_min_distance(n, 3) / (max_min_distance(1, 3) / std::cbrt(count)), 1, rounding);
    }
}

TEST(RelativeRadius, OneCoversWhatTheDensestPackingCovers)
{
    for (const std::size_t n : {1, 7, 16384}) {
        EXPECT_NEAR(covered_fraction(max_min_distance(n, 2), n, 2), pi / (2 * std::sqrt(3.0)), 4 * rounding);
        EXPECT_NEAR(covered_fraction(max_min_distance(n, 3), n, 3), pi / (3 * std::sqrt(2.0)), 4 * rounding);
    }
}

/// The planes of the densest packings that are farthest apart: rows of disks, and layers of spheres.
TEST(RelativeRadius, ThePrincipalFrequencyIsThatOfRowsAndLayers)
{
    for (const std::size_t n : {1, 100, 16384}) {
        const double between_rows = max_min_distance(n, 2) * std::sqrt(3.0) / 2;
        EXPECT_NEAR(principal_frequency(n, 2) * between_rows, 1, rounding);
        const double between_layers = max_min_distance(n, 3) * std::sqrt(2.0 / 3);
        EXPECT_NEAR(principal_frequency(n, 3) * between_layers, 1, rounding);
    }
}

TEST(RelativeRadius, GoesBothWays)
{
    for (const int dimension : {2, 3}) {
        for (const double rho : {0.0, 0.1, 0.7, 0.75, 1.0}) {
            EXPECT_NEAR(relative_radius(min_distance_for(rho, 1000, dimension), 1000, dimension), rho, rounding);
        }
    }
}

double torus_distance(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0;
    for (std::size_t axis = 0; axis < a.size(); ++axis) {
        const double difference = std::abs(a[axis] - b[axis]);
        const double wrapped = std::min(difference, 1 - difference);
        sum += wrapped * wrapped;
    }
    return std::sqrt(sum);
}

double measured_min_distance(const std::vector<std::vector<double>>& points)
{
    double least = 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) least = std::min(least, torus_distance(points[i], points[j]));
    }
    return least;
}

// No hexagonal lattice fits a square torus exactly; 15 rows of 13 come within a percent (15 rows take 15
// sqrt(3) / 2 = 12.99 units of a row's spacing). The spacing along a row is then 1/13, between rows a hair
// more.
TEST(RelativeRadius, OfAHexagonalLatticeIsNearlyOne)
{
    constexpr int columns = 13;
    constexpr int rows = 14; // even, so that shifted rows meet at the border
    std::vector<std::vector<double>> points;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            points.push_back({(column + 0.5 * (row % 2)) / columns, static_cast<double>(row) / rows});
        }
    }
    const double expected = std::min(1.0 / columns, std::hypot(0.5 / columns, 1.0 / rows));
    const double measured = measured_min_distance(points);
    EXPECT_NEAR(measured, expected, rounding);

    // The area of a cell, d^2 sqrt(3) / 2 in the ideal lattice, is 1 / (rows columns) here.
    const double ideal = std::sqrt(2 / (std::sqrt(3.0) * rows * columns));
    EXPECT_NEAR(relative_radius(measured, points.size(), 2), expected / ideal, rounding);
    EXPECT_GT(relative_radius(measured, points.size(), 2), 0.96);
    EXPECT_LT(relative_radius(measured, points.size(), 2), 1);
}

TEST(RelativeRadius, OfAFaceCentredCubicLatticeIsOne)
{
    constexpr int cells = 3;
    std::vector<std::vector<double>> points;
    for (int x = 0; x < 2 * cells; ++x) {
        for (int y = 0; y < 2 * cells; ++y) {
            for (int z = 0; z < 2 * cells; ++z) {
                if ((x + y + z) % 2 == 0) points.push_back({x / (2.0 * cells), y / (2.0 * cells), z / (2.0 * cells)});
            }
        }
    }
    ASSERT_EQ(points.size(), 4 * cells * cells * cells);
    EXPECT_NEAR(relative_radius(measured_min_distance(points), points.size(), 3), 1, rounding);
}

TEST(RelativeRadius, OfASquareLatticeIsKnown)
{
    // 1/n apart: sqrt(sqrt(3) / 2) = 0.9306 in 2D, 2^(-1/6) = 0.8909 in 3D.
    EXPECT_NEAR(relative_radius(1.0 / 128, 128 * 128, 2), std::sqrt(std::sqrt(3.0) / 2), rounding);
    EXPECT_NEAR(relative_radius(1.0 / 32, 32 * 32 * 32, 3), std::pow(2.0, -1.0 / 6), rounding);
}

TEST(RelativeRadius, AtSaturationIsThatOfRandomSequentialAddition)
{
    // Half a unit of the last digit that is quoted.
    EXPECT_NEAR(saturation_relative_radius(2), 0.7767, 0.5e-4);
    EXPECT_NEAR(saturation_relative_radius(3), 0.8035, 0.5e-4);
    for (const int dimension : {2, 3}) {
        const std::size_t n = 1000;
        const double distance = min_distance_for(saturation_relative_radius(dimension), n, dimension);
        EXPECT_NEAR(covered_fraction(distance, n, dimension), saturation_covered_fraction(dimension), 4 * rounding);
    }
}

}
}
