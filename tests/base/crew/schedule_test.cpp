#include "base/crew/schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace poissonlab {
namespace {

using JobKind = Job::Kind;

TEST(Schedule, KeepsTheOrderOfJobsThatDoNotDepend)
{
    Schedule schedule;
    for (std::uint32_t i = 0; i < 3; ++i) schedule.add({JobKind::series, 0, i, 0, 0});
    EXPECT_EQ(schedule.next(), 0U);
    EXPECT_EQ(schedule.next(), 1U);
    schedule.finish(0);
    EXPECT_EQ(schedule.next(), 2U);
    EXPECT_FALSE(schedule.next());
    EXPECT_FALSE(schedule.is_done());
    schedule.finish(1);
    schedule.finish(2);
    EXPECT_TRUE(schedule.is_done());
}

TEST(Schedule, HandsOutAJobWhenThoseBeforeItAreDone)
{
    Schedule schedule;
    const std::array before{schedule.add({JobKind::part, 0, 0, 0, 1}), schedule.add({JobKind::part, 0, 0, 1, 1})};
    const auto last = schedule.add({JobKind::series, 0, 0, 0, 0}, before);
    schedule.next();
    schedule.next();
    EXPECT_FALSE(schedule.next());
    schedule.finish(before[1]);
    EXPECT_FALSE(schedule.next());
    schedule.finish(before[0]);
    EXPECT_EQ(schedule.next(), last);
}

TEST(Schedule, FinishesWhatWasBegun)
{
    Schedule schedule;
    const std::array samples{schedule.add({JobKind::sample, 0, 0, 0, 4}), schedule.add({JobKind::sample, 0, 0, 4, 4})};
    const auto other = schedule.add({JobKind::sample, 0, 1, 0, 4});
    const std::array part{schedule.add({JobKind::part, 0, 0, 0, 1}, samples)};
    const auto series = schedule.add({JobKind::series, 0, 0, 0, 0}, part);
    EXPECT_EQ(schedule.next(), samples[0]);
    EXPECT_EQ(schedule.next(), other) << "the first realizations of each series first";
    EXPECT_EQ(schedule.next(), samples[1]);
    const auto later = schedule.add({JobKind::sample, 0, 1, 4, 4});
    schedule.finish(samples[0]);
    schedule.finish(samples[1]);
    EXPECT_EQ(schedule.next(), part[0]);
    schedule.finish(part[0]);
    EXPECT_EQ(schedule.next(), series);
    EXPECT_EQ(schedule.next(), later);
}

TEST(Schedule, JobsAfterWhatIsDoneAreReady)
{
    Schedule schedule;
    const std::array first{schedule.add({JobKind::series, 0, 0, 0, 0})};
    schedule.next();
    schedule.finish(first[0]);
    schedule.add({JobKind::series, 1, 0, 0, 0}, first);
    EXPECT_TRUE(schedule.next());
}

TEST(Schedule, GivesUpWhatIsLeftOfASeries)
{
    Schedule schedule;
    const std::array samples{schedule.add({JobKind::sample, 0, 0, 0, 4}), schedule.add({JobKind::sample, 0, 0, 4, 4})};
    const std::array series{schedule.add({JobKind::series, 0, 0, 0, 0}, samples)};
    const auto exhibit = schedule.add({JobKind::exhibit, 0, 0, 0, 0});
    const auto with_the_same_sets = schedule.add({JobKind::series, 0, 1, 0, 0}, series);
    ASSERT_EQ(schedule.next(), samples[0]);
    ASSERT_EQ(schedule.next(), exhibit);
    ASSERT_EQ(schedule.next(), samples[1]);
    schedule.finish(samples[0]);
    EXPECT_EQ(schedule.give_up(schedule.job(samples[0])), 1U) << "the other sample is handed out already";
    EXPECT_EQ(schedule.next(), with_the_same_sets);
    schedule.finish(samples[1]);
    EXPECT_FALSE(schedule.next()) << "the series does not come back";
    schedule.finish(exhibit);
    schedule.finish(with_the_same_sets);
    EXPECT_TRUE(schedule.is_done());
}

/// Whatever the dependences, every job is handed out once, after all that it waits for.
TEST(Schedule, RandomDependences)
{
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        Schedule schedule;
        std::vector<std::vector<Schedule::Id>> after(1 + random() % 40);
        for (auto& before : after) {
            const auto here = static_cast<std::size_t>(&before - after.data());
            for (std::size_t i = 0; i < here; ++i)
                if (random() % 5 == 0) before.push_back(i);
            schedule.add({static_cast<JobKind>(random() % 4), static_cast<std::uint32_t>(random() % 3), 0,
                          static_cast<std::uint32_t>(random() % 2), 0},
                         before);
        }
        std::vector<int> state(after.size()); // 1: handed out, 2: done
        std::vector<Schedule::Id> out;
        while (!schedule.is_done()) {
            const auto id = random() % 2 == 0 ? schedule.next() : std::nullopt;
            if (id) {
                EXPECT_EQ(state[*id], 0);
                for (const auto before : after[*id]) EXPECT_EQ(state[before], 2);
                state[*id] = 1;
                out.push_back(*id);
            } else if (!out.empty()) {
                std::swap(out[random() % out.size()], out.back());
                schedule.finish(out.back());
                state[out.back()] = 2;
                out.pop_back();
            }
        }
        EXPECT_EQ(std::count(state.begin(), state.end(), 2), static_cast<std::ptrdiff_t>(state.size()));
    }
}

}
}
