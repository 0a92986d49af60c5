// Tables [[distribution]] of a config, and what they refuse.
#include "host/config/distributions/distribution_table.hpp"

#include "host/config/config.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

std::vector<DistributionConfig> distributions_of(const std::string& lines)
{
    const Config config = parse_config("seed = 7\n[[distribution]]\n" + lines, "c.toml");
    return read_distributions(config.distributions, config.seed);
}

void expect_refusal(const std::string& lines, const std::string& message)
{
    EXPECT_THAT(message_of([&] { distributions_of(lines); }), HasSubstr(message)) << lines;
}

TEST(DistributionTable, ReadsAWarp)
{
    const auto read = distributions_of("kind = \"warp\"\ndensity = \"x+1\"\npoints = 12\n"
                                       "method = { sampler = \"dart-throwing\", relative_radius = 0.7 }");
    ASSERT_EQ(read.size(), 1);
    EXPECT_EQ(read[0].kind, "warp");
    EXPECT_EQ(read[0].label, "Warped points by x+1");
    EXPECT_EQ(read[0].seed, 7);
    const WarpSettings& settings = std::get<WarpSettings>(read[0].settings);
    EXPECT_EQ(settings.points, 12);
    EXPECT_FALSE(settings.is_environment);
    ASSERT_TRUE(settings.method.sampler);
    EXPECT_EQ(settings.method.sampler->parameters.number("relative_radius"), 0.7);
}

/// The text is part of the keys of stored work: it must differ wherever a table does.
TEST(DistributionTable, IsTheWholeTableAsText)
{
    const auto read = distributions_of("kind = \"warp\"\ndensity = \"x+1\"\npoints = 12\n"
                                       "method = { sampler = \"dart-throwing\", relative_radius = 0.70 }");
    EXPECT_EQ(read[0].text, "kind = \"warp\", density = \"x+1\", points = 12, method = { sampler = \"dart-throwing\", "
                            "relative_radius = 0.70, }, ");
}

TEST(DistributionTable, RefusesWhatItDoesNotKnow)
{
    expect_refusal("kind = \"wrap\"", "c.toml:3: kind = \"wrap\": must be");
    expect_refusal("density = \"x+1\"\npoints = 12\ncolour = 3", "c.toml:5: colour");
    expect_refusal("points = 12", "c.toml:2: [[distribution]]: needs density");
    expect_refusal("density = \"x+1\"", "c.toml:2: [[distribution]]: needs points");
    expect_refusal("density = \"x+\"\npoints = 12", "c.toml:3: density: formula \"x+\"");
    expect_refusal("density = \"none.png\"\npoints = 12", "c.toml:3: density: none.png: no such file");
    expect_refusal("density = \"x+1\"\npoints = 0", "c.toml:4: points = 0: must be");
    expect_refusal("density = \"x+1\"\npoints = 9\nmethod = \"regula\"",
                   "c.toml:5: method = \"regula\": must be one of");
    expect_refusal("density = \"x+1\"\npoints = 9\ntiles = \"none.ptiles\"", "must be a tile set's file");
    expect_refusal("density = \"x+1\"\npoints = 9\ntiles = \"a\"\nmethod = \"random\"", "does not go with method");
    expect_refusal("density = \"x+1\"\ndensity_from = \"ink\"\npoints = 9", "\"ink\" is for pictures");
}

}
}
