#include "analysis/measures/integration_error.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace poissonlab {
namespace {

using namespace test;

TEST(Integrands, HaveTheirIntegralsAndVariances)
{
    for (const int d : {2, 3}) {
        const int n = d == 2 ? 2000 : 200;
        const auto& functions = integrands(d);
        ASSERT_EQ(functions.size(), 5u);
        std::vector<double> sums(functions.size()), squares(functions.size());
        std::array<double, 3> x{};
        for (int k = 0; k < (d == 3 ? n : 1); ++k) {
            for (int j = 0; j < n; ++j) {
                for (int i = 0; i < n; ++i) {
                    x = {(i + 0.5) / n, (j + 0.5) / n, (k + 0.5) / n};
                    for (std::size_t f = 0; f < functions.size(); ++f) {
                        const double value = functions[f].value(std::span(x).first(static_cast<std::size_t>(d)));
                        sums[f] += value;
                        squares[f] += value * value;
                    }
                }
            }
        }
        for (std::size_t f = 0; f < functions.size(); ++f) {
            const double count = std::pow(n, d);
            const double mean = sums[f] / count, variance = squares[f] / count - mean * mean;
            // Midpoints see a smooth function to h^2/24 |f''| and f'' is below 100 (squares of functions
            // included), an indicator to half the cells that its border crosses: less than d n^(d-1) times
            // its extent, which the actual error is a twentieth of.
            const bool jumps =
                functions[f].name == "step" || functions[f].name == "disk" || functions[f].name == "ball";
            const double bound = jumps ? 0.5 * d / n : d * 100.0 / 24 / n / n;
            EXPECT_NEAR(mean, functions[f].integral, bound) << functions[f].name;
            EXPECT_NEAR(variance, functions[f].variance, 3 * bound) << functions[f].name;
        }
    }
}

TEST(IntegrationError, OfIndependentPointsIsThatOfMonteCarlo)
{
    std::mt19937_64 random(1);
    for (const int d : {2, 3}) {
        IntegrationErrorEstimate estimate(d, 7, 4);
        for (int k = 0; k < 400; ++k) estimate.add(random_points(100, d, random));
        for (const IntegrationError& error : estimate.mean()) {
            // rms^2 = sigma^2 / N, and relative errors of the square are twice those of the root.
            const double relative_error = 2 * error.standard_error / error.rms_error;
            EXPECT_LT(std::abs(error.relative_variance - 1), z_bound(10) * relative_error) << error.integrand;
            // A mean of e^2 over 4 shifts has a relative deviation between sqrt(2/4) (shifts independent) and
            // sqrt 2 (all the same), give or take a few percent for 400 sets and a kurtosis near 3.
            EXPECT_GT(relative_error, 0.8 * std::sqrt(2.0 / 4 / 400)) << error.integrand;
            EXPECT_LT(relative_error, 1.2 * std::sqrt(2.0 / 400)) << error.integrand;
        }
    }
}

TEST(IntegrationError, IsThePowerAtTheFrequenciesOfTheIntegrand)
{
    // The product of 1 + cos(2 pi x_k) has coefficients 2^-(number of f_k other than 0), f_k = -1, 0, 1.
    std::mt19937_64 random(2);
    for (const int d : {2, 3}) {
        const PointSet points = random_points(6, d, random);
        double expected = 0;
        for (int f = 0; f < (d == 2 ? 9 : 27); ++f) {
            const std::array<int, 3> frequency{f % 3 - 1, f / 3 % 3 - 1, d == 3 ? f / 9 - 1 : 0};
            const int orders = std::abs(frequency[0]) + std::abs(frequency[1]) + std::abs(frequency[2]);
            if (orders > 0) expected += std::pow(0.25, orders) * brute_force_power(points, frequency) / 6;
        }
        IntegrationErrorEstimate estimate(d, 1, 1 << 16);
        estimate.add(points);
        const IntegrationError cosine = estimate.mean()[3];
        ASSERT_EQ(cosine.integrand, "cosine");
        // e^2 varies over shifts by less than four times its mean (a kurtosis below 17): 4 sigma of 2^16.
        EXPECT_NEAR(cosine.rms_error * cosine.rms_error, expected, 4 * 4 / 256.0 * expected);
    }
}

TEST(IntegrationError, OfALatticeIsZeroForFrequenciesThatItDoesNotHave)
{
    for (const int d : {2, 3}) {
        IntegrationErrorEstimate estimate(d, 3);
        estimate.add(square_lattice(8, d));
        EXPECT_LT(estimate.mean()[3].rms_error, 1e-14);
        // The bilinear one on a shifted lattice is (1/2 + u)^d - 2^-d with u uniform in [-h/2, h/2), h = 1/8:
        // E[u^2] = h^2/12 a coordinate gives (1/4 + h^2/12)^d - 4^-d, of which 16 shifts see the mean.
        EXPECT_GT(estimate.mean()[4].rms_error, 0);
        EXPECT_LT(estimate.mean()[4].rms_error, std::pow(0.5 + 1 / 16.0, d) - std::pow(0.5, d) + 1e-15);
    }
}

TEST(IntegrationError, AveragesSetsOfAnySizeByTheirOwnSize)
{
    std::mt19937_64 random(4);
    const PointSet small = random_points(10, 2, random), large = random_points(1000, 2, random);
    const auto alone = [&](const PointSet& set, bool second) {
        IntegrationErrorEstimate estimate(2, 5, 3);
        if (second) estimate.add(small); // shifts depend on the number of the set
        estimate.add(set);
        return estimate.mean();
    };
    const auto first = alone(small, false), both = alone(large, true);
    for (std::size_t f = 0; f < 5; ++f) {
        const double a = first[f].rms_error * first[f].rms_error;
        const double b = 2 * both[f].rms_error * both[f].rms_error - a; // mean square of the large set
        EXPECT_EQ(first[f].standard_error, 0);
        const double sigma2 = integrands(2)[f].variance;
        EXPECT_NEAR(both[f].relative_variance, (10 * a + 1000 * b) / 2 / sigma2, 1e-10);
        // Two values a and b: standard error of their mean |a - b| / 2, over twice the root.
        EXPECT_NEAR(both[f].standard_error, std::abs(a - b) / 4 / both[f].rms_error, 1e-12);
    }
}

TEST(IntegrationError, DependsOnTheSeedAndNotOnThreads)
{
    std::mt19937_64 random(6);
    const PointSet points = random_points(200, 3, random);
    const auto rms = [&](std::uint64_t seed) {
        IntegrationErrorEstimate estimate(3, seed);
        estimate.add(points);
        return estimate.mean()[0].rms_error;
    };
    const double several = rms(1);
    EXPECT_NE(several, rms(2));
    EXPECT_NE(several, rms(1ull << 32 | 1));
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(several, rms(1));
}

TEST(IntegrationError, RejectsWhatHasNoMeaning)
{
    EXPECT_THROW(integrands(1), InputError);
    EXPECT_THROW(IntegrationErrorEstimate(4, 1), InputError);
    EXPECT_THROW(IntegrationErrorEstimate(2, 1, 0), InputError);
    IntegrationErrorEstimate estimate(2, 1);
    EXPECT_TRUE(estimate.mean().empty());
    EXPECT_THROW(estimate.add({2, {}}), InputError);
    EXPECT_THROW(estimate.add({3, {0.1, 0.2, 0.3}}), InputError);
}

}
}
