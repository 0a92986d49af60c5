#include "analysis/spectra/radial_statistics.hpp"

#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using namespace test;

Spectrum spectrum_of(int dimension, int size, double power)
{
    const auto m = static_cast<std::size_t>(size);
    return {dimension, size, 1, 1, std::vector<double>(dimension == 3 ? m * m * m : m * m, power)};
}

/// The samples of bin k by the definition, in long double: 1/2 + (k - 1) w < |f| <= 1/2 + k w.
std::vector<double> samples_of_bin(const Spectrum& spectrum, int k, long double width)
{
    std::vector<double> samples;
    const int half = spectrum.size / 2, slices = spectrum.dimension == 3 ? half : 0;
    std::size_t at = 0;
    for (int w = -slices; w < std::max(slices, 1); ++w) {
        for (int v = -half; v < half; ++v) {
            for (int u = -half; u < half; ++u, ++at) {
                const auto squared = static_cast<long double>(u * u + v * v + w * w);
                const long double bin = std::ceil((std::sqrt(squared) - 0.5L) / width);
                if (bin == k) samples.push_back(spectrum.power[at]);
            }
        }
    }
    return samples;
}

TEST(RadialStatistics, CountsTheSamplesOfTheFirstBins)
{
    // 2D: |f|^2 = 1, 2 | 4, 5 | 8, 9, 10 with 4 + 4, 4 + 8, 4 + 4 + 8 samples. 3D: 1, 2 | 3 to 6: 6 + 12, 8 +
    // 6 + 24 + 24.
    const auto plane = radial_statistics(spectrum_of(2, 8, 1.0));
    ASSERT_EQ(plane.size(), 3u);
    EXPECT_EQ(plane[0].samples, 8u);
    EXPECT_EQ(plane[1].samples, 12u);
    EXPECT_EQ(plane[2].samples, 16u);
    const auto volume = radial_statistics(spectrum_of(3, 6, 1.0));
    ASSERT_EQ(volume.size(), 2u);
    EXPECT_EQ(volume[0].samples, 18u);
    EXPECT_EQ(volume[1].samples, 62u);
}

TEST(RadialStatistics, AgreesWithTheDefinition)
{
    std::mt19937_64 random(1);
    for (const int dimension : {2, 3}) {
        Spectrum spectrum = spectrum_of(dimension, dimension == 2 ? 100 : 22, 0.0);
        for (double& power : spectrum.power) power = uniform(random);
        for (const double width : {1.0, 1.25, 2.0, 3.7}) {
            const auto radial = radial_statistics(spectrum, width);
            ASSERT_EQ(radial.size(), std::floor((spectrum.size / 2 - 1) / width)) << "none reaches beyond the border";
            for (int k = 1; k <= static_cast<int>(radial.size()); ++k) {
                const RadialBin& bin = radial[static_cast<std::size_t>(k - 1)];
                const auto samples = samples_of_bin(spectrum, k, width);
                const auto n = static_cast<double>(samples.size());
                double sum = 0, squares = 0;
                for (const double p : samples) sum += p;
                for (const double p : samples) squares += (p - sum / n) * (p - sum / n);
                const double ratio = squares / (n - 1) / (sum / n * (sum / n));
                EXPECT_DOUBLE_EQ(bin.frequency, 0.5 + (k - 0.5) * width) << "the middle";
                EXPECT_EQ(bin.samples, samples.size());
                EXPECT_NEAR(bin.power, sum / n, 1e-15 * n); // n additions of values below 1, relative 2^-53 each
                EXPECT_NEAR(bin.anisotropy_db, 10.0 * std::log10(ratio), 4.4 * 4e-15 * n);
            }
        }
    }
}

TEST(RadialStatistics, LeavesOutDcAndTheBorder)
{
    Spectrum spectrum = spectrum_of(2, 16, 1.0);
    spectrum.power[8 * 16 + 8] = 1e6;                                                      // f = 0
    for (std::size_t i = 0; i < 16; ++i) spectrum.power[i] = spectrum.power[i * 16] = 1e6; // f_x or f_y = -8
    const auto radial = radial_statistics(spectrum);
    ASSERT_EQ(radial.size(), 7u);
    for (const RadialBin& bin : radial) EXPECT_EQ(bin.power, 1.0);
}

TEST(RadialStatistics, HasFiniteValuesWithoutVariationAndWithoutPower)
{
    for (const double power : {1.0, 3e-7, 0.0}) {
        for (const RadialBin& bin : radial_statistics(spectrum_of(2, 32, power))) {
            // A constant's mean of n < 100 samples is off by at most n 2^-53, and variance / mean^2 by the
            // square of that: below -279 dB, which the floor hides.
            EXPECT_NEAR(bin.power, power, 1e-13 * power);
            EXPECT_EQ(bin.anisotropy_db, least_anisotropy_db);
        }
    }
    EXPECT_TRUE(radial_statistics(spectrum_of(2, 2, 1.0)).empty());
}

TEST(RadialStatistics, TakesTheRoundingOfALatticesZerosForZeros)
{
    // 16 x 16 points: all power is at multiples of 16, so of the first 31 bins bins 16 and 23 (16 sqrt 2)
    // alone have any.
    const Spectrum spectrum{2, 64, 256, 1, exact_periodogram(square_lattice(16, 2), 64)};
    for (const RadialBin& bin : radial_statistics(spectrum)) {
        const bool has_power = bin.frequency == 16 || bin.frequency == 23;
        EXPECT_EQ(bin.anisotropy_db > least_anisotropy_db, has_power) << bin.frequency;
    }
}

TEST(RadialStatistics, SampleVarianceHasDivisorNMinusOne)
{
    // Bin 1 of 8 samples: four 0, four 2. Mean 1, variance 8/7.
    Spectrum spectrum = spectrum_of(2, 4, 0.0);
    for (const auto& [u, v] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        spectrum.power[static_cast<std::size_t>((v + 2) * 4 + u + 2)] = 2.0;
    }
    const auto radial = radial_statistics(spectrum);
    EXPECT_EQ(radial[0].power, 1.0);
    EXPECT_NEAR(radial[0].anisotropy_db, 10.0 * std::log10(8.0 / 7.0), 1e-14);
}

TEST(BackgroundAnisotropy, IsMinusTenDecibelForTenRealizations)
{
    EXPECT_DOUBLE_EQ(background_anisotropy_db(10), -10.0);
    EXPECT_DOUBLE_EQ(background_anisotropy_db(1), 0.0);
}

}
}
