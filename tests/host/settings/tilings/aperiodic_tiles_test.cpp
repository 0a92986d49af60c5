// Aperiodic sets by their words: in [[tile_set]] and [[tiling]], and as tilings of any tiles are.
#include "host/settings/tilings/aperiodic_tiles.hpp"

#include "host/scenes/shown_tiling.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/exhibits.hpp"
#include "tiles/aperiodic/aperiodic_sets.hpp"
#include "tiles/aperiodic/beatty_tiling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(AperiodicTiles, SetsHaveTheirTiles)
{
    const TileSet kari = aperiodic_tile_set(TileKind::wang, "kari");
    EXPECT_EQ(kari.size(), 14U);
    EXPECT_EQ(kari.colors(), (WangColors{6, 6}));
    for (const WangTile& tile : kari_tiles().tiles) EXPECT_TRUE(kari.position(wang_index(tile, {6, 6})));
    EXPECT_EQ(aperiodic_tile_set(TileKind::corner, "ammann-horizontal").size(), 44U);
    EXPECT_EQ(aperiodic_colors("culik-rotation"), 9U);
    EXPECT_EQ(aperiodic_set_words(TileKind::corner).size(), 25U);
    EXPECT_EQ(aperiodic_set_words(TileKind::cube).size(), 0U);
    EXPECT_FALSE(is_aperiodic_word(TileKind::wang, "kari-rotation"));
}

TEST(AperiodicTiles, WindowsAreOfTheTiling)
{
    const auto tiles = aperiodic_window("culik", 4, {-3, 5, 6, 2});
    const auto places = reference::beatty_tiles(BeattyTiling(BeattySet::culik, 4), {-3, 5, 6, 2});
    ASSERT_EQ(tiles.size(), places.size());
    for (std::size_t i = 0; i < tiles.size(); ++i)
        EXPECT_EQ(tiles[i], wang_index(culik_tiles().tiles[places[i]], {5, 5}));
    for (const std::string& word : aperiodic_tiling_words(TileKind::corner)) {
        const TileSet set = aperiodic_tile_set(TileKind::corner, word);
        for (const TileIndex tile : aperiodic_window(word, 1, {0, 0, 6, 5})) EXPECT_TRUE(set.position(tile)) << word;
    }
}

std::vector<ShownTiling> tilings_of(const std::string& text) { return settings_in<ShownTiling>(exhibits_in(text)); }

TEST(AperiodicTiles, AreSetsAndTilingsOfConfigs)
{
    const auto tilings = tilings_of("[[tile_set]]\nkind = \"corner\"\ntiles = \"ammann-horizontal\"\n"
                                    "[[tiling]]\nkind = \"wang\"\nalgorithm = \"kari\"\nwindow = [-2, -2, 5, 5]\n");
    ASSERT_EQ(tilings.size(), 2U);
    EXPECT_EQ(tilings[0].request.colors, 6U);
    EXPECT_EQ(tilings[1].request.colors, 6U);
    std::size_t rows = 0;
    stream_tiles(tilings[1].request, tilings[1].window, [&](auto, auto, auto, auto tiles) {
        ++rows;
        EXPECT_EQ(tiles.size(), 5U);
    });
    EXPECT_EQ(rows, 5U);
    EXPECT_EQ(message_of([] { tilings_of("[[tiling]]\nkind = \"wang\"\nalgorithm = \"kari\"\ncolors = 4\n"); }),
              "c.toml:4: colors = 4: must be an integer from 6 to 6");
    EXPECT_EQ(message_of([] { tilings_of("[[tiling]]\nkind = \"wang\"\nalgorithm = \"kari\"\nperiod = [4]\n"); }),
              "c.toml:4: period = [4]: has no place beside algorithm = \"kari\"");
}

}
}
