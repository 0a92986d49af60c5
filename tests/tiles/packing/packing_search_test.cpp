// Packings by search, printed and random ones: the dissertation's counts, tables and statements.
#include "tiles/packing/packing_search.hpp"

#include "tests/support/chi_square.hpp"
#include "tests/support/errors.hpp"
#include "tiles/packing/closed_packing.hpp"
#include "tiles/packing/packings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace poissonlab {
namespace {

using Corners = std::vector<Color>;

/// All packings of corner tiles over two colours, as rows of corner colours.
std::set<Corners> all_corner_packings(PackingMethod method)
{
    std::set<Corners> all;
    const FoundPackings found = search_packings({.problem = {TileKind::corner, 2, method}, .task = PackingTask::all});
    for (const TilePacking& packing : found.packings) {
        EXPECT_EQ(packing_fault(packing).value_or("none"), "none");
        all.insert(corner_colors_of(packing));
    }
    EXPECT_EQ(all.size(), found.count);
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
    const std::set<Corners> all = all_corner_packings(PackingMethod::tiles);
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

/// Pegs find what tiles find, and visit fewer nodes of their trees: D. says that they seem to be faster.
TEST(PackingSearch, FindsThePackingsWithPegsAsWellInFewerSteps)
{
    const std::set<Corners> all = all_corner_packings(PackingMethod::tiles);
    EXPECT_EQ(all_corner_packings(PackingMethod::pegs), all);
    EXPECT_EQ(all_corner_packings(PackingMethod::fewest), all);
    std::vector<std::uint64_t> nodes;
    for (const PackingMethod method : {PackingMethod::tiles, PackingMethod::pegs, PackingMethod::fewest})
        nodes.push_back(search_packings({.problem = {TileKind::corner, 2, method}, .task = PackingTask::count}).nodes);
    EXPECT_EQ(nodes, (std::vector<std::uint64_t>{440, 219, 95}));
}

TEST(PackingSearch, FindsAll203520WangPackingsOfTwoColors)
{
    const FoundPackings found = search_packings({.problem = {TileKind::wang, 2}, .task = PackingTask::all});
    std::set<std::vector<TileIndex>> all;
    for (const TilePacking& packing : found.packings) {
        if (all.size() % 1000 == 0) {
            EXPECT_EQ(packing_fault(packing).value_or("none"), "none");
        }
        all.insert(packing.tiles);
    }
    EXPECT_EQ(all.size(), 203'520u);
    EXPECT_TRUE(std::ranges::is_sorted(found.packings, {}, &TilePacking::tiles)) << "lexicographic order";
}

/// Each packing has C^4 translations, one of which has tile 0 in the south-west: these are searched and multiplied.
TEST(PackingSearch, CountsWithOneOfAllTranslations)
{
    for (const PackingMethod method : {PackingMethod::tiles, PackingMethod::pegs, PackingMethod::fewest})
        EXPECT_EQ(search_packings({.problem = {TileKind::corner, 2, method}, .task = PackingTask::count}).count, 32u);
    EXPECT_EQ(search_packings({.problem = {TileKind::wang, 2}, .task = PackingTask::count}).count, 203'520u);
}

TEST(PackingSearch, HasTheSameAnswersInAnyOrder)
{
    for (const PackingMethod method : {PackingMethod::tiles, PackingMethod::pegs, PackingMethod::fewest})
        for (std::uint64_t seed = 0; seed < 4; ++seed)
            EXPECT_EQ(search_packings({.problem = {TileKind::corner, 2, method, seed}, .task = PackingTask::all}).count,
                      32u);
}

TEST(PackingSearch, FindsRandomPackingsOfThreeColors)
{
    const auto found = [](TileKind kind, PackingMethod method, std::uint64_t seed) {
        const TilePacking packing = random_packing(kind, 3, method, seed);
        EXPECT_EQ(packing_fault(packing).value_or("none"), "none");
        return packing.tiles;
    };
    for (const TileKind kind : {TileKind::corner, TileKind::wang})
        for (const PackingMethod method : {PackingMethod::tiles, PackingMethod::fewest, PackingMethod::symmetric}) {
            if (kind == TileKind::wang && method == PackingMethod::fewest) continue;
            const auto first = found(kind, method, 1);
            EXPECT_NE(first, found(kind, method, 2));
            EXPECT_EQ(first, found(kind, method, 1));
        }
}

/// D. 5.5.3: one of four colours took 280 days and 23 years, without symmetries.
TEST(PackingSearch, FindsSymmetricPackingsOfUpToFiveColors)
{
    for (const TileKind kind : {TileKind::corner, TileKind::wang})
        for (Color colors = kind == TileKind::wang ? 2 : 3; colors <= 5; ++colors) {
            const TilePacking packing = random_packing(kind, colors, PackingMethod::symmetric, 2);
            EXPECT_EQ(packing_fault(packing).value_or("none"), "none") << colors;
            // All colours are moved on by one where all digits are, without a carry.
            const auto moved_on = [colors](TileIndex tile) {
                TileIndex moved = 0;
                for (TileIndex place = 1; place < colors * colors * colors * colors; place *= colors)
                    moved += place * ((tile / place + 1) % colors);
                return moved;
            };
            for (Color y = 0; y < packing.side(); ++y)
                for (Color x = 0; x < packing.side(); ++x)
                    EXPECT_EQ(packing.at({(x + colors) % packing.side(), y}), moved_on(packing.at({x, y})));
        }
    EXPECT_EQ(search_packings({.problem = {TileKind::corner, 2, PackingMethod::symmetric}}).count, 0u);
}

TEST(PackingSearch, RefusesWhatIsNotSearched)
{
    const auto refusal = [](TileKind kind, Color colors, PackingMethod method) {
        return message_of([&] { random_packing(kind, colors, method, 1); });
    };
    for (const Color colors : {0u, 1u, 5u})
        EXPECT_EQ(refusal(TileKind::corner, colors, PackingMethod::tiles),
                  "colors = " + std::to_string(colors) + ": must be an integer from 2 to 4 for a search");
    EXPECT_EQ(refusal(TileKind::wang, 6, PackingMethod::symmetric),
              "colors = 6: must be an integer from 2 to 5 for a search");
    EXPECT_EQ(refusal(TileKind::wang, 2, PackingMethod::fewest), "pegs are for corner tiles");
    EXPECT_EQ(refusal(TileKind::corner, 2, PackingMethod::symmetric), "there is no such packing of 2 colours");
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
