#include "analysis/statistics/welch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace poissonlab {
namespace {

TEST(SampleMean, IsTheTextbookOne)
{
    const std::array values{2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
    const SampleMean mean = sample_mean(values);
    EXPECT_DOUBLE_EQ(mean.value, 5);
    EXPECT_DOUBLE_EQ(mean.standard_error, std::sqrt(32.0 / 7 / 8)); // squares about 5 sum up to 32
    EXPECT_EQ(mean.samples, 8u);
    // 0.1 + 0.1 + 0.1 is not 0.3, which must not look like a spread.
    EXPECT_EQ(sample_mean(std::array{0.1, 0.1, 0.1}).standard_error, 0);
    EXPECT_EQ(sample_mean(std::array{3.5}).value, 3.5);
}

// With equal errors and sizes the degrees of freedom are those of both together, n1 + n2 - 2; the 97.5 % points of
// Student's distribution are from printed tables (for example NIST, e-Handbook of Statistical Methods, 1.3.6.7.2).
TEST(WelchTest, HasThePointsOfStudentsTables)
{
    struct
    {
        std::size_t samples;
        double t;
    } const rows[] = {{2, 4.303}, {3, 2.776}, {6, 2.228}, {10, 2.101}, {51, 1.984}};
    for (const auto& [samples, t] : rows) {
        const WelchTest test = welch_test({1, 1, samples}, {1 + t * std::sqrt(2.0), 1, samples});
        EXPECT_NEAR(test.degrees_of_freedom, 2.0 * static_cast<double>(samples) - 2, 1e-9);
        EXPECT_NEAR(test.t, t, 1e-12);
        // The table's last digit: half a unit of t changes p by at most 5e-4 times twice the density at t, below 0.06.
        EXPECT_NEAR(test.p_value, 0.05, 6e-5);
    }
}

// "Student"'s own data, hours of sleep gained by two drugs, as in R's data set sleep, for which R's t.test prints
// t = -1.8608, df = 17.776, p-value = 0.07939.
TEST(WelchTest, IsThatOfR)
{
    const std::array a{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
    const std::array b{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
    const WelchTest test = welch_test(sample_mean(a), sample_mean(b));
    EXPECT_NEAR(test.t, 1.8608, 5e-5);
    EXPECT_NEAR(test.degrees_of_freedom, 17.776, 5e-4);
    EXPECT_NEAR(test.p_value, 0.07939, 5e-6);
}

TEST(WelchTest, TakesAnErrorOfOneSideOnly)
{
    const WelchTest test = welch_test({1, 0, 10}, {2, 0.25, 10});
    EXPECT_DOUBLE_EQ(test.t, 4);
    EXPECT_DOUBLE_EQ(test.degrees_of_freedom, 9);
    EXPECT_THROW(welch_test({1, 0, 10}, {2, 0, 10}), std::invalid_argument);
    EXPECT_THROW(welch_test({1, 1, 1}, {2, 1, 10}), std::invalid_argument);
}

TEST(WelchTest, DoesNotUnderflow)
{
    const WelchTest test = welch_test({0, 1e-90, 10}, {3e-90, 1e-90, 10});
    EXPECT_NEAR(test.degrees_of_freedom, 18, 1e-9);
}

// p-values of equal means are uniform: the share below 0.05 of 4,000 has a standard error of 0.0034.
TEST(WelchTest, RejectsEqualMeansAsOftenAsItSays)
{
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    int rejected = 0;
    constexpr int runs = 4000;
    for (int run = 0; run < runs; ++run) {
        std::array<double, 10> a, b;
        for (double& v : a) v = normal(random);
        for (double& v : b) v = 3 * normal(random);
        rejected += welch_test(sample_mean(a), sample_mean(b)).p_value < 0.05;
    }
    EXPECT_NEAR(static_cast<double>(rejected) / runs, 0.05, 4 * 0.0035);
}

TEST(Holm, StepsDown)
{
    // 0.01 * 4, 0.02 * 3, then 0.03 * 2 = 0.06 and 0.04 * 1, which must not be below the one before.
    const auto adjusted = holm_adjusted(std::array{0.03, 0.01, 0.04, 0.02});
    ASSERT_EQ(adjusted.size(), 4u);
    EXPECT_DOUBLE_EQ(adjusted[1], 0.04);
    EXPECT_DOUBLE_EQ(adjusted[3], 0.06);
    EXPECT_DOUBLE_EQ(adjusted[0], 0.06);
    EXPECT_DOUBLE_EQ(adjusted[2], 0.06);
    EXPECT_EQ(holm_adjusted(std::array{0.7, 0.8})[0], 1);
    EXPECT_TRUE(holm_adjusted({}).empty());
}

}
}
