// Numbers as the page shows them.
#include "reports/words/number_format.hpp"

#include "results/statistic.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(NumberFormat, Counts)
{
    EXPECT_EQ(format_count(0), "0");
    EXPECT_EQ(format_count(999), "999");
    EXPECT_EQ(format_count(16384), "16,384");
    EXPECT_EQ(format_count(1000000), "1,000,000");
}

TEST(NumberFormat, PointsInLabels)
{
    EXPECT_EQ(with_formatted_points("Random, N = 16384"), "Random, N = 16,384");
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
