#include "experiment/config/analysis_options.hpp"

#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

AnalysisOptions options_of(const std::vector<std::string>& overrides, int dimension = 2)
{
    return overridden_analysis(overrides, dimension);
}

TEST(AnalysisOptions, HaveDefaults)
{
    const AnalysisOptions options = options_of({});
    EXPECT_EQ(options.spectrum, PeriodogramMethod::fast);
    EXPECT_EQ(options.spectrum_size, 0);
    EXPECT_EQ(options.bin_width, 1);
    EXPECT_FALSE(options.volume);
    EXPECT_FALSE(options.zone_plate);
    EXPECT_EQ(options.tiles, 0);
    EXPECT_FALSE(options.distances_only);
    EXPECT_FALSE(options.first_points_only);
}

TEST(AnalysisOptions, TakeEveryKey)
{
    const AnalysisOptions plane =
        options_of({"analysis.spectrum=exact", "analysis.spectrum_size=8192", "analysis.zone_plate=true",
                    "analysis.tiles=4096", "analysis.bin_width=2.5"});
    EXPECT_EQ(plane.bin_width, 2.5);
    EXPECT_EQ(plane.spectrum, PeriodogramMethod::exact);
    EXPECT_EQ(plane.spectrum_size, 8192);
    EXPECT_TRUE(plane.zone_plate);
    EXPECT_EQ(plane.tiles, 4096);
    const AnalysisOptions space = options_of({"analysis.volume=true", "analysis.spectrum_size=512"}, 3);
    EXPECT_TRUE(space.volume);
    EXPECT_EQ(space.spectrum_size, 512);
    const AnalysisOptions little =
        options_of({"analysis.spectrum=none", "analysis.measures=distances", "analysis.point_files=first"});
    EXPECT_FALSE(little.spectrum.has_value());
    EXPECT_TRUE(little.distances_only);
    EXPECT_TRUE(little.first_points_only);
}

TEST(AnalysisOptions, ThatNeedSpectraDoNotGoWithNone)
{
    for (const char* key : {"spectrum_size=512", "bin_width=2", "tiles=8"})
        EXPECT_THAT(message_of([&] {
                        options_of({"analysis.spectrum=none", std::string("analysis.") + key});
                    }),
                    testing::HasSubstr("cannot be combined with spectrum = \"none\""));
    EXPECT_THAT(message_of([&] {
                    options_of({"analysis.spectrum=none", "analysis.volume=true"}, 3);
                }),
                testing::HasSubstr("cannot be combined with spectrum = \"none\""));
}

TEST(AnalysisOptions, SayWhatIsAllowed)
{
    const auto error_of = [](const std::string& override, int dimension = 2) {
        return message_of([&] { options_of({"analysis." + override}, dimension); });
    };
    EXPECT_THAT(error_of("spectrum_size=7"), testing::HasSubstr("spectrum_size = 7: must be even"));
    EXPECT_THAT(error_of("spectrum_size=8194"), testing::HasSubstr("must be an integer from 4 to 8192"));
    EXPECT_THAT(error_of("spectrum_size=514", 3), testing::HasSubstr("must be an integer from 4 to 512"));
    EXPECT_THAT(error_of("spectrum=quick"), testing::HasSubstr("must be one of \"fast\", \"exact\", \"none\""));
    EXPECT_THAT(error_of("bin_width=0.5"), testing::HasSubstr("must be a number from 1 to 100"));
    EXPECT_THAT(error_of("bin_width=wide"), testing::HasSubstr("must be a number from 1 to 100"));
    EXPECT_THAT(error_of("tiles=1"), testing::HasSubstr("must be an integer from 2 to 4096"));
    EXPECT_THAT(error_of("zone_plate=true", 3), testing::HasSubstr("needs dimension = 2"));
    EXPECT_THAT(error_of("volume=true"), testing::HasSubstr("needs dimension = 3"));
    EXPECT_THAT(error_of("measures=few"), testing::HasSubstr("must be one of \"all\", \"distances\""));
    EXPECT_THAT(error_of("point_files=none"), testing::HasSubstr("must be one of \"all\", \"first\""));
    EXPECT_THAT(error_of("tile=4"), testing::HasSubstr("did you mean \"tiles\"?"));
}

}
}
