// Lists of tiles, and their files.
#include "tiles/aperiodic/tile_list.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/aperiodic/aperiodic_sets.hpp"
#include "tiles/aperiodic/corner_constructions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(TileList, FindsTilesByTheirColours)
{
    const WangList list = ammann_tiles();
    const TilesByColor find(list);
    for (Color north = 0; north <= list.colors.horizontal; ++north) // the last one does not exist
        for (Color west = 0; west <= list.colors.vertical; ++west) {
            std::vector<ListPlace> with_west, with_north, with_both;
            for (ListPlace i = 0; i < list.tiles.size(); ++i) {
                const WangTile& tile = list.tiles[i];
                if (tile.west == west) with_west.push_back(i);
                if (tile.north == north && tile.west == west) with_both.push_back(i);
                if (tile.north == north) with_north.push_back(i);
            }
            EXPECT_THAT(find.with_west(west), testing::ElementsAreArray(with_west));
            EXPECT_THAT(find.with_north(north), testing::UnorderedElementsAreArray(with_north));
            EXPECT_THAT(find.with_north_and_west(north, west), testing::ElementsAreArray(with_both));
        }
}

TEST(TileList, NumbersColoursAnew)
{
    const std::vector<WangTile> wang{{7, 4, 9, 1}, {9, 1, 7, 1}};
    EXPECT_EQ(renumbered(wang), (WangList{{{0, 1, 1, 0}, {1, 0, 0, 0}}, {2, 2}}));
    const std::vector<CornerTile> corners{{7, 4, 9, 1}};
    EXPECT_EQ(renumbered(corners), (CornerList{{{2, 1, 3, 0}}, 4}));
}

TEST(TileList, ReflectsTiles)
{
    const WangList list{{{0, 1, 2, 3}}, {3, 4}};
    EXPECT_EQ(transposed(list), (WangList{{{3, 2, 1, 0}}, {4, 3}}));
    EXPECT_EQ(transposed(transposed(kari_tiles())), kari_tiles());
}

TEST(TileListFile, ReadsWhatItWrites)
{
    const TemporaryFolder folder;
    const WangList wang = renumbered(culik_tiles().tiles);
    // The numbers of a file are given in the order in which colours come.
    const ReadTiles read = read_tile_list(folder.write("culik.txt", tile_list_text(wang)));
    EXPECT_EQ(read.wang.colors, wang.colors);
    EXPECT_FALSE(read.are_corners());
    EXPECT_THAT(read.warnings, IsEmpty());
    EXPECT_EQ(parse_tile_list(tile_list_text(read.wang), "again").wang, read.wang);
    const CornerList corners = construct_corners(wang, CornerConstruction::rotation).list;
    const ReadTiles read_corners = parse_tile_list(tile_list_text(corners), "corners");
    EXPECT_TRUE(read_corners.are_corners());
    EXPECT_EQ(read_corners.corners.colors, corners.colors);
    EXPECT_EQ(read_corners.wang.tiles.size(), corners.tiles.size());
}

TEST(TileListFile, TakesAnyWordsForColours)
{
    const ReadTiles read = parse_tile_list("# a set\n  red +1 red 0'\n\ngreen 0' red +1 # the second\r\n", "set");
    EXPECT_EQ(read.wang, (WangList{{{0, 0, 0, 1}, {1, 1, 0, 0}}, {2, 2}}));
    EXPECT_THAT(read.warnings,
                ElementsAre("set:4: no tile fits on the north of this one: it cannot occur in a tiling"));
}

TEST(TileListFile, RefusesWhatIsNoSet)
{
    const auto refusal = [](const std::string& text) { return message_of([&] { parse_tile_list(text, "set"); }); };
    EXPECT_EQ(refusal(""), "set: has no tiles");
    EXPECT_EQ(refusal("corner\n# nothing\n"), "set: has no tiles");
    EXPECT_EQ(refusal("0 1 2\n"), "set:1: has 3 words: must be four colours, N E S W");
    EXPECT_EQ(refusal("corner\n0 1 2 3\n0 1 2 3 4\n"), "set:3: has 5 words: must be four colours, NE SE SW NW");
    EXPECT_EQ(refusal("0 1 2 3\nwang\n"), "set:2: has 1 words: must be four colours, N E S W");
    EXPECT_EQ(refusal("0 0 0 0\n1 1 1 1\n0 0 0 0\n"), "set:3: is the tile of line 1 again");
    std::string many;
    for (int i = 0; i <= 65'536; ++i) many += std::to_string(i) + " 0 0 0\n";
    EXPECT_EQ(refusal(many), "set:65537: is a tile too many: at most 65536");
}

}
}
