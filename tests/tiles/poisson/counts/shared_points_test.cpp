// Points that tiles have in common, against sets where that is known.
#include "tiles/poisson/counts/shared_points.hpp"

#include "tests/support/random_tile_set.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(SharedPoints, OfTilesWithoutAnyAreThoseOfATileWithItself)
{
    const PoissonTileSet set = random_tile_set(PoissonTileKind::corner, 2, 2, 64);
    EXPECT_NEAR(shared_points(set), 1.0 / set.parameters.tiles, 1e-4);
}

/// Pieces of a corner tile's corner come with its colour, C of them; what all tiles share counts whole.
TEST(SharedPoints, CountAsOftenAsTilesHaveThem)
{
    for (const int dimension : {2, 3}) {
        PoissonTileSet set = random_tile_set(PoissonTileKind::corner, dimension, 2, 64);
        const PoissonTileParameters& p = set.parameters;
        const auto d = static_cast<std::size_t>(dimension);
        // The first 8 points of a tile are those of every tile, the next 4 those of the tiles of its half.
        for (std::uint32_t tile = 0; tile < p.tiles; ++tile)
            for (std::size_t i = 0; i < 12; ++i) {
                const std::size_t from = i < 8 ? 0 : tile % 2;
                for (std::size_t k = 0; k < d; ++k)
                    set.points[(tile * std::size_t{p.points_per_tile} + i) * d + k] =
                        set.points[(from * p.points_per_tile + i) * d + k];
            }
        EXPECT_NEAR(shared_points(set), (8 + 4.0 / 2 + 52.0 / p.tiles) / 64, 1e-3);
    }
}

}
}
