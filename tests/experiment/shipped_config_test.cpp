// Every config that ships can be run.
#include "experiment/plan.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(ShippedConfigs, ArePlannable)
{
    int count = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(POISSONLAB_SOURCE_DIR "/configs")) {
        if (entry.is_directory()) continue;
        SCOPED_TRACE(entry.path());
        EXPECT_EQ(entry.path().extension(), ".toml");
        const Config config = read_config(entry.path());
        EXPECT_FALSE(make_plan(config).empty() && config.tilings.empty() && config.constructions.empty());
        ++count;
    }
    EXPECT_GE(count, 6);
}

TEST(ShippedConfigs, QuickIsWhatTheReadmePromises)
{
    const Config config = read_config(POISSONLAB_SOURCE_DIR "/configs/quick.toml");
    EXPECT_EQ(config.seed, 1U);
    EXPECT_EQ(config.points, 16384U);
    EXPECT_EQ(config.realizations, 10);
    EXPECT_EQ(make_plan(config).size(), 3U);
}

}
}
