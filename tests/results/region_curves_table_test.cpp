// region.csv, whole and damaged.
#include "results/curve_tables.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

TEST(RegionCurvesTable, ReadsWhatItWrote)
{
    const TemporaryFolder folder;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    RegionCurveRow row{0.25, 0.1, {1, 2, 3, 4, none}, {0.5, 1.5, 2.5, 3.5, none}, {1.5, 2.5, 3.5, 4.5, 7}};
    const std::string text = region_curves_csv({row, {0.5, 0.75}});
    const auto rows = read_region_curves(folder.write("region.csv", text));
    ASSERT_EQ(rows.size(), 2);
    EXPECT_EQ(rows[0].distance, 0.25);
    EXPECT_EQ(rows[0].k_isotropic, 0.1);
    EXPECT_EQ(rows[0].of(RegionFunction::k), 2);
    EXPECT_TRUE(std::isnan(rows[0].of(RegionFunction::j)));
    EXPECT_EQ(rows[0].low[2], 2.5);
    EXPECT_EQ(rows[0].high[4], 7);
    EXPECT_EQ(region_curves_csv(rows), text);
}

TEST(RegionCurvesTable, ComplainsWithTheLine)
{
    const TemporaryFolder folder;
    std::string text = region_curves_csv({{0.25, 0.1}});
    text.replace(text.find("0.25"), 4, "next");
    EXPECT_THAT(message_of([&] { read_region_curves(folder.write("region.csv", text)); }),
                testing::HasSubstr("region.csv:2"));
}

}
}
