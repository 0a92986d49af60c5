#include "analysis/statistics/jackknife.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

TEST(Jackknife, OfAMeanIsItsStandardError)
{
    const std::vector<double> values = {1, 4, 2, 8, 5, 7};
    std::vector<std::vector<double>> curves;
    for (const double value : values) curves.push_back({value, -value});
    const auto first = [](const std::vector<double>& mean) { return mean[0]; };
    // Mean 4.5, squared deviations 37.5: sqrt(37.5 / 5 / 6).
    EXPECT_NEAR(standard_error_of_mean(values), std::sqrt(1.25), 1e-15);
    EXPECT_NEAR(jackknife_error(curves, first), std::sqrt(1.25), 1e-14);
    EXPECT_NEAR(jackknife_error(curves, [](const std::vector<double>& mean) { return 3 * mean[0] + mean[1]; }),
                2 * std::sqrt(1.25), 1e-14);
    EXPECT_EQ(jackknife_error(curves, [](const std::vector<double>&) { return 3.0; }), 0);
}

/// The mean claimed variance over the true one, for a statistic of the mean of ten curves of 50 normal values.
double claimed_over_true(double mean, const auto& error_of,
                         const std::function<double(const std::vector<double>&)>& statistic)
{
    constexpr int trials = 2000;
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal(mean, 1);
    double claimed = 0, sum = 0, squares = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<std::vector<double>> curves(10, std::vector<double>(50));
        std::vector<double> average(50);
        for (auto& curve : curves)
            for (std::size_t i = 0; i < 50; ++i) average[i] += (curve[i] = normal(random)) / 10;
        const double value = statistic(average), error = error_of(curves, statistic);
        claimed += error * error / trials;
        sum += value / trials;
        squares += value * value / trials;
    }
    return claimed / (squares - sum * sum);
}

TEST(Jackknife, AgreesWithTheSpreadOfTheStatistic)
{
    const auto mean_square = [](const std::vector<double>& mean) {
        double sum = 0;
        for (const double x : mean) sum += x * x;
        return sum / static_cast<double>(mean.size());
    };
    // The true variance is known within sqrt(2 / 2000) = 3 %, the claimed one better. Of the mean square of normal
    // variables with mean m and variance v = 1/10, the variance is (4 m^2 v + 2 v^2) / 50; the jackknife claims
    // (4 m^2 v + 4 v^2 (1 + 1/9 ...)) / 50: nearly right far from 0, twice too much at 0 (Efron and Stein).
    EXPECT_NEAR(claimed_over_true(3, jackknife_error, mean_square), 1, 4 * 0.032 + 0.01);
    EXPECT_NEAR(claimed_over_true(0, jackknife_error, mean_square), 2, 2 * 4 * 0.032 + 2.0 / 9);
    // Leaving out two says what is too much, but for terms of 1/9 of it.
    EXPECT_NEAR(claimed_over_true(3, jackknife_error_of_squares, mean_square), 1, 4 * 0.032 + 0.01);
    EXPECT_NEAR(claimed_over_true(0, jackknife_error_of_squares, mean_square), 1, 4 * 0.032 + 1.0 / 9);
}

TEST(Jackknife, OfSquaresIsThatOfLinearStatisticsToo)
{
    const std::vector<std::vector<double>> curves = {{1}, {4}, {2}, {8}, {5}, {7}};
    const auto first = [](const std::vector<double>& mean) { return mean[0]; };
    EXPECT_NEAR(jackknife_error_of_squares(curves, first), std::sqrt(1.25), 1e-12);
    EXPECT_NEAR(jackknife_error_of_squares({{1}, {4}}, first), 1.5, 1e-14);
    std::vector<std::vector<double>> many;
    for (int k = 0; k < 64; ++k) many.push_back({static_cast<double>(k % 2)}); // each of 32 means is 0 or 1
    EXPECT_NEAR(jackknife_error_of_squares(many, first), std::sqrt(8.0 / 31 / 32), 1e-12);
}

TEST(ErrorsOfMean, AreThoseOfEachValueBetweenGroups)
{
    const std::vector<std::vector<double>> curves = {{1, 0}, {3, 2}, {5, 10}, {7, 0}};
    const std::vector<double> each = errors_of_mean(curves), pairs = errors_of_mean(curves, {0, 0, 1, 1});
    EXPECT_NEAR(each[0], std::sqrt(20.0 / 3 / 4), 1e-14);
    EXPECT_NEAR(each[1], standard_error_of_mean({0, 2, 10, 0}), 1e-14);
    EXPECT_NEAR(pairs[0], 2, 1e-14); // means 2 and 6
    EXPECT_TRUE(errors_of_mean({{1, 2}}).empty());
    EXPECT_TRUE(errors_of_mean(curves, {3, 3, 3, 3}).empty());
}

TEST(GroupMeans, TakeTurns)
{
    using Groups = std::vector<std::size_t>;
    EXPECT_EQ(group_means(std::vector<double>{1, 2, 3, 4, 5}, Groups{0, 1, 0, 1, 0}), (std::vector<double>{3, 3}));
    EXPECT_EQ(group_means(std::vector<double>{1, 2, 3, 4, 6}, Groups{0, 1, 2, 3, 0}),
              (std::vector<double>{3.5, 2, 3, 4}));
    EXPECT_EQ(group_means(std::vector<double>{1, 2, 4}, Groups{7, 2, 7}), (std::vector<double>{2.5, 2}));
    const std::vector<std::vector<double>> curves = {{1, 10}, {2, 20}, {3, 40}};
    EXPECT_EQ(group_means(curves, Groups{0, 1, 0}), (std::vector<std::vector<double>>{{2, 25}, {2, 20}}));
    EXPECT_THROW(group_means(curves, Groups{0, 1}), std::invalid_argument);
    EXPECT_THROW(group_means({{1.0}, {1.0, 2.0}}, Groups{0, 0}), std::invalid_argument);
}

TEST(GroupMeans, GiveTheErrorThatGroupsHave)
{
    // Values are a group's normal deviate of variance 1 plus one of their own of variance 1/4: the variance of the mean
    // over 4 groups of 5 is (1 + 1/20) / 4, of which the values by themselves would claim a fifth of 1.25 / 4 only.
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    double by_groups = 0, by_values = 0;
    constexpr int trials = 4000;
    for (int trial = 0; trial < trials; ++trial) {
        const double groups[4] = {normal(random), normal(random), normal(random), normal(random)};
        std::vector<double> values;
        std::vector<std::size_t> group_of;
        for (std::size_t k = 0; k < 20; ++k) {
            group_of.push_back(k % 4);
            values.push_back(groups[k % 4] + normal(random) / 2);
        }
        by_groups += std::pow(standard_error_of_mean(group_means(values, group_of)), 2) / trials;
        by_values += std::pow(standard_error_of_mean(values), 2) / trials;
    }
    // A variance of 3 degrees of freedom is known within sqrt(2 / 3 / 4000) = 1.3 %.
    EXPECT_NEAR(by_groups, 1.05 / 4, 4 * 0.013 * 1.05 / 4);
    EXPECT_LT(by_values, 0.3 * by_groups);
}

TEST(Jackknife, NeedsTwoOfASize)
{
    const auto none = [](const std::vector<double>&) { return 0.0; };
    EXPECT_THROW(jackknife_error({{1.0}}, none), std::invalid_argument);
    EXPECT_THROW(jackknife_error({{1.0}, {1.0, 2.0}}, none), std::invalid_argument);
    EXPECT_THROW(standard_error_of_mean({1.0}), std::invalid_argument);
}

}
}
