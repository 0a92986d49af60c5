#include "analysis/tilings/color_statistics.hpp"

#include "tests/support/chi_square.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>
#include <vector>

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

/// The pairs of places of a field at a displacement.
std::vector<std::array<std::size_t, 2>> pairs_at(const ColorField& field, int dx, int dy)
{
    std::vector<std::array<std::size_t, 2>> pairs;
    const int width = static_cast<int>(field.width), height = static_cast<int>(field.height());
    for (int y = std::max(0, -dy); y < height - std::max(0, dy); ++y)
        for (int x = std::max(0, -dx); x < width - std::max(0, dx); ++x)
            pairs.push_back(
                {static_cast<std::size_t>(y * width + x), static_cast<std::size_t>((y + dy) * width + x + dx)});
    return pairs;
}

double agreeing(const ColorField& field, const std::vector<std::array<std::size_t, 2>>& pairs)
{
    return static_cast<double>(
        std::ranges::count_if(pairs, [&](const auto& p) { return field.values[p[0]] == field.values[p[1]]; }));
}

/// All distinct orders of the colours 0 0 0 0 0 1 1 2, in two rows of four.
std::vector<ColorField> all_orders()
{
    std::vector<ColorField> fields;
    std::vector<std::uint8_t> values{0, 0, 0, 0, 0, 1, 1, 2};
    do {
        fields.push_back({3, 4, values});
    } while (std::ranges::next_permutation(values).found);
    return fields;
}

TEST(ColorAutocorrelation, IsStandardOverAllOrdersOfItsColors)
{
    const std::vector<ColorField> fields = all_orders();
    ASSERT_EQ(fields.size(), 168U); // 8! / (5! 2! 1!)
    const auto count = static_cast<double>(fields.size());
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            if (dx == 0 && dy == 0) continue;
            double mean = 0, square = 0, agreement = 0, chance = 0;
            for (const ColorField& field : fields) {
                const ColorAutocorrelation result = color_autocorrelation(field, 1);
                const double z = z_at(result, dx, dy);
                mean += z / count;
                square += z * z / count;
                const auto pairs = pairs_at(field, dx, dy);
                agreement += agreeing(field, pairs) / static_cast<double>(pairs.size()) / count;
                chance = result.chance;
            }
            EXPECT_NEAR(mean, 0, 1e-12) << dx << ' ' << dy;
            EXPECT_NEAR(square, 1, 1e-12) << dx << ' ' << dy;
            EXPECT_NEAR(agreement, chance, 1e-12) << dx << ' ' << dy;
        }
}

/// The numbers of colours in falling factorials: the probability that `same` places, drawn without replacement, have
/// one colour, and then two others one colour, which is the same or another (`others` 2), or nothing (0).
double same_color(const std::vector<std::uint64_t>& counts, int same, int others)
{
    const auto falling = [](double n, int k) {
        double product = 1;
        for (int i = 0; i < k; ++i) product *= n - i;
        return product;
    };
    double places = 0, sum = 0;
    for (const auto c : counts) places += static_cast<double>(c);
    for (std::size_t a = 0; a < counts.size(); ++a) {
        const auto of_a = static_cast<double>(counts[a]);
        if (others == 0) sum += falling(of_a, same);
        for (std::size_t b = 0; b < counts.size() && others > 0; ++b)
            sum += a == b ? falling(of_a, same + others)
                          : falling(of_a, same) * falling(static_cast<double>(counts[b]), others);
    }
    return sum / falling(places, same + others);
}

TEST(ColorAutocorrelation, CountsPairsOfTheSameColor)
{
    // Mean and variance by the definition: over all pairs of pairs, which may share a place.
    ColorField field = random_field(3, 13, 9, 1);
    for (std::uint8_t& color : field.values) color = color == 2 ? 0 : color; // colours are not equally frequent
    field.values[7] = 2;
    const auto counts = color_counts(field);
    const ColorAutocorrelation result = color_autocorrelation(field, 7);
    ASSERT_EQ(result.z.size(), 15u * 15u);
    EXPECT_NEAR(result.chance, same_color(counts, 2, 0), 1e-15);
    for (int dy = -7; dy <= 7; ++dy)
        for (int dx = -7; dx <= 7; ++dx) {
            const auto pairs = pairs_at(field, dx, dy);
            double mean = 0, square = 0;
            for (const auto& p : pairs) {
                mean += same_color(counts, 2, 0);
                for (const auto& q : pairs) {
                    const bool touches = p[0] == q[1] || p[1] == q[0];
                    square += p == q    ? same_color(counts, 2, 0)
                              : touches ? same_color(counts, 3, 0)
                                        : same_color(counts, 2, 2);
                }
            }
            const bool is_middle = dx == 0 && dy == 0;
            const double expected = is_middle ? 0 : (agreeing(field, pairs) - mean) / std::sqrt(square - mean * mean);
            EXPECT_NEAR(z_at(result, dx, dy), expected, 1e-9) << dx << ' ' << dy;
        }
}

TEST(ColorAutocorrelation, SaysWhatPartOfThePairsAgrees)
{
    const ColorField field = random_field(4, 40, 30, 4);
    const ColorAutocorrelation result = color_autocorrelation(field, 12);
    const auto pairs = pairs_at(field, result.largest_at[0], result.largest_at[1]);
    EXPECT_DOUBLE_EQ(result.agreement, agreeing(field, pairs) / static_cast<double>(pairs.size()));
    EXPECT_DOUBLE_EQ(result.largest, std::abs(z_at(result, result.largest_at[0], result.largest_at[1])));
}

TEST(ColorAutocorrelation, OfIndependentColorsOfUnequalFrequenciesIsStandardNormal)
{
    std::mt19937 random(5);
    std::discrete_distribution<int> color({0.62, 0.31, 0.06, 0.01});
    ColorField field{4, 512, {}};
    for (int i = 0; i < 512 * 512; ++i) field.values.push_back(static_cast<std::uint8_t>(color(random)));
    const ColorAutocorrelation result = color_autocorrelation(field, 60);
    EXPECT_NEAR(result.chance, 0.62 * 0.62 + 0.31 * 0.31 + 0.06 * 0.06 + 0.01 * 0.01, 0.005);
    EXPECT_LT(result.largest, result.bound);
    double squares = 0;
    for (const double z : result.z) squares += z * z;
    const double n = 0.5 * (static_cast<double>(result.z.size()) - 1);
    EXPECT_NEAR(squares / 2 / n, 1, test::z_bound(1) * std::sqrt(2 / n));
}

TEST(ColorAutocorrelation, OfOneColorIsNothing)
{
    const ColorAutocorrelation result = color_autocorrelation({3, 5, std::vector<std::uint8_t>(20, 1)}, 2);
    EXPECT_EQ(result.chance, 1);
    EXPECT_EQ(result.largest, 0);
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
    EXPECT_EQ(result.agreement, 1);
    // All of n pairs agree: sqrt(n) for two colours that are equally frequent.
    EXPECT_NEAR(result.largest / std::sqrt(216.0 * 256), 1, 0.01);
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
