// Constructions of corner tile sets: the dissertation's tables, and what fits where.
#include "tiles/aperiodic/corner_constructions.hpp"

#include "tests/tiles/aperiodic/brute_force_tilings.hpp"
#include "tiles/aperiodic/aperiodic_sets.hpp"
#include "tiles/aperiodic/table_comparison.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

/// The set of a column, such as "13/5"; without tiles where it is not available.
WangList set_of(const PrintedColumn& column)
{
    for (const AperiodicSet& set : aperiodic_sets())
        if (set.tiles != nullptr && set.title.ends_with(" " + column.set)) return counted_tiles(set);
    return {};
}

TEST(CornerConstructions, GiveTheDissertationsTables)
{
    std::size_t columns = 0, numbers = 0;
    for (const PrintedColumn& column : printed_columns()) {
        const WangList wang = set_of(column);
        if (wang.tiles.empty()) continue;
        const std::string what = corner_constructions[column.construction] + (" of " + column.set);
        ++columns;
        // The largest sets, of 160,168 and 1,213,029 tiles, have a test of their own.
        const bool is_large = column.table == "8.3" && (column.set == "13/5" || column.set == "14/6");
        const auto steps = repeat_construction(wang, column.construction, is_large ? 3 : 4);
        if (column.steps.empty()) {
            ASSERT_EQ(steps.size(), 1U);
            EXPECT_TRUE(steps[0].corners.is_ambiguous()) << what;
            continue;
        }
        ASSERT_EQ(steps.size(), is_large ? 3U : 4U) << what;
        EXPECT_EQ(steps[0].corners.white, column.white) << what;
        EXPECT_EQ(steps[0].corners.black, column.black) << what;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            const PrintedStep& printed = column.steps[i];
            EXPECT_EQ(steps[i].corners.list.tiles.size(), printed.tiles) << what << ", step " << i;
            EXPECT_EQ(steps[i].corners.list.colors, printed.colors) << what << ", step " << i;
            EXPECT_EQ(steps[i].wang.tiles.size(), printed.tiles) << what << ", step " << i;
            const bool is_printed = printed.wang_colors > 0; // the tables end with corner tiles
            EXPECT_EQ(is_printed ? color_count(steps[i].wang) : 0, printed.wang_colors) << what << ", step " << i;
            numbers += 3;
        }
    }
    EXPECT_EQ(columns, 20U);
    EXPECT_GT(numbers, 170U);
}

TEST(CornerConstructions, FailWhereTwoPairsOfTilesGiveOneCornerTile)
{
    // Pairs that fit and corner tiles that they give, counted by hand of the sets' rules.
    const auto sizes = [](const WangList& wang, CornerConstruction construction) {
        const ConstructedCorners made = construct_corners(wang, construction);
        return std::pair(made.patterns, made.list.tiles.size());
    };
    EXPECT_EQ(sizes(culik_tiles(), CornerConstruction::horizontal), std::pair(std::size_t{36}, std::size_t{30}));
    EXPECT_EQ(sizes(kari_tiles(), CornerConstruction::horizontal), std::pair(std::size_t{34}, std::size_t{21}));
    EXPECT_EQ(sizes(culik_tiles(), CornerConstruction::vertical), std::pair(std::size_t{53}, std::size_t{47}));
}

TEST(CornerConstructions, BlocksOfDiagonalTilesAreBlocksOfWangTilesOneLarger)
{
    for (const WangList& wang : {culik_tiles(), kari_tiles(), ammann_tiles(), robinson_tiles(), jeandel_rao_tiles()}) {
        const ConstructedCorners made = construct_corners(wang, CornerConstruction::diagonal);
        const WangList again = wang_list_of(made.list);
        for (const auto& [width, height] : {std::pair(1, 1), std::pair(2, 1), std::pair(1, 2), std::pair(2, 2)})
            EXPECT_EQ(TriedRectangles(again, width, height).count(),
                      TriedRectangles(wang, width + 1, height + 1).count());
    }
}

