#include "analysis/measures/peak_anisotropy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

TEST(PeakAnisotropy, IsTheLargestOfRingsWithEnoughSamples)
{
    const std::vector<RadialBin> radial = {{15, 1, 3.0, 96, 0},
                                           {16, 1, -9.0, 100, 0},
                                           {17, 1, -4.0, 108, 0},
                                           {18, 1, -4.0, 112, 0},
                                           {19, 1, -8.0, 120, 0}};
    const auto peak = peak_anisotropy(radial);
    ASSERT_TRUE(peak);
    EXPECT_EQ(peak->db, -4);
    EXPECT_EQ(peak->frequency, 17) << "the first of several";
    EXPECT_EQ(peak->samples, 108U);
    EXPECT_FALSE(peak->standard_error_db);
    EXPECT_FALSE(peak_anisotropy({radial[0]}));
    EXPECT_FALSE(peak_anisotropy({}));
}

/// Of two normal deviates of one deviation, the largest has the variance 1 - 1 / pi (Clark, The greatest of a finite
/// set of random variables, Operations Research 9(2), 1961), of three 1 + sqrt 3 / (2 pi) - 9 / (4 pi), of one 1.
TEST(PeakAnisotropy, OfChanceHasTheErrorOfTheLargestDeviate)
{
    using std::numbers::pi;
    const std::array<double, 3> variances{1, 1 - 1 / pi, 1 + std::sqrt(3) / (2 * pi) - 9 / (4 * pi)};
    const double one = anisotropy_standard_error_db(200, 10);
    for (std::size_t rings = 1; rings <= 3; ++rings) {
        const std::vector<RadialBin> radial(rings, {30, 1, -10.1, 200, 0});
        const double error = peak_anisotropy_error_db(radial, peak_anisotropy(radial).value(), {2, 64, 100, 10, {}});
        EXPECT_NEAR(error, one * std::sqrt(variances[rings - 1]), 1e-4 * one) << rings;
    }
}

/// The mean of powers of chance, exponential at every frequency, with four strong ones in the ring of radius 20.
Spectrum spectrum_with_peaks(double strength, int realizations, std::mt19937_64& random)
{
    constexpr int size = 64;
    RunningMoments moments;
    std::exponential_distribution<double> exponential;
    for (int k = 0; k < realizations; ++k) {
        std::vector<double> power(size * size);
        for (int v = -31; v < 32; ++v)
            for (int u = -31; u < 32; ++u) {
                if (v < 0 || (v == 0 && u <= 0)) continue; // of f and -f, one
                const bool is_peak = (u == 20 && v == 0) || (u == 0 && v == 20);
                const double value = exponential(random) * (is_peak ? strength : 1);
                for (const int sign : {-1, 1})
                    power[static_cast<std::size_t>((sign * v + 32) * size + sign * u + 32)] = value;
            }
        moments.add(power);
    }
    Spectrum mean{2, size, 100, realizations, {moments.mean().begin(), moments.mean().end()}};
    for (const double square : moments.squares()) mean.variance.push_back(square / (realizations - 1));
    return mean;
}

/// Divides the error that is claimed for peaks of spectrum_with_peaks() by the scatter that 400 of them have.
double claimed_over_scatter(double strength, int realizations)
{
    constexpr int trials = 400;
    std::mt19937_64 random(11);
    double claimed = 0, sum = 0, squares = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const Spectrum mean = spectrum_with_peaks(strength, realizations, random);
        const auto radial = radial_statistics(mean);
        const PeakAnisotropy peak = peak_anisotropy(radial).value();
        EXPECT_EQ(peak.frequency, 20);
        const double error = peak_anisotropy_error_db(radial, peak, mean);
        claimed += error * error / trials;
        sum += peak.db / trials;
        squares += peak.db * peak.db / trials;
    }
    return std::sqrt(claimed / (squares - sum * sum));
}

/// A variance of 400 values is known to 7 %, the claims to less; logarithms of powers of ten realizations vary by some
/// tenth more than two orders of the delta method say. The slopes alone claim 1.3 times the scatter where few equal
/// powers outweigh their ring.
TEST(PeakAnisotropy, OfALatticeHasTheErrorOfItsPeaks)
{
    EXPECT_NEAR(claimed_over_scatter(50, 10), 1, 0.2) << "beside others of chance";
    EXPECT_NEAR(claimed_over_scatter(5000, 10), 1, 0.2) << "the ring has no other power to speak of";
    EXPECT_NEAR(claimed_over_scatter(50, 20), 1, 0.15);
}

