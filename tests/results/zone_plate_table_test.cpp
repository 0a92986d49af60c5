// zone-plate.csv, whole and damaged.
#include "results/curve_tables.hpp"

#include "tests/reports/support/table_errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

const std::string zone_plate_header = "distance,frequency,rms_error,pixels\n";

TEST(ZonePlateTable, ReadsNumbersAsTheyAre)
{
    const TemporaryFolder folder;
    const auto bins =
        read_zone_plate_table(folder.write("a.csv", zone_plate_header + "0.25,0.01,0.5,8\n0.75,0.02,0,12\n"));
    ASSERT_EQ(bins.size(), 2);
    EXPECT_EQ(bins[0].distance, 0.25);
    EXPECT_EQ(bins[0].frequency, 0.01);
    EXPECT_EQ(bins[0].rms_error, 0.5);
    EXPECT_EQ(bins[1].pixels, 12);
}

TEST(ZonePlateTable, ComplainsWithTheLine) { test::expect_table_errors(zone_plate_header, read_zone_plate_table); }

}
}