TEST(CornerConstructions, EdgesFitWhereCornersDo)
{
    // Corner tiles and the Wang tiles made from them are the same up to names: every pair fits or does not fit in both.
    for (const CornerConstruction construction :
         {CornerConstruction::diagonal, CornerConstruction::horizontal, CornerConstruction::vertical,
          CornerConstruction::rotation, CornerConstruction::subdivision}) {
        const CornerList corners = construct_corners(ammann_tiles(), construction).list;
        const WangList wang = wang_list_of(corners);
        ASSERT_EQ(corners.tiles.size(), wang.tiles.size());
        for (std::size_t a = 0; a < wang.tiles.size(); ++a)
            for (std::size_t b = 0; b < wang.tiles.size(); ++b) {
                const CornerTile &c = corners.tiles[a], &d = corners.tiles[b];
                EXPECT_EQ(wang.tiles[a].east == wang.tiles[b].west,
                          c.north_east == d.north_west && c.south_east == d.south_west);
                EXPECT_EQ(wang.tiles[a].south == wang.tiles[b].north,
                          c.south_west == d.north_west && c.south_east == d.north_east);
            }
    }
}

/// The corner tiles of an aligned square of four tiles of a subdivision, or of a turned square, come from one Wang
/// tile.
TEST(CornerConstructions, SubdividedTilesFitAsTheWangTilesDo)
{
    const WangList wang = culik_tiles();
    const ConstructedCorners made = construct_corners(wang, CornerConstruction::subdivision);
    const auto& tiles = made.list.tiles;
    // A tile's right half is its first two corner tiles, its left half the next two.
    for (std::size_t a = 0; a < wang.tiles.size(); ++a)
        for (std::size_t b = 0; b < wang.tiles.size(); ++b) {
            const CornerTile &upper_right = tiles[4 * a], &upper_left = tiles[4 * b + 2];
            const bool fits =
                upper_right.north_east == upper_left.north_west && upper_right.south_east == upper_left.south_west;
            EXPECT_EQ(fits, wang.tiles[a].east == wang.tiles[b].west);
            const CornerTile &lower_left = tiles[4 * a + 3], &above = tiles[4 * b + 2];
            EXPECT_EQ(lower_left.south_west == above.north_west && lower_left.south_east == above.north_east,
                      wang.tiles[a].south == wang.tiles[b].north);
        }
}

TEST(CornerConstructions, TurnedTilesMakeACheckerboard)
{
    // No white tile fits beside or above a white one, and no black one beside a black one: D. figures 8.10 and 8.11.
    const ConstructedCorners made = construct_corners(kari_tiles(), CornerConstruction::rotation);
    const WangList wang = wang_list_of(made.list);
    for (std::size_t a = 0; a < wang.tiles.size(); ++a)
        for (std::size_t b = 0; b < wang.tiles.size(); ++b) {
            if ((a < made.white) != (b < made.white)) continue;
            EXPECT_NE(wang.tiles[a].east, wang.tiles[b].west);
            EXPECT_NE(wang.tiles[a].south, wang.tiles[b].north);
        }
}

TEST(CornerConstructions, CornersTakeTheColoursOfPairsOfTiles)
{
    // Two tiles side by side, with different colours everywhere but between them; one above the other likewise.
    const WangList row{{{0, 1, 2, 0}, {1, 2, 3, 1}}, {4, 3}};
    EXPECT_EQ(construct_corners(row, CornerConstruction::horizontal).list,
              (CornerList{{{1, 3, 2, 0}}, 4})); // north-east, south-east, south-west, north-west
    const WangList column{{{0, 1, 1, 0}, {1, 3, 2, 2}}, {3, 4}};
    EXPECT_EQ(construct_corners(column, CornerConstruction::vertical).list, (CornerList{{{1, 3, 2, 0}}, 4}));
    const WangList square{{{0, 1, 1, 0}, {2, 2, 3, 1}, {1, 4, 4, 3}, {3, 5, 5, 4}}, {6, 6}};
    EXPECT_EQ(construct_corners(square, CornerConstruction::diagonal).list, (CornerList{{{1, 3, 2, 0}}, 4}));
    const ConstructedCorners turned = construct_corners(square, CornerConstruction::rotation);
    ASSERT_EQ(turned.black, 1U);
    // East of the upper left tile, south of the upper right one, east of the lower left one, south of the upper left.
    EXPECT_EQ(turned.list.tiles.back(), (CornerTile{6 + 1, 3, 6 + 4, 1}));
}

}
}
