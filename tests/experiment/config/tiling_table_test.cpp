// The tables [[tile_set]] and [[tiling]] of a config.
#include "host/scenes/shown_tiling.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/exhibits.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

std::vector<ShownTiling> tilings_in(const std::string& text) { return settings_in<ShownTiling>(exhibits_in(text)); }

std::string label_in(const std::string& text) { return exhibits_in(text).at(0).label; }

TEST(TilingTable, HasDefaults)
{
    const auto tilings = tilings_in("seed = 7\n[[tile_set]]\n[[tiling]]\n[[tiling]]\nkind = \"cube\"\n");
    ASSERT_EQ(tilings.size(), 3);
    EXPECT_TRUE(tilings[0].is_set());
    EXPECT_EQ(tilings[0].set, "complete");
    EXPECT_EQ(label_in("[[tile_set]]\n"), "Complete set of corner tiles, 2 colours");
    EXPECT_FALSE(tilings[1].is_set());
    EXPECT_EQ(tilings[1].request.kind, TileKind::corner);
    EXPECT_EQ(tilings[1].request.algorithm, "direct");
    EXPECT_EQ(tilings[1].request.hash, HashKind::long_period);
    EXPECT_EQ(exhibits_in("seed = 7\n[[tiling]]\n").at(0).seed, 7);
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
    const ShownTiling& tiling = tilings[1];
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
    EXPECT_EQ(label_in("[[tiling]]\nlabel = \"L\"\n"), "L");
}

TEST(TilingTable, TakesAllKindsOfTiles)
{
    const auto tilings =
        tilings_in("[[tiling]]\nkind = \"domino\"\nwindow = [-3, 7]\n"
                   "[[tiling]]\nkind = \"wang-cube\"\ncolors = 3\n"
                   "[[tiling]]\nkind = \"wang\"\ncolors = 3\nvertical_colors = 2\n"
                   "[[tiling]]\nkind = \"wang\"\ncolors = 3\nindices = [[0, 45], [22, 8], [36, 70]]\n");
    EXPECT_EQ(tilings[0].window.x, -3);
    EXPECT_EQ(tilings[0].window.width, 7);
    EXPECT_EQ(tilings[0].window.height, 1);
    EXPECT_EQ(tilings[1].request.algorithm, "face-hash");
    EXPECT_EQ(tilings[1].window.depth, 4);
    EXPECT_EQ(tilings[2].request.all_colors(), (WangColors{3, 2}));
    EXPECT_EQ(label_in("[[tiling]]\nkind = \"wang\"\ncolors = 3\nvertical_colors = 2\n"),
              "Edge-hash tiling of Wang tiles, 3 x 2 colours");
    EXPECT_EQ(tilings[3].window.width, 2);
    EXPECT_EQ(tilings[3].window.height, 3);
    std::vector<TileIndex> tiles;
    stream_tiles(tilings[3].request, tilings[3].window,
                 [&](auto, auto, auto, auto row) { tiles.insert(tiles.end(), row.begin(), row.end()); });
    EXPECT_EQ(tiles, (std::vector<TileIndex>{0, 45, 22, 8, 36, 70}));
}

