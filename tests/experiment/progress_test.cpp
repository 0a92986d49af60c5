#include "experiment/progress.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(Progress, Durations)
{
    EXPECT_EQ(duration_text(0), "0.0 s");
    EXPECT_EQ(duration_text(3.24), "3.2 s");
    EXPECT_EQ(duration_text(125.2), "2 min 05 s");
    EXPECT_EQ(duration_text(3600 + 7 * 60), "1 h 07 min");
}

TEST(Progress, Rates)
{
    EXPECT_EQ(rate_text(950), "950 points/s");
    EXPECT_EQ(rate_text(12345), "12 k points/s");
    EXPECT_EQ(rate_text(1.2e6), "1.20 M points/s");
}

TEST(Progress, InAPipeIsOneLineASeries)
{
    testing::internal::CaptureStdout();
    {
        Progress progress(Progress::Style::plain);
        progress.start(2);
        progress.start_series("A", 2);
        progress.realization_done(10, 0.1);
        progress.realization_done(10, 0.1);
        progress.finish_series("A: done");
        progress.step("report");
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "A: done\n");
}

TEST(Progress, QuietIsQuiet)
{
    testing::internal::CaptureStdout();
    {
        Progress progress(Progress::Style::quiet);
        progress.start_series("A", 1);
        progress.realization_done(10, 0.1);
        progress.finish_series("A: done");
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(Progress, OnATerminalOneLineUpdatesItself)
{
    testing::internal::CaptureStdout();
    {
        Progress progress(Progress::Style::terminal);
        progress.start(2);
        progress.start_series("A", 2);
        progress.realization_done(100, 0.1);
        progress.step("half-way");
    }
    const std::string text = testing::internal::GetCapturedStdout();
    EXPECT_TRUE(text.starts_with("\r\033[KA: realization 1/2\r\033[KA: realization 2/2, 1 k points/s, "))
        << text;
    EXPECT_TRUE(text.ends_with(" left\r\033[Khalf-way\r\033[K")) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos);
}

}
}
