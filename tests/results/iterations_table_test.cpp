// iterations.csv, whole and damaged.
#include "results/series.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

const std::string header = "realization,iteration,relative_radius,energy\n";

TEST(IterationsTable, IsReadAsItWasWritten)
{
    const TemporaryFolder folder;
    const IterationRecords records = {{{0.1, 2.5}, {1.0 / 3, 2.25}}, {{0.2, 7}}};
    const IterationRecords read = read_iterations_table(folder.write("a.csv", iterations_csv(records)));
    ASSERT_EQ(read.size(), 2);
    ASSERT_EQ(read[0].size(), 2);
    ASSERT_EQ(read[1].size(), 1);
    EXPECT_EQ(read[0][1].relative_radius, 1.0 / 3);
    EXPECT_EQ(read[0][1].energy, 2.25);
    EXPECT_EQ(read[1][0].relative_radius, 0.2);
}

/// Tiles have a further column, in which all records have a number or none has.
TEST(IterationsTable, HasRadiiWithinTilesWhereAllRecordsHave)
{
    const TemporaryFolder folder;
    IterationRecords records = {{{0.1, 0, 0.7}, {0.3, 0, 1.0 / 3}}};
    const std::string text = iterations_csv(records);
    EXPECT_THAT(text,
                testing::StartsWith("realization,iteration,relative_radius,energy,relative_radius_within_tiles\n"));
    EXPECT_EQ(read_iterations_table(folder.write("a.csv", text)), records);
    const auto means = iterations_of(records);
    ASSERT_TRUE(means && means->relative_radius_within_tiles);
    EXPECT_EQ(means->relative_radius_within_tiles->mean, (std::vector<double>{0.7, 1.0 / 3}));
    records[0][1].relative_radius_within_tiles.reset();
    EXPECT_THAT(iterations_csv(records), testing::StartsWith(header));
    EXPECT_FALSE(iterations_of(records)->relative_radius_within_tiles);
}

TEST(IterationsTable, ComplainsOfWhatDoesNotFollow)
{
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& rows) {
        const auto file = folder.write("a.csv", header + rows);
        return refusal_of([&] { read_iterations_table(file); });
    };
    EXPECT_THAT(refusal("0,0,0.5,1\n0,2,0.5,1\n"), testing::HasSubstr("a.csv:3: realization 0, iteration 2"));
    EXPECT_THAT(refusal("1,0,0.5,1\n"), testing::HasSubstr("a.csv:2: realization 1, iteration 0"));
    EXPECT_THAT(refusal("0,0.5,0.5,1\n"), testing::HasSubstr("iteration = 0.5"));
    EXPECT_THAT(refusal(""), testing::HasSubstr("iterations"));
}

}
}
