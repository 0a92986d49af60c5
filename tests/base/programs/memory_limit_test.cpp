#include "base/programs/memory_limit.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include <sys/resource.h>

namespace poissonlab {
namespace {

/// /proc/meminfo counts in KiB.
TEST(MemoryLimit, IsAtMostWhatTheSystemSaysThatTheMachineHas)
{
    std::ifstream system("/proc/meminfo");
    std::string word;
    std::uint64_t kibibytes = 0;
    system >> word >> kibibytes;
    ASSERT_EQ(word, "MemTotal:");
    EXPECT_GT(memory_limit(), 0u);
    EXPECT_LE(memory_limit(), kibibytes * 1024);
}

TEST(MemoryLimit, IsThatOfAddressesWhereThisIsLess)
{
    struct rlimit old = {};
    ASSERT_EQ(::getrlimit(RLIMIT_AS, &old), 0);
    const rlim_t granted = memory_limit() - 4096;
    const struct rlimit limit = {granted, old.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_AS, &limit), 0);
    EXPECT_EQ(memory_limit(), granted);
    EXPECT_LE(memory_limit(2), granted / 2 + 4096) << "the machine's memory is divided";
    const struct rlimit small = {granted / 4, old.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_AS, &small), 0);
    EXPECT_EQ(memory_limit(2), granted / 4) << "each process has its own addresses";
    ::setrlimit(RLIMIT_AS, &old);
}

}
}
