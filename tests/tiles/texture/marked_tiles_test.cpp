// Wang tiles with marked corners against what Cohen and others 2003, section 3.4, count.
#include "tiles/texture/marked_tiles.hpp"

#include "tiles/tilings/scanline_tiling.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace poissonlab {
namespace {

constexpr WangColors two{2, 2};

std::vector<TextureTile> eight_tiles()
{
    std::vector<TextureTile> tiles;
    const TileSet compact = compact_wang_set(2);
    for (std::uint64_t i = 0; i < compact.size(); ++i) tiles.push_back({compact.index(i), 0});
    return tiles;
}

TextureSet marked_set(std::vector<TextureTile> tiles)
{
    TextureSet set;
    set.kind = TextureKind::wang;
    set.colors = marked_colors(two);
    set.classes = 2;
    set.tiles = std::move(tiles);
    return set;
}

TEST(MarkedTiles, AreAsManyAsTheArticleSays)
{
    EXPECT_EQ(marked_set(marked_wang_tiles(eight_tiles(), two)).index_set().size(), 128u);
    EXPECT_EQ(marked_set(randomly_marked_wang_tiles(eight_tiles(), two)).index_set().size(), 64u);
}

TEST(MarkedTiles, TellTheirEdgesAndMarks)
{
    for (TileIndex edges = 0; edges < 16; ++edges)
        for (TileIndex marks = 0; marks < 16; ++marks) {
            const WangTile plain = wang_tile(edges, two), marked = marked_wang_tile(plain, corner_tile(marks, 2));
            EXPECT_TRUE(agrees_on_marks(marked));
            EXPECT_EQ(marks_of(marked_set({}), wang_index(marked, marked_colors(two))), corner_tile(marks, 2));
            EXPECT_EQ((WangTile{marked.north / 4, marked.east / 4, marked.south / 4, marked.west / 4}), plain);
            // Each corner is an end of two edges: a change at one end of one edge is a contradiction.
            for (const Color end : {1u, 2u}) {
                EXPECT_FALSE(agrees_on_marks({marked.north ^ end, marked.east, marked.south, marked.west}));
                EXPECT_FALSE(agrees_on_marks({marked.north, marked.east ^ end, marked.south, marked.west}));
                EXPECT_FALSE(agrees_on_marks({marked.north, marked.east, marked.south ^ end, marked.west}));
                EXPECT_FALSE(agrees_on_marks({marked.north, marked.east, marked.south, marked.west ^ end}));
            }
        }
    TextureSet corners;
    corners.colors = {6, 6};
    corners.classes = 2;
    EXPECT_EQ(marks_of(corners, corner_index({2, 3, 5, 0}, 6)), (CornerTile{0, 1, 1, 0}));
}

/// Two tiles over edges with marks differ in their marks alone where their edges without marks are equal. Tiles over
/// corners do so, too.
TEST(MarkedTiles, KnowWhichOnesDifferInMarksAlone)
{
    const TextureSet set = marked_set(marked_wang_tiles(eight_tiles(), two));
    for (std::size_t i = 0; i < set.tiles.size(); ++i)
        for (std::size_t k = 0; k < set.tiles.size(); ++k)
            ASSERT_EQ(differ_in_marks_alone(set, set.tiles[i].index, set.tiles[k].index), i / 16 == k / 16) << i << k;
    TextureSet corners;
    corners.colors = {6, 6};
    corners.classes = 2;
    const TileIndex tile = corner_index({2, 3, 5, 0}, 6);
    EXPECT_TRUE(differ_in_marks_alone(corners, tile, corner_index({5, 0, 2, 0}, 6)));
    for (const CornerTile& other : {CornerTile{1, 3, 5, 0}, {2, 4, 5, 0}, {2, 3, 4, 0}, {2, 3, 5, 2}})
        EXPECT_FALSE(differ_in_marks_alone(corners, tile, corner_index(other, 6)));
}

/// "The stochastic selection is maintained, since there are only three corners that must match": wherever tiles to the
/// north and west agree on the corner between them, there are two choices, one with each mark in the south-east; with
/// all marks twice as many, so that a map finds both edges.
TEST(MarkedTiles, LeaveTwoChoices)
{
    for (const bool is_random : {false, true}) {
        const TextureSet set = marked_set(is_random ? randomly_marked_wang_tiles(eight_tiles(), two)
                                                    : marked_wang_tiles(eight_tiles(), two));
        const FittingTiles fitting(set.index_set());
        for (const TextureTile& north : set.tiles)
            for (const TextureTile& west : set.tiles) {
                if (marks_of(set, north.index).south_west != marks_of(set, west.index).north_east) continue;
                std::map<Color, int> by_mark;
                for (const TileIndex index : fitting.choices(&north.index, &west.index))
                    ++by_mark[marks_of(set, index).south_east];
                const int each = is_random ? 1 : 2;
                ASSERT_EQ(by_mark, (std::map<Color, int>{{0, each}, {1, each}}));
            }
    }
}

}
}
