#include "base/programs/side_by_side.hpp"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace poissonlab {
namespace {

/// The loop inside one piece runs to its end, whatever happens beside it. With tbb::parallel_invoke() it does not.
TEST(SideBySide, AFailureCancelsNoLoopOfAnotherPiece)
{
    for (int trial = 0; trial < 20; ++trial) {
        std::atomic<bool> begun = false, whole = false;
        std::vector<int> filled(4000);
        EXPECT_THROW(do_side_by_side(
                         [&] {
                             begun = true;
                             std::this_thread::sleep_for(std::chrono::milliseconds(5));
                             tbb::parallel_for(std::size_t{0}, filled.size(), [&](std::size_t i) { filled[i] = 1; });
                             whole = std::ranges::count(filled, 1) == 4000;
                         },
                         [&] {
                             for (int i = 0; i < 20 && !begun; ++i)
                                 std::this_thread::sleep_for(std::chrono::milliseconds(1));
                             throw std::runtime_error("a piece fails");
                         }),
                     std::runtime_error);
        EXPECT_TRUE(whole) << trial;
    }
}

TEST(SideBySide, ThrowsTheFirstFailureInTheOrderOfThePieces)
{
    const auto failure_of = [](const std::vector<std::size_t>& failing) -> std::string {
        try {
            for_all_side_by_side(50, [&](std::size_t i) {
                if (std::ranges::count(failing, i) > 0) throw std::runtime_error(std::to_string(i));
            });
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "none";
    };
    for (int trial = 0; trial < 20; ++trial) {
        EXPECT_EQ(failure_of({41, 7, 30}), "7");
        EXPECT_EQ(failure_of({49}), "49");
        EXPECT_EQ(failure_of({}), "none");
    }
}

TEST(SideBySide, EveryElementHasItsTurnOnce)
{
    for (const std::size_t size : {0U, 1U, 2U, 3U, 1000U}) {
        std::vector<int> turns(size);
        for_each_side_by_side(turns, [](int& turn) { ++turn; });
        EXPECT_EQ(turns, std::vector<int>(size, 1));
    }
}

}
}