TEST(TilingTable, SaysWhichGivenTilesAreWrong)
{
    const auto error_of = [](const std::string& lines) {
        return message_of([&] { tilings_in("[[tiling]]\nkind = \"wang\"\ncolors = 3\n" + lines + "\n"); });
    };
    EXPECT_THAT(error_of("indices = [[0, 1]]"),
                HasSubstr("indices: 1 in row 1, column 2: does not fit to the tile to the west"));
    EXPECT_THAT(error_of("indices = [[0], [54]]"),
                HasSubstr("indices: 54 in row 2, column 1: does not fit to the tile to the north"));
    EXPECT_THAT(error_of("indices = [[81]]"), HasSubstr("indices: 81 in row 1, column 1: must be less than 81"));
    EXPECT_THAT(error_of("indices = [[0, 45], [22]]"), HasSubstr("must be rows"));
    EXPECT_THAT(error_of("indices = [0, 45]"), HasSubstr("must be rows"));
    EXPECT_THAT(error_of("indices = [[0]]\nhash = \"xxh64\""), HasSubstr("has no place beside indices"));
    EXPECT_THAT(error_of("vertical_colors = 1"), HasSubstr("must be an integer from 2 to 256"));
    EXPECT_NO_THROW(tilings_in("[[tiling]]\nkind = \"wang\"\ncolors = 3\nvertical_colors = 2\n"
                               "algorithm = \"scanline-compact\"\n"));
    EXPECT_THAT(message_of([] { tilings_in("[[tiling]]\nkind = \"cube\"\nvertical_colors = 3\n"); }),
                HasSubstr("vertical_colors = 3: is for Wang tiles only"));
    EXPECT_THAT(message_of([] { tilings_in("[[tiling]]\nkind = \"domino\"\nregions = 0.1\n"); }),
                HasSubstr("is for Wang tiles, corner tiles and corner cubes"));
}

TEST(TilingTable, SaysWhatIsAllowed)
{
    const auto error_of = [](const std::string& lines) {
        return message_of([&] { tilings_in("[[tiling]]\n" + lines + "\n"); });
    };
    EXPECT_THAT(error_of("kind = \"hexagon\""),
                HasSubstr("c.toml:2: kind = \"hexagon\": must be one of \"corner\", \"wang\""));
    EXPECT_THAT(error_of("colors = 1"), HasSubstr("c.toml:2: colors = 1: must be an integer from 2 to 256"));
    EXPECT_THAT(error_of("kind = \"cube\"\ncolors = 17"), HasSubstr("must be an integer from 2 to 16"));
    EXPECT_THAT(error_of("algorithm = \"one-hash\""), HasSubstr("must be one of \"direct\", \"scanline\""));
    EXPECT_THAT(error_of("hash = \"md5\""), HasSubstr("must be one of \"permutation\""));
    EXPECT_THAT(error_of("window = [0, 0, 4]"), HasSubstr("must be [X, Y, width, height]"));
    EXPECT_THAT(error_of("window = [0, 0, 4, 0]"), HasSubstr("at least 1 tile along each axis"));
    EXPECT_THAT(error_of("window = [0, 0, 200, 101]"), HasSubstr("at most 20000 in all"));
    EXPECT_THAT(error_of("window = [0, 0, 4, 4.5]"), HasSubstr("must be [X, Y, width, height]"));
    EXPECT_THAT(error_of("period = [-1]"),
                HasSubstr("period = [-1]: must be [MX, MY], or the first of these, integers of at least 0"));
    EXPECT_THAT(error_of("regions = 0.3"), HasSubstr("must be a number from 0 to 0.2071"));
    EXPECT_THAT(error_of("kind = \"cube\"\nregions = 0.2"), HasSubstr("must be a number from 0 to 0.1306"));
    EXPECT_THAT(error_of("algorithm = \"scanline\"\nwindow = [1, 0, 4, 4]"),
                HasSubstr("c.toml:3: window = [1, 0, 4, 4]: with algorithm = \"scanline\", X and Y must be 0"));
    EXPECT_THAT(error_of("tiles = \"compact\""), HasSubstr("unknown key"));
    EXPECT_THAT(message_of([] { tilings_in("[[tile_set]]\ncolors = 12\n"); }), HasSubstr("cannot be drawn"));
    EXPECT_THAT(message_of([] { tilings_in("[[tile_set]]\nkind = \"wang\"\ntiles = \"corner\"\ncolors = 17\n"); }),
                HasSubstr("c.toml:4: colors = 17: must be an integer from 2 to 16"));
    EXPECT_THAT(message_of([] { tilings_in("tiling = 3\n"); }), HasSubstr("written [[tiling]]"));
    EXPECT_THAT(message_of([] { tilings_in("title = \"a\"\n"); }), HasSubstr("no [[method]] table"));
}

}
}
