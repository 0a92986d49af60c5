// Numbers as the page shows them.
#include "reports/words/number_format.hpp"

#include "base/text/noun.hpp"
#include "results/statistic.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace poissonlab {
namespace {

TEST(NumberFormat, Counts)
{
    EXPECT_EQ(format_count(0), "0");
    EXPECT_EQ(format_count(999), "999");
    EXPECT_EQ(format_count(16384), "16,384");
    EXPECT_EQ(format_count(1000000), "1,000,000");
}

TEST(NumberFormat, NounsFollowTheirNumber)
{
    EXPECT_EQ(noun(1, "polygon"), "polygon");
    EXPECT_EQ(noun(0, "polygon"), "polygons");
    EXPECT_EQ(noun(2, "class", "classes"), "classes");
}

TEST(NumberFormat, PointsInLabels)
{
    EXPECT_EQ(with_formatted_points("Random, N = 16384"), "Random, N = 16,384");
    EXPECT_EQ(with_formatted_points("Darts, rho = 0.7"), "Darts, ρ = 0.7");
    EXPECT_EQ(with_formatted_points("Darts (rho = 0.7), myrho = 1"), "Darts (ρ = 0.7), myrho = 1");
    EXPECT_EQ(with_formatted_points("A, N = 1024, i = 2048, start = B (N = 1048576)"),
              "A, N = 1,024, i = 2048, start = B (N = 1,048,576)");
    for (const char* label : {"", "Random", "N = 256", "N = 16,384", "N = 1234.5", "N = 1234,567", "SIN = 1234",
                              "N = 123456789012345678901234567890"})
        EXPECT_EQ(with_formatted_points(label), label);
}

TEST(NumberFormat, SignificantDigits)
{
    EXPECT_EQ(format_significant(0.005877, 4), "0.005877");
    EXPECT_EQ(format_significant(0.3, 2), "0.30");
    EXPECT_EQ(format_significant(161, 3), "161");
    EXPECT_EQ(format_significant(2.346e-5, 3), "2.35 × 10⁻⁵");
    EXPECT_EQ(format_significant(123456, 3), "1.23 × 10⁵");
    EXPECT_EQ(format_significant(-1.5, 2), "\u22121.5");
}

TEST(NumberFormat, ErrorsDecideOnTheDigits)
{
    // The three cases of the Particle Data Group's own example, and the ends of its ranges.
    EXPECT_EQ(format_estimate(0.827, 0.119).text(), "0.83 ± 0.12");
    EXPECT_EQ(format_estimate(0.827, 0.367).text(), "0.8 ± 0.4");
    EXPECT_EQ(format_estimate(0.7213, 0.00354).text(), "0.7213 ± 0.0035");
    EXPECT_EQ(format_estimate(0.7213, 0.00355).text(), "0.721 ± 0.004");
    EXPECT_EQ(format_estimate(0.7213, 0.0949).text(), "0.72 ± 0.09");
    EXPECT_EQ(format_estimate(0.7213, 0.0951).text(), "0.72 ± 0.10");
    EXPECT_EQ(format_estimate(1234.5, 56).text(), "1,230 ± 60");
    EXPECT_EQ(format_estimate(-7.25, 0.125).text(), "\u22127.25 ± 0.12");
    EXPECT_EQ(format_estimate(0, 0.125).text(), "0.00 ± 0.12");
    EXPECT_EQ(format_estimate(-0.001, 0.5).text(), "0.0 ± 0.5");
}

TEST(NumberFormat, SmallNumbersArePowersOfTenWithTheirErrors)
{
    EXPECT_EQ(format_estimate(3.2e-5, 4.6e-6).text(), "3.2 × 10⁻⁵ ± 5 × 10⁻⁶");
    EXPECT_EQ(format_estimate(3.24e-5, 2.6e-7).text(), "3.240 × 10⁻⁵ ± 2.6 × 10⁻⁷");
    EXPECT_EQ(format_estimate(0, 4.6e-6).text(), "0 ± 5 × 10⁻⁶");
    EXPECT_EQ(format_estimate(3.2e9, 4.6e7).text(), "3.20 × 10⁹ ± 5 × 10⁷");
}

TEST(NumberFormat, NoErrorIsShownWhereThereIsNone)
{
    EXPECT_EQ(format_estimate(0.75, {}).text(), "0.7500");
    EXPECT_EQ(format_estimate(0.75, 0.0).text(), "0.7500");
    EXPECT_EQ(format_estimate(0.75, 3.8e-16).text(), "0.7500") << "rounding";
    EXPECT_EQ(format_estimate(0.925, 7e-7).text(), "0.9250") << "nobody reads more";
    EXPECT_EQ(format_estimate(0.925, 2e-6).text(), "0.9250000 ± 0.0000020");
    EXPECT_EQ(format_estimate(0.75, std::numeric_limits<double>::quiet_NaN(), 2).text(), "0.75");
    EXPECT_EQ(format_estimate(0, {}).text(), "0");
}

TEST(NumberFormat, FixedDecimals)
{
    EXPECT_EQ(format_fixed(0.7, 4), "0.7000");
    EXPECT_EQ(format_fixed(-0.0, 1), "0.0");
    EXPECT_EQ(format_fixed(-0.04, 1), "0.0");
    EXPECT_EQ(format_fixed(-10, 1), "\u221210.0");
    EXPECT_EQ(format_fixed(-512, 0), "\u2212512");
}

TEST(NumberFormat, Seconds)
{
    EXPECT_EQ(format_seconds(0.0123), "12.3 ms");
    EXPECT_EQ(format_seconds(35), "35.0 s");
    EXPECT_EQ(format_seconds(263.5), "264 s");
    EXPECT_EQ(format_seconds(0.000812), "812 µs");
    EXPECT_EQ(format_seconds(1.5), "1.50 s");
}

TEST(NumberFormat, ExactNumbersReadBack)
{
    for (const double value : {0.1, 1.0 / 3, 5.877e-3, 1e-300}) EXPECT_EQ(std::stod(format_exact(value)), value);
}

TEST(NumberFormat, Median)
{
    EXPECT_EQ(median({3, 1, 2}), 2);
    EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
    EXPECT_EQ(median({7}), 7);
}

}
}
