#include "analysis/measures/low_frequency_power.hpp"

#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

using namespace test;

template <class Power>
std::vector<RadialBin> radial_of(int count, const Power& power)
{
    std::vector<RadialBin> radial;
    for (int k = 1; k <= count; ++k) {
        radial.push_back({static_cast<double>(k), power(static_cast<double>(k)), 0, static_cast<std::size_t>(6 * k)});
    }
    return radial;
}

TEST(LowFrequencyPower, RecoversPowerLaws)
{
    for (const double b : {-1.0, 0.0, 1.0, 2.0, 4.0}) {
        const auto fit = low_frequency_power(radial_of(40, [&](double f) { return 0.3 * std::pow(f, b); }), {3, 25});
        ASSERT_TRUE(fit);
        EXPECT_NEAR(fit->exponent, b, 1e-12);
        EXPECT_NEAR(fit->exponent_standard_error, 0, 1e-12);
        EXPECT_EQ(fit->begin, 3);
        EXPECT_EQ(fit->end, 25);
        EXPECT_EQ(fit->bins, 23u);
    }
}

TEST(LowFrequencyPower, RecoversTheInterceptOfAParabola)
{
    const auto fit = low_frequency_power(radial_of(40, [](double f) { return 0.07 + 1e-3 * f * f; }), {1, 30});
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->intercept, 0.07, 1e-14);
    EXPECT_NEAR(fit->intercept_standard_error, 0, 1e-14);
}

TEST(LowFrequencyPower, HasTheStandardErrorsOfItsFits)
{
    // Gaussian noise of the variance that the weights assume, 2/(K n) with n = 6 k and K = 10, once on ln P
    // and once on P: the fits have no bias, and squares of standard errors no bias as variances.
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::vector<double> exponents, exponent_variances, intercepts, intercept_variances;
    for (int i = 0; i < 2000; ++i) {
        const auto noise = [&](double f) { return normal(random) * std::sqrt(2 / (10 * 6 * f)); };
        const auto law = radial_of(20, [&](double f) { return 0.01 * f * f * std::exp(noise(f)); });
        const auto parabola = radial_of(20, [&](double f) { return 5 + 0.02 * f * f + noise(f); });
        const auto power = low_frequency_power(law, {2, 8});
        exponents.push_back(power->exponent);
        exponent_variances.push_back(std::pow(power->exponent_standard_error, 2));
        const auto flat = low_frequency_power(parabola, {2, 8});
        intercepts.push_back(flat->intercept);
        intercept_variances.push_back(std::pow(flat->intercept_standard_error, 2));
    }
    const double bound = z_bound(4);
    const auto check = [&](const std::vector<double>& values, double expected, const std::vector<double>& variances) {
        const Mean mean = mean_of(values);
        EXPECT_LT(std::abs(mean.value - expected), bound * mean.standard_error);
        std::vector<double> squares;
        for (const double v : values) squares.push_back((v - expected) * (v - expected));
        EXPECT_LT(std::abs(z_score(mean_of(squares), mean_of(variances))), bound);
    };
    check(exponents, 2, exponent_variances);
    check(intercepts, 5, intercept_variances);
}

TEST(LowFrequencyPower, WeighsBinsByTheirSamples)
{
    // A bin without weight to speak of changes nothing: 1e6 samples a bin, but one in the outlier's.
    auto radial = radial_of(10, [](double f) { return f * f; });
    for (RadialBin& bin : radial) bin.samples = 1'000'000;
    radial[4] = {5, 1e3, 0, 1};
    const auto fit = low_frequency_power(radial, {1, 10});
    EXPECT_NEAR(fit->exponent, 2, 1e-5);
    EXPECT_NEAR(fit->intercept, 0, 1e-3);
}

TEST(MeanPowerInARange, IsThatOfItsFrequencies)
{
    // 6 k samples of power k: sums of squares over sums, (n + 1)(2 n + 1) / 3 over n + 1 for k = 1 .. n.
    const auto radial = radial_of(40, [](double f) { return f; });
    EXPECT_NEAR(*mean_power_in(radial, {1, 10}), 7, 1e-12);
    EXPECT_NEAR(*mean_power_in(radial, {0, 25.5}), 17, 1e-12);
    EXPECT_EQ(*mean_power_in(radial, {7, 7}), 7);
    EXPECT_FALSE(mean_power_in(radial, {41, 100}));
}

TEST(LowFrequencyPower, OfTooFewBinsIsNothing)
{
    const auto radial = radial_of(40, [](double f) { return f; });
    EXPECT_FALSE(low_frequency_power(radial, {1, 2}));
    EXPECT_TRUE(low_frequency_power(radial, {1, 3}));
    EXPECT_FALSE(low_frequency_power(radial, {41, 100}));
    EXPECT_FALSE(low_frequency_power({}, {1, 100}));
    EXPECT_FALSE(low_frequency_power(radial_of(40, [](double) { return 0.0; }), {1, 40}));
    // The usual range of 256 points ends at 4, of 4,096 in 3D too; that of 16 points at 1.
    EXPECT_EQ(low_frequency_power(radial, low_frequency_range(256, 2))->end, 4);
    EXPECT_EQ(low_frequency_power(radial, low_frequency_range(4096, 3))->end, 4);
    EXPECT_FALSE(low_frequency_power(radial, low_frequency_range(16, 2)));
}

}
}
