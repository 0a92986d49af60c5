// The size of a search's tree, the share of it that is done, and which paths lie in its subtrees.
#include "tiles/packing/packing_search.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

/// The number of all nodes below the root, by a plain recursion.
double nodes_below(PackingBoard& board, std::size_t step = 0)
{
    if (step == board.steps()) return 0;
    double nodes = 0;
    ChoiceSet choices = board.choices();
    for (std::size_t choice; (choice = choices.take_first()) != ChoiceSet::none;) {
        board.put(choice);
        nodes += 1 + nodes_below(board, step + 1);
        board.take_back();
    }
    return nodes;
}

/// Knuth's estimator is unbiased: its mean is within five of its own standard errors of the number of nodes.
TEST(PackingEstimate, IsTheNumberOfNodes)
{
    for (const PackingProblem& problem :
         {PackingProblem{TileKind::corner, 2}, PackingProblem{TileKind::corner, 2, PackingMethod::pegs},
          PackingProblem{TileKind::corner, 2, PackingMethod::fewest},
          PackingProblem{TileKind::wang, 2, PackingMethod::symmetric},
          PackingProblem{TileKind::wang, 2, PackingMethod::tiles, {}, true}}) {
        const auto board = make_packing_board(problem);
        const double nodes = nodes_below(*board);
        const PackingTask task = problem.has_first_tile ? PackingTask::count : PackingTask::all;
        EXPECT_EQ(static_cast<double>(search_packings({problem, task}).nodes), nodes);
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const TreeEstimate estimate = estimate_nodes(*board, 20'000, seed);
            EXPECT_LT(estimate.error, 0.1 * nodes);
            EXPECT_NEAR(estimate.nodes, nodes, 5 * estimate.error) << seed;
        }
    }
}

/// The weights of all nodes without choices, and of packings, add up to one.
TEST(PackingEstimate, SharesGrowFromNothingToAll)
{
    for (const PackingMethod method : {PackingMethod::tiles, PackingMethod::pegs, PackingMethod::fewest}) {
        const auto board = make_packing_board({TileKind::corner, 2, method});
        PackingSubtree whole;
        double before = 0;
        for (std::uint64_t until = 1; !whole.is_done; until += 37) {
            walk(*board, whole, {.until_nodes = until});
            EXPECT_GE(whole.share, before);
            EXPECT_LE(whole.share, 1 + 1e-12);
            before = whole.share;
        }
        EXPECT_EQ(whole.share, 1);
        EXPECT_EQ(whole.packings, 32u);
        const CutTree cut = cut_tree(*board, 50);
        double weights = 0;
        std::uint64_t nodes = cut.nodes;
        for (PackingSubtree subtree : cut.subtrees) {
            weights += subtree.weight;
            walk(*board, subtree, {.until_nodes = ~std::uint64_t{0}});
            nodes += subtree.nodes;
        }
        EXPECT_LE(weights, 1 + 1e-12);
        EXPECT_EQ(nodes, whole.nodes);
        const PackingSubtree &root = cut.subtrees.front(), &other = cut.subtrees.back();
        EXPECT_TRUE(has_path(*board, root, root.path));
        EXPECT_FALSE(has_path(*board, root, other.path)) << "the board allows it, but it lies below another root";
        std::vector<std::size_t> wrong = root.path;
        wrong.back() = 639;
        EXPECT_FALSE(has_path(*board, {.path = wrong, .depth = root.depth}, wrong));
        EXPECT_FALSE(has_path(*board, root, {}));
    }
}

TEST(PackingEstimate, SaysHowLongTheRestTakes)
{
    EXPECT_DOUBLE_EQ(
        (PackingProgress{.nodes = 1000, .share = 0.25, .tree_nodes = 7, .nodes_per_second = 10}).seconds_left(), 300);
    EXPECT_DOUBLE_EQ((PackingProgress{.nodes = 1000, .tree_nodes = 3000, .nodes_per_second = 10}).seconds_left(), 200);
    EXPECT_DOUBLE_EQ((PackingProgress{.nodes = 1000, .tree_nodes = 500, .nodes_per_second = 10}).seconds_left(), 0);
}

}
}
