// Packings by search, printed and random ones: the dissertation's counts, tables and statements.
#include "tiles/packing/packings.hpp"

#include "tests/support/chi_square.hpp"
#include "tests/support/errors.hpp"
#include "tiles/packing/closed_packing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace poissonlab {
namespace {

using Corners = std::vector<Color>;

/// All packings of corner tiles over two colours, as rows of corner colours.
std::set<Corners> all_corner_packings()
{
    std::set<Corners> all;
    search_packings(TileKind::corner, 2, {}, [&](const TilePacking& packing) {
        EXPECT_EQ(packing_fault(packing).value_or("none"), "none");
        all.insert(corner_colors_of(packing));
        return true;
    });
    return all;
}

/// Turned by 90 degrees, mirrored, shifted by one place, with the colours exchanged.
std::vector<Corners> neighbours_by_symmetry(const Corners& corners)
{
    std::vector<Corners> images(4, Corners(16));
    for (std::size_t y = 0; y < 4; ++y)
        for (std::size_t x = 0; x < 4; ++x) {
            const Color color = corners[4 * y + x];
            images[0][4 * x + 3 - y] = color;
            images[1][4 * y + 3 - x] = color;
            images[2][4 * y + (x + 1) % 4] = color;
            images[3][4 * y + x] = 1 - color;
        }
    return images;
}

/// D. 5.5.3: 32 solutions, which "reduce to a single fundamental solution".
TEST(PackingSearch, FindsAll32PackingsOfTwoColorsOfCornersFromOneOfThem)
{
    const std::set<Corners> all = all_corner_packings();
    EXPECT_EQ(all.size(), 32u);
    std::set<Corners> reached{*all.begin()};
    for (std::vector<Corners> waiting{*all.begin()}; !waiting.empty();) {
        const Corners corners = waiting.back();
        waiting.pop_back();
        for (const Corners& image : neighbours_by_symmetry(corners))
            if (reached.insert(image).second) waiting.push_back(image);
    }
    EXPECT_EQ(reached, all);
}

TEST(PackingSearch, FindsAll203520WangPackingsOfTwoColors)
{
    std::set<std::vector<TileIndex>> all;
    search_packings(TileKind::wang, 2, {}, [&](const TilePacking& packing) {
        if (all.size() % 1000 == 0) {
            EXPECT_EQ(packing_fault(packing).value_or("none"), "none");
        }
        all.insert(packing.tiles);
        return true;
    });
    EXPECT_EQ(all.size(), 203'520u);
}

TEST(PackingSearch, HasTheSameAnswersInAnyOrder)
{
    std::vector<TileIndex> order;
    for (TileIndex tile = 16; tile-- > 0;) order.push_back(tile);
    std::size_t count = 0;
    search_packings(TileKind::corner, 2, order, [&](const TilePacking&) { return ++count > 0; });
    EXPECT_EQ(count, 32u);
}

TEST(PackingSearch, FindsRandomPackingsOfThreeColors)
{
    for (const TileKind kind : {TileKind::corner, TileKind::wang}) {
        const TilePacking first = random_packing(kind, 3, 1), second = random_packing(kind, 3, 2);
        EXPECT_EQ(packing_fault(first).value_or("none"), "none");
        EXPECT_EQ(packing_fault(second).value_or("none"), "none");
        EXPECT_NE(first.tiles, second.tiles);
        EXPECT_EQ(first.tiles, random_packing(kind, 3, 1).tiles);
    }
    EXPECT_EQ(message_of([] { random_packing(TileKind::corner, 5, 1); }),
              "colors = 5: must be an integer from 2 to 4 for a search");
}

/// The tile of a block over two colours, counted over three.
TileIndex over_three_colors(TileIndex tile) { return corner_index(corner_tile(tile, 2), 3); }

TEST(PackingSearch, GrowsARecursivePackingOfThreeColors)
{
    const TilePacking block = printed_packing(TileKind::corner, 2);
    const TilePacking grown = grown_packing(block, 4);
    EXPECT_EQ(packing_fault(grown).value_or("none"), "none");
    for (Color y = 0; y < 4; ++y)
        for (Color x = 0; x < 4; ++x) EXPECT_EQ(grown.at({x, y}), over_three_colors(block.at({x, y})));
    EXPECT_NE(grown.tiles, printed_packing(TileKind::corner, 3).tiles);
}

TEST(PrintedPackings, AreRecursivePackingsOfTwoThreeAndFourColors)
{
    for (const TileKind kind : {TileKind::corner, TileKind::wang})
        for (Color colors = 2; colors <= 4; ++colors)
            EXPECT_EQ(packing_fault(printed_packing(kind, colors)).value_or("none"), "none") << colors;
    EXPECT_EQ(message_of([] { printed_packing(TileKind::wang, 5); }), "colors = 5: must be an integer from 2 to 4");
}

/// Figure 5.10 shows Wei's packing cell by cell.
TEST(PrintedPackings, HaveTheProductThatTheClosedFormGives)
{
    EXPECT_EQ(printed_product_packing().tiles, closed_packing(TileKind::wang, 3).tiles);
}

TEST(EulerPacking, IsAPacking)
{
    for (Color colors = 2; colors <= 7; ++colors)
        for (std::uint64_t seed = 1; seed <= 5; ++seed)
            EXPECT_EQ(packing_fault(euler_packing(colors, seed)).value_or("none"), "none");
}

/// The BEST theorem: a complete graph of C vertices with loops has C^(C - 2) ((C - 1)!)^C Eulerian circuits, 24 of
/// three colours. All of them come, equally often.
TEST(EulerPacking, HasAllCircuitsEquallyOften)
{
    std::map<std::vector<Color>, std::int64_t> counts;
    constexpr int draws = 24 * 200;
    for (std::uint32_t number = 0; number < draws; ++number) ++counts[random_euler_circle(3, 11, number)];
    EXPECT_EQ(counts.size(), 24u);
    double sum = 0;
    for (const auto& [circle, count] : counts) {
        EXPECT_EQ(circle[0], 0u);
        EXPECT_EQ(circle[1], 0u);
        sum += static_cast<double>((count - 200) * (count - 200)) / 200;
    }
    EXPECT_GT(test::chi_square_tail(sum, 23), 1e-4);
}

}
}
