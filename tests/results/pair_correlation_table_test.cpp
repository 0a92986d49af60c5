// pair-correlation.csv, whole and damaged.
#include "results/curve_tables.hpp"

#include "tests/reports/support/table_errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

const std::string pair_header = "distance,pair_correlation,standard_error,pairs\n";

TEST(PairCorrelationTable, ReadsNumbersAsTheyAre)
{
    const TemporaryFolder folder;
    const auto bins =
        read_pair_correlation_table(folder.write("a.csv", pair_header + "0.25,0,0,0\n0.75,1.5,0.1,12.5\n"));
    ASSERT_EQ(bins.size(), 2);
    EXPECT_EQ(bins[0].distance, 0.25);
    EXPECT_EQ(bins[1].value, 1.5);
    EXPECT_EQ(bins[1].standard_error, 0.1);
    EXPECT_EQ(bins[1].pairs, 12.5);
}

TEST(PairCorrelationTable, ComplainsWithTheLine)
{
    test::expect_table_errors(pair_header, read_pair_correlation_table);
}

}
}
