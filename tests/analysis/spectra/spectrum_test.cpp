#include "analysis/spectra/spectrum.hpp"

#include "analysis/spectra/radial_statistics.hpp"
#include "base/errors/errors.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/point_patterns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using namespace test;
using testing::HasSubstr;

TEST(SpectrumSize, FollowsEquation66)
{
    EXPECT_EQ(spectrum_size(16'384, 2), 1024); // 635 samples
    EXPECT_EQ(spectrum_size(4'096, 2), 512);   // 318
    EXPECT_EQ(spectrum_size(65'536, 3), 256);  // 192
    EXPECT_EQ(spectrum_size(1, 2), 8);         // 4.96
    EXPECT_EQ(spectrum_size(156'000, 3), 256); // 255.8
    EXPECT_EQ(spectrum_size(157'000, 3), 256); // 256.3: a volume of 512^3 is too much
    EXPECT_EQ(spectrum_size(1'000, 3), 64);    // 47.5
}

TEST(BlockMeans, LeaveOutFrequencyZero)
{
    Spectrum spectrum{2, 4, 9, 1, {}};
    for (int i = 0; i < 16; ++i) spectrum.power.push_back(i); // frequency (0, 0) is number 10
    const Spectrum means = block_means(spectrum, 2);
    EXPECT_EQ(means.size, 2);
    EXPECT_EQ(means.points, 9U);
    EXPECT_EQ(means.power, (std::vector<double>{2.5, 4.5, 10.5, 40.0 / 3}));
    EXPECT_EQ(block_means(spectrum, 4).power, (std::vector<double>{110.0 / 15}));
    EXPECT_THROW(block_means(spectrum, 3), std::invalid_argument);
}

TEST(BlockMeans, BlocksArePowersOfTwoThatDivideTheSize)
{
    for (const auto& [size, block] :
         {std::pair{2, 1}, {2048, 1}, {2050, 2}, {4096, 2}, {4098, 2}, {5000, 4}, {8192, 4}})
        EXPECT_EQ(block_for(size, 2048), block) << size;
}

TEST(SpectrumEstimate, CountsEveryRealizationOnce)
{
    std::mt19937_64 random(1);
    const PointSet first = random_points(50, 2, random), second = random_points(50, 2, random);
    SpectrumEstimate estimate(2, 16, false, PeriodogramMethod::exact);
    estimate.add(first);
    estimate.add(second);
    const Spectrum mean = estimate.mean();
    const auto a = exact_periodogram(first, 16), b = exact_periodogram(second, 16);
    EXPECT_EQ(mean.dimension, 2);
    EXPECT_EQ(mean.size, 16);
    EXPECT_EQ(mean.points, 50u);
    EXPECT_EQ(mean.realizations, 2);
    ASSERT_EQ(mean.power.size(), a.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(mean.power[i], (a[i] + b[i]) / 2, 0x1p-51 * (a[i] + b[i]));
        // The variance of two values, next to the rounding of their difference.
        EXPECT_NEAR(mean.variance[i], (a[i] - b[i]) * (a[i] - b[i]) / 2, 0x1p-50 * (a[i] * a[i] + b[i] * b[i]));
    }
}

TEST(SpectrumEstimate, KeepsDcAtTheCentre)
{
    std::mt19937_64 random(2);
    SpectrumEstimate estimate(2, 16);
    for (int i = 0; i < 3; ++i) estimate.add(random_points(50, 2, random));
    // P(0) = N^2 / N; 1e-8 N in the transform are 2e-8 N in the power.
    EXPECT_NEAR(estimate.mean().at(0, 0), 50.0, 1e-6);
}

TEST(SpectrumEstimate, RefusesRealizationsOfUnequalSize)
{
    std::mt19937_64 random(3);
    SpectrumEstimate estimate(2, 16);
    estimate.add(random_points(50, 2, random));
    EXPECT_EQ(message_of([&] { estimate.add(random_points(49, 2, random)); }),
              "realization 1 has 49 points where the first has 50");
    EXPECT_THROW(estimate.add(random_points(50, 3, random)), InputError);
    EXPECT_THROW(estimate.add({2, {}}), InputError);
    EXPECT_EQ(estimate.mean().realizations, 1); // the refused ones left no trace
}

TEST(SpectrumEstimate, NormalisesEachSetByItsOwnSizeWhereSizesVary)
{
    std::mt19937_64 random(4);
    const PointSet small = random_points(20, 2, random);
    const PointSet large = random_points(60, 2, random);
    SpectrumEstimate estimate(2, 16, true, PeriodogramMethod::exact);
    estimate.add(small);
    estimate.add(large);
    const auto power_of_small = exact_periodogram(small, 16);
    const auto power_of_large = exact_periodogram(large, 16);
    const Spectrum mean = estimate.mean();
    EXPECT_EQ(mean.points, 20u);
    for (std::size_t i = 0; i < mean.power.size(); ++i) {
        const double sum = power_of_small[i] + power_of_large[i];
        EXPECT_NEAR(mean.power[i], sum / 2, 0x1p-51 * sum);
    }
    EXPECT_NEAR(mean.at(0, 0), (20.0 + 60.0) / 2, 1e-9);
}

TEST(SpectrumEstimate, RadialErrorsAreThoseOfTheRealizationsCurves)
{
    std::mt19937_64 random(5);
    constexpr int k = 5, size = 32;
    SpectrumEstimate estimate(2, size);
    std::vector<std::vector<RadialBin>> curves;
    for (int i = 0; i < k; ++i) {
        const PointSet points = random_points(100, 2, random);
        estimate.add(points);
        EXPECT_EQ(estimate.radial_errors().empty(), i == 0);
        curves.push_back(radial_statistics({2, size, 100, 1, exact_periodogram(points, size)}));
    }
    const auto errors = estimate.radial_errors();
    ASSERT_EQ(errors.size(), curves[0].size());
    for (std::size_t bin = 0; bin < errors.size(); ++bin) {
        double mean = 0, squares = 0;
        for (const auto& curve : curves) mean += curve[bin].power / k;
        for (const auto& curve : curves) squares += (curve[bin].power - mean) * (curve[bin].power - mean);
        EXPECT_NEAR(errors[bin], std::sqrt(squares / (k - 1) / k), 1e-7) << bin;
    }
}

TEST(SpectrumEstimate, RefusesMeaninglessSizes)
{
    EXPECT_THROW(SpectrumEstimate(2, 15), std::invalid_argument);
    EXPECT_THROW(SpectrumEstimate(2, 0), std::invalid_argument);
    EXPECT_THROW(SpectrumEstimate(4, 16), std::invalid_argument);
    EXPECT_THROW(SpectrumEstimate(2, 16).mean(), std::logic_error);
}

/// Mean and sample variance of the power over the frequencies that are distinct up to sign: u > 0, or u = 0
/// and v > 0.
struct Moments
{
    double mean = 0, variance = 0;
    int samples = 0;
};

Moments half_plane_moments(const Spectrum& spectrum)
{
    Moments result;
    const int half = spectrum.size / 2;
    double sum = 0, squares = 0;
    for (int v = 1 - half; v < half; ++v) {
        for (int u = 0; u < half; ++u) {
            if (u == 0 && v <= 0) continue;
            sum += spectrum.at(u, v);
            squares += spectrum.at(u, v) * spectrum.at(u, v);
            ++result.samples;
        }
    }
    result.mean = sum / result.samples;
    result.variance = (squares - sum * result.mean) / (result.samples - 1);
    return result;
}

TEST(SpectrumEstimate, OfUniformPointsIsWhite)
{
    // For N independent uniform points and f != 0: E P = 1 and var P = 1 - 1/N exactly, and P(f), P(g) are
    // uncorrelated unless f = +-g. The mean of K periodograms is close to a gamma variable of shape K, whose
    // variance is 1/K, skewness 2/sqrt K and kurtosis 3 + 6/K.
    constexpr int realizations = 10;
    constexpr std::size_t points = 4096;
    std::mt19937_64 random(4);
    SpectrumEstimate estimate(2, 256);
    for (int i = 0; i < realizations; ++i) estimate.add(random_points(points, 2, random));
    const Spectrum spectrum = estimate.mean();

    // 238 comparisons at 4.5 standard errors each, 7e-6 on both sides: the seed fails a correct program with
    // probability 0.002.
    const Moments moments = half_plane_moments(spectrum);
    const double k = realizations, n = moments.samples;
    EXPECT_NEAR(moments.mean, 1.0, 4.5 * std::sqrt(1.0 / (k * n)));
    EXPECT_NEAR(moments.variance, 1.0 / k, 1.0 / (k * points) + 4.5 / k * std::sqrt((2.0 + 6.0 / k) / n));

    // Each bin holds n' = samples / 2 independent values. The logarithm of s^2 / mean^2 has variance
    // (kurtosis - 1 + 4/K - 8/K) / n' = (2 + 2/K) / n'. Counting every value twice lowers s^2 by 1/(2 n').
    const double decibel = 10.0 / std::log(10.0);
    int checked = 0;
    for (const RadialBin& bin : radial_statistics(spectrum)) {
        if (bin.frequency < 10) continue; // too few samples for a normal approximation
        const double independent = 0.5 * static_cast<double>(bin.samples);
        EXPECT_NEAR(bin.power, 1.0, 4.5 * std::sqrt(1.0 / (k * independent))) << bin.frequency;
        EXPECT_NEAR(bin.anisotropy_db, background_anisotropy_db(realizations),
                    decibel * (0.5 / independent + 4.5 * std::sqrt((2.0 + 2.0 / k) / independent)))
            << bin.frequency;
        ++checked;
    }
    EXPECT_EQ(checked, 118);
}

/// The reciprocal lattice of the cubic lattice of n^3 points: power N at multiples of n, nothing elsewhere.
TEST(SpectrumEstimate, OfACubicLatticeIsItsReciprocalLattice)
{
    constexpr int n = 6;
    constexpr int half = 16;
    SpectrumEstimate estimate(3, 2 * half);
    estimate.add(square_lattice(n, 3));
    const Spectrum spectrum = estimate.mean();
    // Transform values are within 1e-8 N, powers within twice that.
    constexpr double error = 2e-8 * n * n * n;
    std::size_t at = 0;
    for (int w = -half; w < half; ++w)
        for (int v = -half; v < half; ++v)
            for (int u = -half; u < half; ++u, ++at) {
                const bool peak = u % n == 0 && v % n == 0 && w % n == 0;
                ASSERT_NEAR(spectrum.power[at], peak ? n * n * n : 0, error) << u << ' ' << v << ' ' << w;
            }

    // Shells: (6, 0, 0) in shell 6, (6, 6, 0) in round(8.49), (6, 6, 6) in round(10.39), (12, 0, 0) in 12,
    // (12, 6, 0) in round(13.4), (12, 6, 6) in round(14.7) alone.
    const std::vector<std::pair<int, int>> peaks = {{6, 6}, {8, 12}, {10, 8}, {12, 6}, {13, 24}, {15, 24}};
    for (const RadialBin& bin : radial_statistics(spectrum)) {
        double expected = 0;
        for (const auto& [shell, count] : peaks)
            if (bin.frequency == shell) expected = count * n * n * n / static_cast<double>(bin.samples);
        EXPECT_NEAR(bin.power, expected, error) << bin.frequency;
    }
}

TEST(SpectrumEstimate, OfUniformPointsInACubeIsWhite)
{
    // The bound is that of OfUniformPointsIsWhite: each shell of n' = samples / 2 independent values of variance 1/K.
    // 20 + 20 comparisons at 4.5 standard errors: the seed fails a correct program with probability 3e-4.
    constexpr int realizations = 6;
    std::mt19937_64 random(5);
    SpectrumEstimate estimate(3, 48);
    for (int i = 0; i < realizations; ++i) estimate.add(random_points(2048, 3, random));
    const double k = realizations;
    const double decibel = 10.0 / std::log(10.0);
    int checked = 0;
    for (const RadialBin& bin : radial_statistics(estimate.mean())) {
        if (bin.frequency < 4) continue; // too few samples for a normal approximation
        const double independent = 0.5 * static_cast<double>(bin.samples);
        EXPECT_NEAR(bin.power, 1.0, 4.5 * std::sqrt(1.0 / (k * independent))) << bin.frequency;
        EXPECT_NEAR(bin.anisotropy_db, background_anisotropy_db(realizations),
                    decibel * (0.5 / independent + 4.5 * std::sqrt((2.0 + 2.0 / k) / independent)))
            << bin.frequency;
        ++checked;
    }
    EXPECT_EQ(checked, 20);
}

}
}