/// Rings of the mean of K independent exponential powers at every frequency, whose mean goes as `power` of the
/// frequency and is multiplied by `factor` in one half of the directions.
std::vector<RadialBin> rings_of_chance(int size, int realizations, const std::function<double(double)>& power,
                                       double factor, std::mt19937_64& random)
{
    std::gamma_distribution<double> gamma(realizations, 1.0 / realizations);
    const int half = size / 2;
    Spectrum spectrum;
    spectrum.size = size;
    spectrum.realizations = realizations;
    spectrum.power.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 1.0);
    const auto at = [&](int u, int v) -> double& {
        return spectrum.power[static_cast<std::size_t>((v + half) * size + u + half)];
    };
    for (int v = 0; v < half; ++v)
        for (int u = -half + 1; u < half; ++u) {
            if (v == 0 && u <= 0) continue;
            const double mean = power(std::hypot(u, v)) * (std::abs(u) > v ? factor : 1);
            at(u, v) = at(-u, -v) = mean * gamma(random);
        }
    return radial_statistics(spectrum);
}

TEST(AnisotropyAboveChance, IsNoneOfIsotropicSets)
{
    // An alarm in a thousand is allowed: of 1,600 spectra more than six come with a probability of 4e-3 in all.
    std::mt19937_64 random(5);
    int alarms = 0;
    for (const int realizations : {1, 2, 4, 10})
        for (int i = 0; i < 200; ++i) {
            const auto flat = rings_of_chance(
                96, realizations, [](double) { return 1.0; }, 1, random);
            // This spectrum is as steep as that of Gaussian blue noise of few points: three times the power from ring
            // to ring, from next to none.
            const auto steep = rings_of_chance(
                96, realizations, [](double f) { return std::min(1.0, 1e-4 * std::pow(3.0, (f - 18) / 1.5)); }, 1,
                random);
            for (const auto& rings : {flat, steep}) alarms += *anisotropy_above_chance_db(rings, realizations) > 0;
        }
    EXPECT_LE(alarms, 6);
}

TEST(AnisotropyAboveChance, IsThatOfTheRingsThatStandOut)
{
    // Half of the frequencies have twice the power of the others: a ratio of 1/9 beside the chance of
    // (1 + 1/9) / K, which is 3 dB at K = 9.
    std::mt19937_64 random(6);
    const auto rings = rings_of_chance(
        256, 9, [](double) { return 1.0; }, 2, random);
    const double above = *anisotropy_above_chance_db(rings, 9);
    EXPECT_GT(above, 3.0);
    EXPECT_LT(above, 5.5) << "the largest of some hundred rings";
}

TEST(AnisotropyAboveChance, LeavesOutRingsWithoutPowerOrSamples)
{
    const auto rings_with = [](double power, std::size_t samples) {
        return std::vector<RadialBin>{
            {15, power, -10, samples, 0}, {16, power, 30, samples, 0}, {17, power, -10, samples, 0}};
    };
    EXPECT_GT(anisotropy_above_chance_db(rings_with(0.01, 100), 10).value(), 39);
    EXPECT_FALSE(anisotropy_above_chance_db(rings_with(0.009, 100), 10));
    EXPECT_FALSE(anisotropy_above_chance_db(rings_with(1, 99), 10));
    EXPECT_FALSE(anisotropy_above_chance_db({}, 10));
    EXPECT_FALSE(peak_anisotropy(rings_with(0.009, 100)));
}

TEST(PeakAnisotropy, ErrorIsTheSpreadOfRingsOfChance)
{
    // 5,000 independent powers in a ring: terms beyond the delta method are of the order 1/5,000. A variance over 2,000
    // rings has the relative standard error sqrt(2 / 2,000).
    constexpr int rings = 2000, independent = 5000;
    std::mt19937_64 random(7);
    for (const int realizations : {1, 4, 10}) {
        std::gamma_distribution<double> gamma(realizations, 1.0 / realizations);
        double sum = 0, squares = 0;
        for (int ring = 0; ring < rings; ++ring) {
            double powers = 0, squared = 0;
            for (int i = 0; i < independent; ++i) {
                const double power = gamma(random);
                powers += power / independent;
                squared += power * power / independent;
            }
            const double db = 10 * std::log10((squared - powers * powers) / (powers * powers));
            sum += db / rings;
            squares += db * db / rings;
        }
        const double expected = anisotropy_standard_error_db(2 * independent, realizations);
        EXPECT_NEAR((squares - sum * sum) / (expected * expected), 1, 4 * std::sqrt(2.0 / rings) + 0.01)
            << realizations;
    }
}

}
}
