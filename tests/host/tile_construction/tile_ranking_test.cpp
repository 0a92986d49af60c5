// Ranks: an order of the points of each tile, the same on any number of threads.
#include "host/tile_construction/tile_ranking.hpp"

#include "tests/support/random_tile_set.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace poissonlab {
namespace {

PoissonTileSet ranked(PoissonTileSet set)
{
    set.ranks = rank_points(set);
    set.parameters.ranked = true;
    return set;
}

TEST(TileRanks, AreAnOrderOfEachTile)
{
    for (const PoissonTileSet& set :
         {random_tile_set(PoissonTileKind::corner, 2, 2, 7), random_tile_set(PoissonTileKind::corner, 2, 1, 40),
          random_tile_set(PoissonTileKind::corner, 3, 2, 9), random_tile_set(PoissonTileKind::edge, 2, 2, 5),
          random_tile_set(PoissonTileKind::frame, 2, 1, 20, 3), random_chain_set(2, 12)})
        EXPECT_NO_THROW(check_ranks(ranked(set)));
}

TEST(TileRanks, AreTheSameOnAnyNumberOfThreads)
{
    const PoissonTileSet set = random_chain_set(3, 24);
    const auto ranks = rank_points(set);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(rank_points(set), ranks);
}

/// Before anything is near, chance chooses: not always the first point of tiles.
TEST(TileRanks, BeginAnywhere)
{
    const auto ranks = rank_points(random_chain_set(3, 24));
    std::size_t first = 0;
    for (std::size_t tile = 0; tile < 81; ++tile) first += ranks[24 * tile] == 0;
    EXPECT_LT(first, 20U); // 3 are expected
}

}
}
