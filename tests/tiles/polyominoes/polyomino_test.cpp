// Polyominoes, their divisions and their tori, held against cells that are counted one by one.
#include "tiles/polyominoes/polyomino.hpp"

#include "tiles/polyominoes/neighbourhoods.hpp"

#include <gmock/gmock.h>

#include <map>
#include <set>

namespace poissonlab {
namespace {

class Polyominoes : public ::testing::TestWithParam<Polyomino>
{
protected:
    /// The number of tiles that each cell of a torus has.
    std::map<LatticePlace, int> covers(const std::vector<Pose>& tiles, std::int64_t side) const
    {
        std::map<LatticePlace, int> counts;
        for (const Pose& tile : tiles)
            for (const LatticePlace& cell : cells_of(GetParam())) {
                const LatticePlace at = moved_cell(tile, cell);
                ++counts[{(at.x % side + side) % side, (at.y % side + side) % side}];
            }
        return counts;
    }
};

INSTANTIATE_TEST_SUITE_P(Shapes, Polyominoes, ::testing::Values(Polyomino::P, Polyomino::G),
                         [](const auto& shape) { return polyominoes[shape.param]; });

/// Places are turned about the origin and cells about their middles: a quarter turn takes (x, y) to (-y, x).
TEST(Poses, MoveCellsAsMatricesDo)
{
    EXPECT_EQ(turned(1, LatticePlace{3, 1}), (LatticePlace{-1, 3}));
    EXPECT_EQ(turned(4, LatticePlace{3, 1}), (LatticePlace{-3, 1}));
    EXPECT_EQ(turned(5, LatticePlace{3, 1}), (LatticePlace{-1, -3}));
    std::set<LatticePlace> images;
    for (Turn a = 0; a < turns; ++a) {
        images.insert(turned(a, LatticePlace{3, 1}));
        const Pose pose{{5, -2}, a};
        EXPECT_EQ(composed(pose, inverse(pose)), Pose{});
        // The four corners of the cell's square are those of the moved cell's.
        std::set<LatticePlace> corners, expected;
        const LatticePlace cell = moved_cell(pose, {2, 7});
        for (std::int64_t y = 0; y < 2; ++y)
            for (std::int64_t x = 0; x < 2; ++x) {
                corners.insert(pose(LatticePlace{2 + x, 7 + y}));
                expected.insert(cell + LatticePlace{x, y});
            }
        EXPECT_EQ(corners, expected);
        for (Turn b = 0; b < turns; ++b)
            for (const LatticePlace& at : {LatticePlace{3, 1}, LatticePlace{-2, 5}})
                EXPECT_EQ(composed(pose, Pose{{1, 4}, b})(at), pose(Pose{{1, 4}, b}(at)));
    }
    EXPECT_EQ(images.size(), 8U);
}

TEST_P(Polyominoes, AreDividedIntoWholeCopies)
{
    const PolyominoRule rule = division_rule(GetParam());
    EXPECT_EQ(rule.children.size(), static_cast<std::size_t>(rule.factor * rule.factor));
    std::map<LatticePlace, int> counts;
    for (const Pose& child : rule.children)
        for (const LatticePlace& cell : cells_of(GetParam())) ++counts[moved_cell(child, cell)];
    EXPECT_EQ(counts.size(), rule.children.size() * cells_of(GetParam()).size());
    for (const LatticePlace& cell : cells_of(GetParam()))
        for (std::int64_t y = 0; y < rule.factor; ++y)
            for (std::int64_t x = 0; x < rule.factor; ++x)
                EXPECT_EQ((counts[rule.factor * cell + LatticePlace{x, y}]), 1);
}

/// Two divisions of the P pentomino into four are known; the other one is not the one that is taken.
TEST(ExactCovers, AreAllFound)
{
    CoverProblem all{.columns = 4, .rows = {{0, 1}, {2, 3}, {0, 2}, {1, 3}, {0}, {1, 2, 3}, {0, 3}}};
    using Covers = std::vector<std::vector<std::uint32_t>>;
    EXPECT_THAT(all_exact_covers(all), ::testing::UnorderedElementsAreArray(Covers{{0, 1}, {2, 3}, {4, 5}}));
    all.rows.pop_back();
    all.searches = 3;
    std::set<std::vector<std::uint32_t>> found;
    for (std::uint32_t realization = 0; realization < 30; ++realization)
        found.insert(*exact_cover(all, 1, Purpose::polyomino_seed, realization));
    EXPECT_EQ(found.size(), 3U) << "rows are tried in random order";
    EXPECT_FALSE(exact_cover({.columns = 3, .rows = {{0, 1}, {1, 2}}}, 1, Purpose::polyomino_seed, 0));
    EXPECT_FALSE(exact_cover({.columns = 4, .rows = all.rows, .steps = 1}, 1, Purpose::polyomino_seed, 0))
        << "one step is not enough for two rows";
}

TEST_P(Polyominoes, CoverTheTorusExactlyAtEveryLevel)
{
    const PolyominoRule rule = division_rule(GetParam());
    const auto cells = static_cast<std::int64_t>(cells_of(GetParam()).size());
    std::set<std::vector<Pose>> different;
    for (std::uint32_t realization = 0; realization < 3; ++realization)
        for (const std::int64_t side : {cells, 2 * cells}) {
            std::vector<Pose> tiles = random_torus_tiling(GetParam(), side, 7, realization);
            different.insert(tiles);
            std::int64_t width = side;
            for (int level = 0; level < 2; ++level, width *= rule.factor) {
                const auto counts = covers(tiles, width);
                EXPECT_EQ(counts.size(), static_cast<std::size_t>(width * width));
                EXPECT_TRUE(std::ranges::all_of(counts, [](const auto& count) { return count.second == 1; }));
                tiles = divided(rule, tiles, 1);
            }
        }
    EXPECT_GE(different.size(), 5U);
    EXPECT_TRUE(random_torus_tiling(GetParam(), 7, 1, 0).empty()) << "49 cells are no multiple";
}

}
}
