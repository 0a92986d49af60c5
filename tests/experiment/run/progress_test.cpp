#include "experiment/run/progress.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <sstream>
#include <string>
#include <vector>

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

/// A clock that goes as told.
class FakeTime
{
public:
    Progress::Clock clock()
    {
        return [this] { return now_; };
    }
    void wait(double seconds)
    {
        now_ += std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
    }

private:
    std::chrono::steady_clock::time_point now_;
};

/// Returns what is printed while `work` reports its progress, with a clock that `work` sets.
template <typename Work>
std::string printed(Progress::Style style, const Work& work)
{
    FakeTime time;
    testing::internal::CaptureStdout();
    {
        Progress progress(style, time.clock());
        work(progress, time);
    }
    return testing::internal::GetCapturedStdout();
}

TEST(Progress, InAPipeIsOneLineASeries)
{
    const std::string text = printed(Progress::Style::plain, [](Progress& progress, FakeTime&) {
        progress.start({2, 2, 2});
        progress.sampled(10, 0.1);
        progress.analysed();
        progress.sampled(10, 0.1);
        progress.analysed();
        progress.finish_series("A: done");
        progress.step("report");
    });
    EXPECT_EQ(text, "A: done\n");
}

TEST(Progress, InAPipeLongWorkIsALineNowAndThen)
{
    const std::string text = printed(Progress::Style::plain, [](Progress& progress, FakeTime& time) {
        progress.start({8, 8, 8});
        for (int i = 0; i < 4; ++i) {
            time.wait(6);
            progress.sampled(100, 0.1);
            progress.analysed();
        }
        time.wait(11);
        progress.step("tile 3 of 16");
    });
    // The time before the first realization, which samples for 0.1 s, is not expected again: six seconds each are left.
    // When two are made, one is analysed, which says nothing of the others.
    EXPECT_EQ(text, "2/8 realizations, 1 k points/s\n"
                    "4/8 realizations, 1 k points/s, 24.0 s left\n"
                    "tile 3 of 16\n");
}

TEST(Progress, SecondsLeftLeaveOutWhatHappensOnce)
{
    // Ten realizations take 1 s to make and 9 s to analyse, after 30 s of work that is done once, and 20 s that are
    // part of the first analysis. While only one of them is analysed, nothing is known of the others; when three are
    // made and two are analysed, 79 s are left. Nothing is said of what comes after the last one.
    const std::string text = printed(Progress::Style::plain, [](Progress& progress, FakeTime& time) {
        progress.start({10, 10, 10});
        time.wait(31);
        progress.sampled(100, 1);
        time.wait(29);
        progress.analysed();
        for (int i = 0; i < 2; ++i) {
            time.wait(1);
            progress.sampled(100, 1);
            time.wait(9);
            progress.analysed();
        }
        progress.elsewhere(7, 7);
        time.wait(11);
        progress.elsewhere(1, 1);
    });
    EXPECT_EQ(text, "1/10 realizations, 100 points/s\n"
                    "1/10 realizations, 100 points/s\n"
                    "2/10 realizations, 100 points/s, 1 min 20 s left\n"
                    "3/10 realizations, 100 points/s, 1 min 10 s left\n"
                    "10/10 realizations, 100 points/s\n");
}

TEST(Progress, WhatIsStoredCountsAsDone)
{
    const std::string text = printed(Progress::Style::plain, [](Progress& progress, FakeTime& time) {
        progress.start({10, 4, 5});
        time.wait(12);
        progress.elsewhere(2, 2);
    });
    EXPECT_EQ(text, "6 of 10 realizations are there already\n"
                    "8/10 realizations, 15.0 s left\n");
}

TEST(Progress, QuietIsQuiet)
{
    const std::string text = printed(Progress::Style::quiet, [](Progress& progress, FakeTime&) {
        progress.start({2, 1, 1});
        progress.sampled(10, 0.1);
        progress.finish_series("A: done");
        progress.start_run(1, 2, "title");
        progress.message("text");
        progress.report("out/index.html");
    });
    EXPECT_EQ(text, "out/index.html\n");
}

TEST(Progress, OnATerminalOneLineUpdatesItself)
{
    const std::string text = printed(Progress::Style::terminal, [](Progress& progress, FakeTime& time) {
        progress.start({2, 2, 2});
        time.wait(1);
        progress.sampled(100, 0.1);
        progress.analysed(); // too soon after the last
        progress.step("half-way");
    });
    EXPECT_EQ(text, "\r\033[K[######------------------] 1/2 realizations, 1 k points/s"
                    "\r\033[Khalf-way\r\033[K");
}

TEST(Progress, EventsAreObjectsALine)
{
    const std::string text = printed(Progress::Style::json, [](Progress& progress, FakeTime& time) {
        progress.start({4, 2, 4});
        time.wait(2);
        progress.sampled(100, 0.1);
        progress.finish_series("A \"b\"");
        progress.start_run(1, 2, "T");
        progress.message("m");
        time.wait(2);
        progress.step("s");
        progress.report("out/index.html");
    });
    std::istringstream lines(text);
    std::vector<nlohmann::json> events;
    for (std::string line; std::getline(lines, line);) events.push_back(nlohmann::json::parse(line));
    ASSERT_EQ(events.size(), 7U);
    EXPECT_EQ(events[0], (nlohmann::json{{"event", "start"}, {"realizations", 4}, {"stored", 2}}));
    EXPECT_EQ(events[1], (nlohmann::json{{"event", "progress"},
                                         {"realizations", 4},
                                         {"made", 3},
                                         {"analysed", 0},
                                         {"points_per_second", 1000.0},
                                         {"seconds_left", nullptr}}));
    EXPECT_EQ(events[2], (nlohmann::json{{"event", "series"}, {"text", "A \"b\""}, {"seconds", 2.0}}));
    EXPECT_EQ(events[3],
              (nlohmann::json{{"event", "run"}, {"number", 1}, {"count", 2}, {"title", "T"}, {"seconds", 2.0}}));
    EXPECT_EQ(events[4], (nlohmann::json{{"event", "message"}, {"text", "m"}}));
    EXPECT_EQ(events[5], (nlohmann::json{{"event", "step"}, {"text", "s"}}));
    EXPECT_EQ(events[6], (nlohmann::json{{"event", "report"}, {"path", "out/index.html"}, {"seconds", 4.0}}));
}

}
}
