// Fast periodograms against exact sums, and against closed forms.
#include "analysis/spectra/fast_periodogram.hpp"

#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <cstdio>
#include <numeric>

namespace poissonlab {
namespace {

using namespace test;

/// The relative l2 error of transform values' magnitudes.
double l2_error(const std::vector<double>& power, const std::vector<double>& exact)
{
    double squares = 0;
    for (std::size_t i = 0; i < power.size(); ++i) squares += std::pow(std::sqrt(power[i]) - std::sqrt(exact[i]), 2);
    return std::sqrt(squares / std::accumulate(exact.begin(), exact.end(), 0.0));
}

std::vector<double> fast_periodogram(const PointSet& points, int size,
                                     double tolerance = FastPeriodogram::default_tolerance)
{
    return all_frequencies(FastPeriodogram(points.dimension, size, tolerance).compute(points));
}

TEST(FastPeriodogram, AgreesWithTheExactSum)
{
    std::mt19937_64 random(1);
    double worst = 0;
    for (const int dimension : {2, 3}) {
        for (int i = 0; i < 40; ++i) {
            const int size = 2 * (1 + static_cast<int>(random() % (dimension == 2 ? 100 : 16)));
            const std::size_t count = 1 + random() % 1000;
            const PointSet sets[] = {random_points_with_borders(count, dimension, random),
                                     clustered_points(count, dimension, 3, 1e-3, random)};
            for (const PointSet& points : sets) {
                const double error = l2_error(fast_periodogram(points, size), exact_periodogram(points, size));
                ASSERT_LE(error, FastPeriodogram::default_tolerance)
                    << dimension << "D, " << count << " points, size " << size;
                worst = std::max(worst, error);
            }
        }
    }
    std::printf("largest relative l2 error: %.2e\n", worst);
}

TEST(FastPeriodogram, AgreesWithTheExactSumAtTheSizeOfTheDissertation)
{
    std::mt19937_64 random(2);
    const PointSet points = random_points(16'384, 2, random);
    const double error = l2_error(fast_periodogram(points, 1024), exact_periodogram(points, 1024));
    std::printf("relative l2 error: %.2e\n", error);
    EXPECT_LE(error, FastPeriodogram::default_tolerance);
}

TEST(FastPeriodogram, IsAsAccurateAsAskedForAndNotFarMore)
{
    std::mt19937_64 random(3);
    const PointSet points = random_points(500, 2, random);
    const auto exact = exact_periodogram(points, 128);
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) {
        const double error = l2_error(fast_periodogram(points, 128, tolerance), exact);
        std::printf("tolerance %.0e: relative l2 error %.2e\n", tolerance, error);
        EXPECT_LE(error, tolerance);
        // Two grid points more or less are a factor of exp(2 pi sqrt(1/5)) = 17; and random points are not the worst.
        EXPECT_GE(error, tolerance / 17 / 10);
    }
}

TEST(FastPeriodogram, OfOnePointIsOneEverywhere)
{
    std::mt19937_64 random(4);
    for (const int dimension : {2, 3}) {
        const auto power = fast_periodogram(random_points(1, dimension, random), 24);
        EXPECT_LE(l2_error(power, std::vector<double>(power.size(), 1.0)), FastPeriodogram::default_tolerance);
    }
}

TEST(FastPeriodogram, OfALatticeIsNAtItsReciprocalLattice)
{
    const int n = 12, size = 64;
    const PointSet points = square_lattice(n, 2);
    const auto power = fast_periodogram(points, size);
    for (int v = -size / 2; v < size / 2; ++v) {
        for (int u = -size / 2; u < size / 2; ++u) {
            const double expected = u % n == 0 && v % n == 0 ? n * n : 0;
            // Transform values are N or 0, each within 1e-8 N.
            EXPECT_NEAR(power[(v + size / 2) * size + u + size / 2], expected, 2e-8 * n * n) << u << " " << v;
        }
    }
}

TEST(FastPeriodogram, ObeysParsevalOnACompleteGridOfFrequencies)
{
    // Points on the grid of 1/M: M x M frequencies are all there are, and the sum of |F|^2 is M^2 times the sum of
    // squared numbers of points in a place.
    std::mt19937_64 random(5);
    const int size = 32;
    PointSet points{2, {}};
    std::vector<double> numbers(size * size);
    for (int i = 0; i < 700; ++i) {
        const std::size_t x = random() % size, y = random() % size;
        points.coordinates.insert(points.coordinates.end(),
                                  {static_cast<double>(x) / size, static_cast<double>(y) / size});
        ++numbers[y * size + x];
    }
    const auto power = fast_periodogram(points, size);
    const double sum = std::accumulate(power.begin(), power.end(), 0.0);
    const double expected =
        size * size * std::inner_product(numbers.begin(), numbers.end(), numbers.begin(), 0.0) / 700;
    EXPECT_NEAR(sum / expected, 1, 4e-9); // twice the error of the transform
}

TEST(FastPeriodogram, DoesNotChangeWhenPointsAreTranslated)
{
    std::mt19937_64 random(6);
    for (const int dimension : {2, 3}) {
        const PointSet points = random_points(300, dimension, random);
        PointSet moved = points;
        for (double& x : moved.coordinates) x = x + 0.3717 - std::floor(x + 0.3717);
        EXPECT_LE(l2_error(fast_periodogram(moved, 30), fast_periodogram(points, 30)), 2e-9);
    }
}

TEST(FastPeriodogram, GivesTheSameBytesForAnyNumberOfThreadsAndEveryTime)
{
    std::mt19937_64 random(7);
    for (const int dimension : {2, 3}) {
        const int size = dimension == 2 ? 130 : 26;
        const PointSet points = random_points(2'000, dimension, random);
        FastPeriodogram used(dimension, size);
        const auto expected = used.compute(points).power;
        EXPECT_EQ(used.compute(points).power, expected);
        for (const std::size_t threads : {1, 2, 7}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            EXPECT_EQ(FastPeriodogram(dimension, size).compute(points).power, expected) << threads;
        }
    }
}

/// Kernels that take more memory than they may are made for a band of lines at a time. Half of the points are in one
/// corner, around the border of the torus.
TEST(FastPeriodogram, GivesTheSameBytesInLittleMemory)
{
    std::mt19937_64 random(8);
    for (const int dimension : {2, 3}) {
        const int size = dimension == 2 ? 130 : 26;
        PointSet points = random_points(2'000, dimension, random);
        for (std::size_t i = 0; i < points.coordinates.size() / 2; ++i) {
            double& x = points.coordinates[i];
            x = x < 0.5 ? 0.01 * x : 1 - 0.01 * x;
        }
        const auto expected = FastPeriodogram(dimension, size).compute(points).power;
        for (const std::size_t bytes : {1, 20'000, 100'000, 300'000})
            EXPECT_EQ(FastPeriodogram(dimension, size, FastPeriodogram::default_tolerance, bytes).compute(points).power,
                      expected)
                << dimension << "D, " << bytes;
    }
}

TEST(FastPeriodogram, RefusesWhatHasNoMeaning)
{
    EXPECT_THROW(FastPeriodogram(4, 16), std::invalid_argument);
    EXPECT_THROW(FastPeriodogram(2, 15), std::invalid_argument);
    EXPECT_THROW(FastPeriodogram(2, 0), std::invalid_argument);
    EXPECT_THROW(FastPeriodogram(2, 16, 1e-12), std::invalid_argument);
    EXPECT_THROW(FastPeriodogram(2, 16, NAN), std::invalid_argument);
    EXPECT_THROW(FastPeriodogram(2, 16).compute({2, {}}), std::invalid_argument);
    EXPECT_THROW(FastPeriodogram(2, 16).compute({3, {0.1, 0.2, 0.3}}), std::invalid_argument);
}

TEST(HalfSpectrum, IsTheHalfOfAllFrequenciesAndBack)
{
    std::mt19937_64 random(8);
    for (const int dimension : {2, 3}) {
        const PointSet points = random_points(50, dimension, random);
        const auto power = exact_periodogram(points, 10);
        const HalfSpectrum half = half_of(power, dimension, 10);
        EXPECT_EQ(all_frequencies(half), power);
        // Frequencies M/2 are in no full spectrum of size M.
        const auto fast = FastPeriodogram(dimension, 10).compute(points).power;
        ASSERT_EQ(fast.size(), half.power.size());
        if (dimension == 2) continue;
        EXPECT_NEAR(fast.back(), half.power.back(), 1e-6);
    }
}

TEST(HalfSpectrum, HasTheRadialMeansOfTheWhole)
{
    std::mt19937_64 random(9);
    for (const int dimension : {2, 3}) {
        const auto power = exact_periodogram(random_points(50, dimension, random), 24);
        for (const double width : {1.0, 2.5}) {
            const auto radial = radial_statistics({dimension, 24, 50, 1, power}, width);
            const auto means = radial_means(half_of(power, dimension, 24), width);
            ASSERT_EQ(means.size(), radial.size());
            for (std::size_t k = 0; k < means.size(); ++k)
                EXPECT_NEAR(means[k], radial[k].power, 1e-13 * radial[k].power);
        }
    }
}

}
}
