// radial.csv, whole and damaged.
#include "results/curve_tables.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace poissonlab {
namespace {

const std::string radial_header = "frequency,power,anisotropy_db,samples,power_error\n";

TEST(RadialTable, ReadsNumbersAsTheyAre)
{
    const TemporaryFolder folder;
    const auto bins = read_radial_table(
        folder.write("radial.csv", radial_header + "1,0.5,-9.75,8,0.25\n2,1.5e-3,inf,12,0\n3,0,nan,16,0\n"));
    ASSERT_EQ(bins.size(), 3);
    EXPECT_EQ(bins[0].power, 0.5);
    EXPECT_EQ(bins[0].anisotropy_db, -9.75);
    EXPECT_EQ(bins[0].power_error, 0.25);
    EXPECT_EQ(bins[1].samples, 12);
    EXPECT_TRUE(std::isinf(bins[1].anisotropy_db));
    EXPECT_TRUE(std::isnan(bins[2].anisotropy_db));
    EXPECT_EQ(peak_power(bins).frequency, 1);
}

TEST(RadialTable, ComplainsWithTheLine)
{
    const TemporaryFolder folder;
    for (const auto* line : {"1,2,3,4", "1,2,3,4,5,6", "1,x,3,4,5", "1, 2,3,4,5", "", "1,nan,3,4,5"}) {
        const auto table = folder.write("radial.csv", radial_header + "1,1,1,8,0\n" + line + "\n2,1,1,8,0\n");
        EXPECT_THAT(message_of([&] { read_radial_table(table); }), testing::HasSubstr("radial.csv:3: ")) << line;
    }
    EXPECT_THROW(read_radial_table(folder.write("radial.csv", radial_header)), InputError);
    for (const auto* samples : {"-1", "nan", "inf", "1e300", "2.5"}) {
        const auto table = folder.write("radial.csv", radial_header + "1,1,1," + samples + ",0\n");
        EXPECT_THAT(message_of([&] { read_radial_table(table); }), testing::HasSubstr("radial.csv:2: samples = "))
            << samples;
    }
}

}
}
