// The transform of a spectrum against sums over pairs of points.
#include "analysis/spectra/autocorrelation.hpp"

#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using test::random_points;
using test::square_lattice;

Spectrum periodogram_of(const PointSet& points, int size)
{
    return {2, size, points.size(), 1, exact_periodogram(points, size)};
}

/// The sum over all pairs, and points with themselves, of the taper's own transform at their distance from (dx, dy).
double tapered_pairs(const PointSet& points, int size, double dx, double dy)
{
    const std::size_t n = points.size();
    double sum = 0;
    for (int fy = -size / 2; fy < size / 2; ++fy)
        for (int fx = -size / 2; fx < size / 2; ++fx) {
            const double share = std::hypot(fx, fy) / size;
            if (share >= 0.5) continue;
            double pairs = 0;
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j)
                    if (i != j)
                        pairs += std::cos(2 * std::numbers::pi *
                                          (fx * (points.coordinates[2 * i] - points.coordinates[2 * j] - dx) +
                                           fy * (points.coordinates[2 * i + 1] - points.coordinates[2 * j + 1] - dy)));
            sum += std::pow(std::cos(std::numbers::pi * share), 2) * pairs;
        }
    return sum / static_cast<double>(n * n);
}

TEST(Autocorrelation, IsTheSumOverPairs)
{
    std::mt19937_64 random(3);
    const PointSet points = random_points(9, 2, random);
    constexpr int size = 16;
    const SquareImage image = autocorrelation(periodogram_of(points, size), 0.5);
    ASSERT_EQ(image.size, 2 * size);
    const double step = autocorrelation_step(size);
    for (const auto& [column, row] : {std::pair{size, size}, {size + 3, size}, {size, size + 5}, {2, 29}, {31, 7}})
        EXPECT_NEAR(image.at(column, row), tapered_pairs(points, size, (column - size) * step, (row - size) * step),
                    1e-12)
            << column << ", " << row;
}

TEST(Autocorrelation, OfALatticeIsTheLattice)
{
    // 8 x 8 points: the displacements between them are multiples of 1/8, and each occurs equally often.
    const SquareImage image = autocorrelation(periodogram_of(square_lattice(8, 2), 64), 0.25);
    ASSERT_EQ(image.size, 64);
    // The height of each is the integral of the taper over the number of points, pi (1/8 - 1/(2 pi^2)) 64^2 / 64; the
    // tails of the other displacements are less than a hundredth of it.
    const double peak = 64 * std::numbers::pi * (0.125 - 0.5 / (std::numbers::pi * std::numbers::pi));
    for (const auto& [x, y] : {std::pair{16, 0}, {0, -16}, {16, -16}, {-16, 16}})
        EXPECT_NEAR(image.at(32 + x, 32 + y), peak, 0.01 * peak) << x << ", " << y;
    EXPECT_NEAR(image.at(32 + 8, 32), 0, 0.02 * peak);
}

TEST(Autocorrelation, RefusesSpectraWithoutPairsAndMeaninglessReaches)
{
    const Spectrum spectrum = periodogram_of(square_lattice(2, 2), 8);
    EXPECT_THROW(autocorrelation(spectrum, 0), std::invalid_argument);
    EXPECT_THROW(autocorrelation(spectrum, 0.6), std::invalid_argument);
    EXPECT_THROW(autocorrelation({3, 2, 5, 1, std::vector<double>(8, 1.0)}, 0.5), std::invalid_argument);
    EXPECT_THROW(autocorrelation({2, 2, 1, 1, std::vector<double>(4, 1.0)}, 0.5), std::invalid_argument);
}

}
}
