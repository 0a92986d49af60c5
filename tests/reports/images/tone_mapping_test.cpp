// The tone mapping: black, white, and equal ratios of power as equal steps of grey.
#include "reports/images/tone_mapping.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace poissonlab {
namespace {

TEST(ToneMapping, EndsAndDecades)
{
    EXPECT_EQ(report_tone_mapping.grey(0.01), 0);
    EXPECT_EQ(report_tone_mapping.grey(0.1), 85);
    EXPECT_EQ(report_tone_mapping.grey(1), 170);
    EXPECT_EQ(report_tone_mapping.grey(10), 255);
}

TEST(ToneMapping, ClampsWhatLiesBeyond)
{
    EXPECT_EQ(report_tone_mapping.grey(0), 0);
    EXPECT_EQ(report_tone_mapping.grey(-1), 0);
    EXPECT_EQ(report_tone_mapping.grey(std::numeric_limits<double>::quiet_NaN()), 0);
    EXPECT_EQ(report_tone_mapping.grey(1e9), 255);
    EXPECT_EQ(report_tone_mapping.grey(std::numeric_limits<double>::infinity()), 255);
}

TEST(ToneMapping, NeverFalls)
{
    for (double power = 1e-3; power < 100; power *= 1.01)
        EXPECT_LE(report_tone_mapping.grey(power), report_tone_mapping.grey(power * 1.01));
}

TEST(GreyScale, IsTheToneMapping)
{
    const GreyScale grey(report_tone_mapping);
    for (double power = 1e-3; power < 100; power *= 1.0001)
        ASSERT_EQ(grey(power), report_tone_mapping.grey(power)) << power;
    for (const double power :
         {0.0, -1.0, 0.01, 10.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(grey(power), report_tone_mapping.grey(power)) << power;
}

}
}
