// The tables [[tile_set]] and [[tiling]] of a config.
#include "host/config/config.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

std::vector<TilingConfig> tilings_in(const std::string& text) { return parse_config(text, "c.toml").tilings; }

TEST(TilingTable, HasDefaults)
{
    const auto tilings = tilings_in("seed = 7\n[[tile_set]]\n[[tiling]]\n[[tiling]]\nkind = \"cube\"\n");
    ASSERT_EQ(tilings.size(), 3);
    EXPECT_TRUE(tilings[0].is_set());
    EXPECT_EQ(tilings[0].set, "complete");
    EXPECT_EQ(tilings[0].label, "Complete set of corner tiles, 2 colours");
    EXPECT_FALSE(tilings[1].is_set());
    EXPECT_EQ(tilings[1].request.kind, TileKind::corner);
    EXPECT_EQ(tilings[1].request.algorithm, "direct");
    EXPECT_EQ(tilings[1].request.hash, HashKind::long_period);
    EXPECT_EQ(tilings[1].request.seed, 7);
    EXPECT_EQ(tilings[1].request.period, Period{});
    EXPECT_EQ(tilings[1].window.width, 16);
    EXPECT_EQ(tilings[1].window.depth, 1);
    EXPECT_EQ(tilings[1].regions, 0);
    EXPECT_EQ(tilings[2].window.depth, 4);
}

TEST(TilingTable, TakesEveryKey)
{
    const auto tilings = tilings_in("[[tiling]]\nkind = \"wang\"\ncolors = 5\nalgorithm = \"two-hashes\"\n"
                                    "hash = \"xxh64\"\nperiod = [32, 8]\nwindow = [-3, 4, 5, 6]\nregions = 0.1\n"
                                    "label = \"L\"\n[[tile_set]]\nkind = \"wang\"\ncolors = 3\ntiles = \"corner\"\n");
    ASSERT_EQ(tilings.size(), 2);
    EXPECT_EQ(tilings[0].set, "corner") << "sets come first";
    EXPECT_EQ(tilings[0].request.colors, 3);
    const TilingConfig& tiling = tilings[1];
    EXPECT_EQ(tiling.request.kind, TileKind::wang);
    EXPECT_EQ(tiling.request.colors, 5);
    EXPECT_EQ(tiling.request.algorithm, "two-hashes");
    EXPECT_EQ(tiling.request.hash, HashKind::xxh64);
    EXPECT_EQ(tiling.request.period, (Period{32, 8, 0}));
    EXPECT_EQ(tiling.window.x, -3);
    EXPECT_EQ(tiling.window.y, 4);
    EXPECT_EQ(tiling.window.width, 5);
    EXPECT_EQ(tiling.window.height, 6);
    EXPECT_EQ(tiling.regions, 0.1);
    EXPECT_EQ(tiling.label, "L");
}

TEST(TilingTable, SaysWhatIsAllowed)
{
    const auto error_of = [](const std::string& lines) {
        return message_of([&] { tilings_in("[[tiling]]\n" + lines + "\n"); });
    };
    EXPECT_THAT(error_of("kind = \"hexagon\""),
                HasSubstr("c.toml:2: kind = \"hexagon\": must be \"corner\" or \"wang\""));
    EXPECT_THAT(error_of("colors = 1"), HasSubstr("c.toml:2: colors = 1: must be an integer from 2 to 256"));
    EXPECT_THAT(error_of("kind = \"cube\"\ncolors = 17"), HasSubstr("must be an integer from 2 to 16"));
    EXPECT_THAT(error_of("algorithm = \"one-hash\""), HasSubstr("must be \"direct\" or \"scanline\""));
    EXPECT_THAT(error_of("hash = \"md5\""), HasSubstr("must be \"permutation\""));
    EXPECT_THAT(error_of("window = [0, 0, 4]"), HasSubstr("must be [X, Y, width, height]"));
    EXPECT_THAT(error_of("window = [0, 0, 4, 0]"), HasSubstr("at least 1 tile along each axis"));
    EXPECT_THAT(error_of("window = [0, 0, 200, 101]"), HasSubstr("at most 20000 in all"));
    EXPECT_THAT(error_of("window = [0, 0, 4, 4.5]"), HasSubstr("must be [X, Y, width, height]"));
    EXPECT_THAT(error_of("period = [-1]"), HasSubstr("period = [-1]: must be a list of tiles"));
    EXPECT_THAT(error_of("regions = 0.3"), HasSubstr("must be a number from 0 to 0.2071"));
    EXPECT_THAT(error_of("kind = \"cube\"\nregions = 0.2"), HasSubstr("must be a number from 0 to 0.1306"));
    EXPECT_THAT(error_of("algorithm = \"scanline\"\nwindow = [1, 0, 4, 4]"), HasSubstr("c.toml:1: "));
    EXPECT_THAT(error_of("tiles = \"compact\""), HasSubstr("unknown key"));
    EXPECT_THAT(message_of([] { tilings_in("[[tile_set]]\ncolors = 12\n"); }), HasSubstr("cannot be drawn"));
    EXPECT_THAT(message_of([] { tilings_in("[[tile_set]]\nkind = \"wang\"\ntiles = \"corner\"\ncolors = 17\n"); }),
                HasSubstr("c.toml:4: colors = 17: must be an integer from 2 to 16"));
    EXPECT_THAT(message_of([] { tilings_in("tiling = 3\n"); }), HasSubstr("written [[tiling]]"));
    EXPECT_THAT(message_of([] { tilings_in("title = \"a\"\n"); }), HasSubstr("no [[method]] table"));
}

}
}
