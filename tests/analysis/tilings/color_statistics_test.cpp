#include "analysis/tilings/color_statistics.hpp"

#include "tests/support/chi_square.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace poissonlab {
namespace {

ColorField random_field(std::uint32_t colors, std::size_t width, std::size_t height, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> color(0, static_cast<int>(colors) - 1);
    ColorField field{colors, width, {}};
    for (std::size_t i = 0; i < width * height; ++i) field.values.push_back(static_cast<std::uint8_t>(color(random)));
    return field;
}

double z_at(const ColorAutocorrelation& result, int dx, int dy)
{
    const int side = 2 * result.lags + 1;
    return result.z.at(static_cast<std::size_t>((dy + result.lags) * side + dx + result.lags));
}

TEST(FrequencyTest, IsPearsonsChiSquare)
{
    const std::vector<std::uint64_t> counts = {90, 110, 95, 105};
    const FrequencyTest test = test_frequencies(counts);
    EXPECT_DOUBLE_EQ(test.chi_square, 2.5); // (100 + 100 + 25 + 25) / 100
    // The tail of chi-square with three degrees of freedom has a closed form.
    const double tail = std::erfc(std::sqrt(1.25)) + std::sqrt(5 / std::numbers::pi) * std::exp(-1.25);
    EXPECT_NEAR(test.p_value, tail, 1e-12);
    EXPECT_NEAR(test.p_value, 0.4753, 1e-4) << "tables of the distribution";
    EXPECT_EQ(test_frequencies(std::vector<std::uint64_t>{7}).p_value, 1);
    EXPECT_EQ(test_frequencies(std::vector<std::uint64_t>{0, 0}).p_value, 1);
}

TEST(ColorCounts, CountEachColor)
{
    EXPECT_EQ(color_counts({3, 2, {2, 0, 2, 2}}), (std::vector<std::uint64_t>{1, 0, 3}));
}

TEST(ColorAutocorrelation, CountsPairsOfTheSameColor)
{
    const ColorField field = random_field(3, 17, 11, 1);
    const ColorAutocorrelation result = color_autocorrelation(field, 9);
    ASSERT_EQ(result.z.size(), 19u * 19u);
    for (int dy = -9; dy <= 9; ++dy)
        for (int dx = -9; dx <= 9; ++dx) {
            double pairs = 0, same = 0;
            for (int y = 0; y < 11; ++y)
                for (int x = 0; x < 17; ++x) {
                    if (x + dx < 0 || x + dx >= 17 || y + dy < 0 || y + dy >= 11) continue;
                    ++pairs;
                    same += field.values[static_cast<std::size_t>(y * 17 + x)] ==
                            field.values[static_cast<std::size_t>((y + dy) * 17 + x + dx)];
                }
            const bool middle = dx == 0 && dy == 0;
            const double expected = middle ? 0 : (same - pairs / 3) / std::sqrt(pairs * 2 / 9);
            EXPECT_NEAR(z_at(result, dx, dy), expected, 1e-12) << dx << ' ' << dy;
        }
}

TEST(ColorAutocorrelation, OfIndependentColorsIsStandardNormal)
{
    const ColorAutocorrelation result = color_autocorrelation(random_field(4, 512, 512, 2), 100);
    EXPECT_LT(result.largest, result.bound);
    EXPECT_GT(result.largest, 3) << "the largest of 20,200 normal variables is about 4";
    // Half of the values are independent of one another, the others are the same again.
    double squares = 0;
    for (const double z : result.z) squares += z * z;
    const double n = 0.5 * (static_cast<double>(result.z.size()) - 1);
    EXPECT_NEAR(squares / 2 / n, 1, test::z_bound(1) * std::sqrt(2 / n));
    // One of 20,200 displacements is beyond the bound with probability 0.01.
    EXPECT_NEAR(result.bound, 5.03, 0.01);
}

TEST(ColorAutocorrelation, SeesRepetition)
{
    // Columns that repeat after 40.
    ColorField field = random_field(2, 256, 256, 3);
    for (std::size_t i = 0; i < field.values.size(); ++i)
        if (i % 256 >= 40) field.values[i] = field.values[i - 40];
    const ColorAutocorrelation result = color_autocorrelation(field, 60);
    EXPECT_EQ(std::abs(result.largest_at[0]), 40);
    EXPECT_EQ(result.largest_at[1], 0);
    EXPECT_NEAR(result.largest, std::sqrt(216.0 * 256), 1e-9) << "all of n pairs agree: sqrt(n) for two colours";
    EXPECT_GT(result.largest, result.bound);
}

TEST(ColorAutocorrelation, RefusesLagsBeyondTheField)
{
    EXPECT_THROW(color_autocorrelation(random_field(2, 8, 4, 1), 4), std::invalid_argument);
    EXPECT_NO_THROW(color_autocorrelation(random_field(2, 8, 5, 1), 4));
    EXPECT_EQ(color_autocorrelation(random_field(2, 8, 5, 1), 0).z, std::vector<double>{0});
}

}
}
