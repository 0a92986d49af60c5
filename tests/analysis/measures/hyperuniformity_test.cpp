// The exponent and the test at the lowest frequencies, against scipy's likelihoods, simulated powers whose law is
// known, and point sets with closed forms.
#include "analysis/measures/hyperuniformity.hpp"

#include "tests/support/point_patterns.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using namespace test;

constexpr double nothing = 1e-20;

/// The shells of the plane with |f| <= 6, with powers that a function of |f|^2 and the shell's number gives.
template <class Power>
std::vector<PowerShell> shells_up_to_6(const Power& power)
{
    std::vector<PowerShell> shells;
    for (int squared = 1; squared <= 36; ++squared) {
        std::size_t frequencies = 0;
        for (int v = -6; v <= 6; ++v)
            for (int u = -6; u <= 6; ++u) frequencies += u * u + v * v == squared;
        if (frequencies > 0)
            shells.push_back({std::sqrt(squared), power(squared, static_cast<double>(shells.size())), frequencies / 2});
    }
    return shells;
}

std::vector<PowerShell> bent_shells()
{
    return shells_up_to_6([](double squared, double i) { return 0.03 + 0.002 * squared * (1 + 0.5 * std::cos(i)); });
}

/// Powers of K averaged periodograms whose mean is that of `shells`.
std::vector<PowerShell> drawn(std::vector<PowerShell> shells, int realizations, std::mt19937_64& random)
{
    for (PowerShell& shell : shells) {
        const double shape = realizations * static_cast<double>(shell.pairs);
        shell.power *= std::gamma_distribution<double>(shape, 1 / shape)(random);
    }
    return shells;
}

/// A point drawn in each of m x m cells, whose power is 1 - (sinc u sinc v)^2 at frequencies m (u, v).
PointSet jittered(int m, std::mt19937_64& random)
{
    PointSet points{2, {}};
    for (int y = 0; y < m; ++y)
        for (int x = 0; x < m; ++x) {
            points.coordinates.push_back((x + uniform(random)) / m);
            points.coordinates.push_back((y + uniform(random)) / m);
        }
    return points;
}

Spectrum spectrum_of(const PointSet& points, int size)
{
    return {points.dimension, size, points.size(), 1, exact_periodogram(points, size)};
}

std::optional<double> p_value_of(const PointSet& points)
{
    const FrequencyRange range = hyperuniformity_test_range(points.size(), points.dimension, 0);
    const Spectrum spectrum = spectrum_of(points, 2 * static_cast<int>(range.end) + 4);
    return hyperuniformity_p_value(power_shells(spectrum, range), 1, nothing);
}

TEST(PowerShells, AreMeansOfDirectSums)
{
    std::mt19937_64 random(1);
    for (const int dimension : {2, 3}) {
        const PointSet points = random_points(60, dimension, random);
        const Spectrum spectrum = spectrum_of(points, 12);
        const auto shells = power_shells(spectrum, {1.2, 4.5});
        const auto of_half = power_shells(half_of(spectrum.power, dimension, 12), {1.2, 4.5});
        ASSERT_FALSE(shells.empty());
        ASSERT_EQ(of_half.size(), shells.size());
        for (std::size_t i = 0; i < shells.size(); ++i) {
            EXPECT_EQ(of_half[i].pairs, shells[i].pairs);
            EXPECT_NEAR(of_half[i].power, shells[i].power, 1e-9);
        }
        EXPECT_EQ(shells.front().frequency, std::sqrt(2.0));
        EXPECT_LE(shells.back().frequency, 4.5);
        for (const PowerShell& shell : shells) {
            double power = 0;
            std::size_t count = 0;
            const int slices = dimension == 3 ? 5 : 0;
            for (int w = -slices; w <= slices; ++w)
                for (int v = -5; v <= 5; ++v)
                    for (int u = -5; u <= 5; ++u) {
                        if (std::sqrt(u * u + v * v + w * w) != shell.frequency) continue;
                        std::complex<double> sum = 0;
                        for (std::size_t i = 0; i < points.size(); ++i) {
                            const auto x = points[i];
                            const double turns = u * x[0] + v * x[1] + (dimension == 3 ? w * x[2] : 0);
                            sum += std::polar(1.0, -2 * std::numbers::pi * turns);
                        }
                        power += std::norm(sum) / 60;
                        ++count;
                    }
            EXPECT_EQ(2 * shell.pairs, count) << shell.frequency;
            EXPECT_NEAR(shell.power, power / static_cast<double>(count), 1e-9) << shell.frequency;
        }
    }
}

