#include "analysis/spectra/spectrum.hpp"

#include "tests/support/brute_force.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace poissonlab {
namespace {

using namespace test;

/// The documented bound: each transform value is within 1e-11 N of the exact sum.
constexpr double transform_error = 1e-11;

/// The deviation that this bound allows in the power P = |S|^2 / N: a change by (2 |S| d + d^2) / N with d = 1e-11 N.
double power_error(double power, std::size_t points)
{
    const auto n = static_cast<double>(points);
    return 2.0 * std::sqrt(power * n) * transform_error + transform_error * transform_error * n;
}

/// The frequency at an index of a periodogram.
std::array<int, 3> frequency_at(std::size_t index, int size, int dimension)
{
    std::array<int, 3> frequency{0, 0, 0};
    for (int k = 0; k < dimension; ++k, index /= static_cast<std::size_t>(size)) {
        frequency[k] = static_cast<int>(index % static_cast<std::size_t>(size)) - size / 2;
    }
    return frequency;
}

/// Compares with the direct sum at the first and last frequency and `samples` random ones.
void expect_brute_force_power(const PointSet& points, int size, int samples, std::mt19937_64& random)
{
    const auto power = exact_periodogram(points, size);
    for (int i = 0; i < samples + 2; ++i) {
        const std::size_t index = i == 0 ? 0 : i == 1 ? power.size() - 1 : random() % power.size();
        const auto f = frequency_at(index, size, points.dimension);
        const double expected = brute_force_power(points, f);
        ASSERT_NEAR(power[index], expected, power_error(expected, points.size()))
            << points.size() << " points, size " << size << ", f = " << f[0] << " " << f[1] << " " << f[2];
    }
}

TEST(ExactPeriodogram, AgreesWithTheDirectSumIn2D)
{
    std::mt19937_64 random(1);
    for (const int size : {2, 4, 6, 10, 64, 100, 130, 256}) {
        for (const std::size_t count : {1, 2, 3, 17, 400}) {
            expect_brute_force_power(random_points_with_borders(count, 2, random), size, 40, random);
        }
    }
}

TEST(ExactPeriodogram, AgreesWithTheDirectSumAtTheSizeOfTheDissertation)
{
    std::mt19937_64 random(2);
    expect_brute_force_power(random_points_with_borders(16'384, 2, random), 1024, 60, random);
}

TEST(ExactPeriodogram, AgreesWithTheDirectSumIn3D)
{
    std::mt19937_64 random(3);
    for (const int size : {2, 6, 20, 32}) {
        for (const std::size_t count : {1, 5, 700}) {
            expect_brute_force_power(random_points_with_borders(count, 3, random), size, 60, random);
        }
    }
}

TEST(ExactPeriodogram, AgreesWithTheDirectSumOnClusters)
{
    // More points in one strip than one product takes, and a spectrum that is far from flat.
    std::mt19937_64 random(4);
    expect_brute_force_power(clustered_points(3'000, 2, 1, 1e-4, random), 256, 60, random);
    expect_brute_force_power(clustered_points(3'000, 3, 2, 1e-3, random), 16, 60, random);
}

TEST(ExactPeriodogram, WouldShowPointsRoundedToPixels)
{
    // The comparison above is sharp enough to see what some tools do before a Fourier transform of an image.
    std::mt19937_64 random(5);
    const PointSet points = random_points(1'000, 2, random);
    PointSet rounded = points;
    for (double& x : rounded.coordinates) x = std::floor(x * 256.0) / 256.0;
    const auto power = exact_periodogram(points, 256);
    int seen = 0;
    for (int i = 0; i < 50; ++i) {
        const std::size_t index = random() % power.size();
        const double other = brute_force_power(rounded, frequency_at(index, 256, 2));
        if (std::abs(power[index] - other) > power_error(other, points.size())) ++seen;
    }
    EXPECT_EQ(seen, 50);
}

TEST(ExactPeriodogram, OfOnePointIsOneEverywhere)
{
    std::mt19937_64 random(6);
    for (const int dimension : {2, 3}) {
        const PointSet point = random_points(1, dimension, random);
        for (const double power : exact_periodogram(point, 24)) ASSERT_NEAR(power, 1.0, power_error(1.0, 1));
    }
}

TEST(ExactPeriodogram, OfALatticeIsNAtItsReciprocalLattice)
{
    for (const int dimension : {2, 3}) {
        const int n = dimension == 2 ? 12 : 6, size = dimension == 2 ? 64 : 20;
        const PointSet points = square_lattice(n, dimension);
        const auto count = static_cast<double>(points.size());
        const auto power = exact_periodogram(points, size);
        for (std::size_t i = 0; i < power.size(); ++i) {
            const auto f = frequency_at(i, size, dimension);
            const bool peak = f[0] % n == 0 && f[1] % n == 0 && f[2] % n == 0;
            const double expected = peak ? count : 0.0;
            // Beside the sum's own error: coordinates x / n are rounded by up to 2^-54, which turns the phase
            // of every term by up to 2 pi |f|_1 2^-54 < 2 pi * 96 * 2^-54 = 3.4e-14.
            const double d = (transform_error + 3.4e-14) * count;
            ASSERT_NEAR(power[i], expected, (2.0 * std::sqrt(expected * count) * d + d * d) / count)
                << f[0] << " " << f[1] << " " << f[2];
        }
    }
}

TEST(ExactPeriodogram, IsSymmetricAboutTheOrigin)
{
    std::mt19937_64 random(7);
    for (const int dimension : {2, 3}) {
        const int size = dimension == 2 ? 48 : 12;
        const PointSet points = random_points(200, dimension, random);
        const auto power = exact_periodogram(points, size);
        const auto stride = static_cast<std::size_t>(size);
        const std::size_t centre = size / 2 * (1 + stride + (dimension == 3 ? stride * stride : 0));
        for (std::size_t i = 0; i < power.size(); ++i) {
            const auto f = frequency_at(i, size, dimension);
            if (std::min({f[0], f[1], f[2]}) == -size / 2) continue; // the opposite one lies outside
            ASSERT_EQ(power[i], power[2 * centre - i]);
        }
    }
}

TEST(ExactPeriodogram, DoesNotChangeWhenPointsMoveTogether)
{
    std::mt19937_64 random(8);
    const PointSet points = random_points_32(500, 2, random); // multiples of 2^-32: the shift is exact
    PointSet shifted = points;
    for (std::size_t i = 0; i < shifted.coordinates.size(); ++i) {
        const double x = shifted.coordinates[i] + (i % 2 == 0 ? 0.3125 : 0x1.2345p-3);
        shifted.coordinates[i] = x < 1.0 ? x : x - 1.0;
    }
    const auto power = exact_periodogram(points, 64);
    const auto shifted_power = exact_periodogram(shifted, 64);
    for (std::size_t i = 0; i < power.size(); ++i) {
        ASSERT_NEAR(power[i], shifted_power[i], 2.0 * power_error(std::max(power[i], shifted_power[i]), 500));
    }
}

TEST(ExactPeriodogram, KeepsTheSumOfSquaresOnACompleteGrid)
{
    // Points on the M x M sites j/M: their transform is a discrete one, and Parseval's theorem reads
    // sum over all M^2 frequencies of P = M^2 / N * sum over sites of (points at the site)^2.
    constexpr int size = 32;
    std::mt19937_64 random(9);
    PointSet points{2, {}};
    std::vector<double> at_site(size * size);
    for (int i = 0; i < 700; ++i) {
        const std::size_t site = random() % at_site.size();
        ++at_site[site];
        points.coordinates.push_back(static_cast<double>(site % size) / size);
        points.coordinates.push_back(static_cast<double>(site / size) / size);
    }
    double squares = 0.0, sum = 0.0, allowed = 0.0;
    for (const double count : at_site) squares += count * count;
    for (const double power : exact_periodogram(points, size)) {
        sum += power;
        allowed += power_error(power, points.size());
    }
    EXPECT_NEAR(sum, size * size * squares / 700.0, allowed);
}

TEST(ExactPeriodogram, GivesTheSameBytesForAnyNumberOfThreads)
{
    std::mt19937_64 random(10);
    for (const int dimension : {2, 3}) {
        const PointSet points = random_points(3'000, dimension, random);
        const int size = dimension == 2 ? 512 : 24;
        std::vector<std::vector<double>> results;
        for (const std::size_t threads : {1, 2, 5, 2}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            results.push_back(exact_periodogram(points, size));
        }
        for (const auto& result : results) EXPECT_EQ(result, results.front());
    }
}

TEST(ExactPeriodogram, RefusesOddSizesAndEmptySets)
{
    EXPECT_THROW(exact_periodogram({2, {0.5, 0.5}}, 7), std::invalid_argument);
    EXPECT_THROW(exact_periodogram({2, {0.5, 0.5}}, 0), std::invalid_argument);
    EXPECT_THROW(exact_periodogram({2, {}}, 8), std::invalid_argument);
}

}
}