TEST(PowerShells, OfHalfASpectrumAreThoseOfAll)
{
    std::mt19937_64 random(8);
    for (const int dimension : {2, 3}) {
        const Spectrum whole = spectrum_of(random_points(60, dimension, random), 12);
        const auto a = power_shells(whole, {1, 4.5});
        const auto b = power_shells(half_of(whole.power, dimension, 12), {1, 4.5});
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i].power, b[i].power, 1e-9 * a[i].power);
    }
}

TEST(HyperuniformRange, EndsBelowTheTilesFrequency)
{
    EXPECT_EQ(hyperuniform_range(10'000, 2, 0).end, low_frequency_range(10'000, 2).end);
    EXPECT_EQ(hyperuniform_range(10'000, 2, 20).end, 8);
    EXPECT_EQ(hyperuniform_range(10'000, 2, 200).end, low_frequency_range(10'000, 2).end);
    EXPECT_EQ(hyperuniformity_test_range(1'000'000, 2, 0).end, 16);
    EXPECT_EQ(hyperuniformity_test_range(1'000'000, 3, 0).end, 6);
    EXPECT_EQ(hyperuniformity_test_range(1'000'000, 3, 10).end, 2);
}

TEST(HyperuniformityExponent, IsThatOfPowerLaws)
{
    for (const double b : {-1.0, 0.0, 1.0, 2.0, 4.0, 6.0, 8.0}) {
        const auto shells = shells_up_to_6([&](double squared, double) { return 1e-7 * std::pow(squared, b / 2); });
        const auto exponent = hyperuniformity_exponent(shells, 1, nothing);
        ASSERT_TRUE(exponent);
        EXPECT_NEAR(exponent->value, b, 1e-10);
    }
}

TEST(HyperuniformityExponent, IsThatOfScipysLikelihood)
{
    // The root of the likelihood's slope by scipy.optimize.brentq in numpy, and its information.
    const auto exponent = hyperuniformity_exponent(bent_shells(), 3, nothing);
    ASSERT_TRUE(exponent);
    EXPECT_NEAR(exponent->value, 0.704400984369094, 1e-12);
    EXPECT_NEAR(exponent->standard_error, 0.1757601085, 1e-8);
}

TEST(HyperuniformityExponent, HasNoBiasAndItsStandardError)
{
    std::mt19937_64 random(2);
    const auto law = shells_up_to_6([](double squared, double) { return 1e-5 * squared * squared; });
    std::vector<double> values, variances, squares;
    for (int i = 0; i < 2000; ++i) {
        const auto exponent = hyperuniformity_exponent(drawn(law, 2, random), 2, nothing);
        values.push_back(exponent->value);
        squares.push_back((exponent->value - 4) * (exponent->value - 4));
    }
    const double expected = 0.1757601085 * std::sqrt(1.5); // information is proportional to K, 3 above
    const Mean mean = mean_of(values);
    EXPECT_LT(std::abs(mean.value - 4), z_bound(2) * mean.standard_error);
    const Mean variance = mean_of(squares);
    EXPECT_LT(std::abs(variance.value - expected * expected), z_bound(2) * variance.standard_error);
}

TEST(HyperuniformityExponent, GrowsItsErrorWherePowersScatterMoreThanChance)
{
    const auto alike = shells_up_to_6([](double squared, double) { return squared; });
    const auto scattered =
        shells_up_to_6([](double squared, double i) { return squared * (static_cast<int>(i) % 2 == 0 ? 0.5 : 1.5); });
    EXPECT_GT(hyperuniformity_exponent(scattered, 100, nothing)->standard_error,
              3 * hyperuniformity_exponent(alike, 100, nothing)->standard_error);
}

/// A steep curve that ends in rounding keeps its slope: of f^6 with chance, all below 3 lost.
TEST(HyperuniformityExponent, LeavesOutWhereRoundingBegins)
{
    const auto shells =
        shells_up_to_6([](double squared, double) { return squared < 9 ? 1e-16 : 1e-12 * std::pow(squared, 3); });
    const auto exponent = hyperuniformity_exponent(shells, 10, 1e-10);
    ASSERT_TRUE(exponent);
    EXPECT_NEAR(exponent->value, 6, 1e-6);
    std::mt19937_64 random(7);
    const auto noisy = hyperuniformity_exponent(drawn(shells, 10, random), 10, 1e-10);
    ASSERT_TRUE(noisy);
    EXPECT_NEAR(noisy->value, 6, 4 * noisy->standard_error);
}

TEST(HyperuniformityExponent, NeedsPower)
{
    const auto none = shells_up_to_6([](double, double) { return 1e-25; });
    EXPECT_FALSE(hyperuniformity_exponent(none, 1, nothing));
    EXPECT_FALSE(hyperuniformity_p_value(none, 1, nothing));
    EXPECT_FALSE(hyperuniformity_exponent({{1, 1, 2}, {std::sqrt(2.0), 2, 2}}, 1, nothing));
    EXPECT_FALSE(hyperuniformity_exponent({}, 1, nothing));
}

TEST(HyperuniformityTest, HasScipysLikelihoodRatio)
{
    // The largest likelihood for each c is at some s / t; the next of the list is at most half a step, ln 1.44 / 2,
    // away, and the logarithm of a model changes by no more than that: T is too small by 168 / 4 (ln 1.44 / 2)^2 at
    // most, where 168 samples weigh.
    constexpr double largest = 51.460769757068;
    const double found = hyperuniformity_statistic(bent_shells(), 3);
    EXPECT_LE(found, largest + 1e-9);
    EXPECT_GT(found, largest - 1.4);
    const auto concave = shells_up_to_6([](double squared, double) { return 1 - std::exp(-0.05 * squared); });
    const double of_concave = hyperuniformity_statistic(concave, 3);
    EXPECT_LE(of_concave, 0.529931984112 + 1e-9);
    EXPECT_GE(of_concave, 0);
    const auto steep = shells_up_to_6([](double squared, double) { return squared * squared; });
    EXPECT_EQ(hyperuniformity_statistic(steep, 3), 0);
}

/// The shares of ensembles of a law that are rejected at 5 %, and at 30 %.
std::array<double, 2> rejected_shares(const std::vector<PowerShell>& law, int realizations, int ensembles,
                                      std::mt19937_64& random)
{
    std::array<double, 2> rejected{};
    for (int i = 0; i < ensembles; ++i) {
        const double p = hyperuniformity_p_value(drawn(law, realizations, random), realizations, nothing).value();
        rejected[0] += (p <= 0.05) / static_cast<double>(ensembles);
        rejected[1] += (p <= 0.3) / static_cast<double>(ensembles);
    }
    return rejected;
}

/// Grids displaced by normal deviates of a quarter of a step to a whole one have the power 1 - exp(-(2 pi a f / s)^2);
/// the range of 6 is that of s = 48 points along an axis. Their curves bend, and more realizations see it better.
TEST(HyperuniformityTest, RejectsHyperuniformPowersAtItsLevelAtMost)
{
    std::mt19937_64 random(3);
    constexpr int ensembles = 40;
    for (const int realizations : {1, 10, 40})
        for (const double a : {0.0, 0.25, 0.5, 1.0}) {
            const auto law = shells_up_to_6([&](double squared, double) {
                return a == 0 ? 1e-3 * squared : -std::expm1(-std::pow(2 * std::numbers::pi * a / 48, 2) * squared);
            });
            const auto [at_5, at_30] = rejected_shares(law, realizations, ensembles, random);
            const auto bound = [](double level) {
                return level + z_bound(24) * std::sqrt(level * (1 - level) / ensembles);
            };
            EXPECT_LT(at_5, bound(0.05)) << realizations << ' ' << a;
            EXPECT_LT(at_30, bound(0.3)) << realizations << ' ' << a;
        }
}

/// Ensembles of ten that are not hyperuniform, as saturated dart throwing and relaxed sets: all are found.
TEST(HyperuniformityTest, FindsWhatIsLeftAtZero)
{
    std::mt19937_64 random(6);
    for (const auto& [left, slope] : {std::pair{0.06, 0.5}, {0.005, 0.3}, {1.0, 0.0}}) {
        const auto law = shells_up_to_6([&](double squared, double) { return left + slope * squared / (48 * 48); });
        EXPECT_NEAR(rejected_shares(law, 10, 20, random)[0], 1, 1e-9) << left;
        EXPECT_GT(rejected_shares(law, 1, 30, random)[0], 0.65) << left;
    }
}

TEST(HyperuniformityTest, TellsJitteredFromRandomPoints)
{
    std::mt19937_64 random(4);
    constexpr int sets = 80;
    int jittered_rejected = 0;
    for (int i = 0; i < sets; ++i) jittered_rejected += p_value_of(jittered(64, random)).value() <= 0.05;
    EXPECT_LT(jittered_rejected - 0.05 * sets, z_bound(1) * std::sqrt(0.05 * 0.95 * sets));
    for (int i = 0; i < 5; ++i) {
        EXPECT_LE(p_value_of(random_points(4096, 2, random)).value(), 1e-3);
        EXPECT_LE(p_value_of(random_points(32'768, 3, random)).value(), 1e-3);
    }
}

TEST(HyperuniformityTest, SeesALevelHoweverLow)
{
    // Stealthy sets are left with a level, not with a power that vanishes.
    std::mt19937_64 random(5);
    const auto level = shells_up_to_6([](double, double) { return 1e-12; });
    EXPECT_LE(hyperuniformity_p_value(drawn(level, 1, random), 1, nothing).value(), 1e-3);
}

}
}
