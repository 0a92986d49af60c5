// Neighbours of tiles fit together, and chance makes them.
#include "tiles/poisson/random_neighbours.hpp"

#include "tests/tiles/poisson/made_up_tile_sets.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace poissonlab {
namespace {

/// Calls for each place around a tile.
template <class Visit>
void visit_places(int dimension, const Visit& visit)
{
    const int layers = dimension == 3 ? 1 : 0;
    for (int z = -layers; z <= layers; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) visit(std::array{x, y, z});
}

class RandomNeighbours : public testing::TestWithParam<PoissonTileParameters>
{
};

/// All tiles that have a corner, an edge or a face in common agree on its variant.
TEST_P(RandomNeighbours, FitTogether)
{
    const PoissonTileParameters& p = GetParam();
    const StreamKey stream = stream_key(1, Purpose::tile_ranking, 0);
    for (std::uint32_t i = 0; i < 200; ++i) {
        const std::uint32_t tile = i * 7919 % p.tiles;
        const NeighbourTiles tiles = random_neighbours(p, tile, stream, i);
        ASSERT_EQ(tiles[neighbour_number(0, 0, 0)], tile);
        std::map<std::pair<int, std::array<int, 3>>, std::uint32_t> variants;
        visit_places(p.dimension, [&](const std::array<int, 3>& place) {
            const std::uint32_t neighbour = tiles[neighbour_number(place[0], place[1], place[2])];
            ASSERT_LT(neighbour, p.tiles);
            for (const PlacedPiece& piece : pieces_around(p, neighbour)) {
                std::array<int, 3> base = place;
                for (std::size_t k = 0; k < 3; ++k) base[k] += piece.base[k];
                const auto known = variants.emplace(std::pair{int{piece.axes}, base}, piece.variant).first;
                ASSERT_EQ(known->second, piece.variant) << "tile " << tile << ", choice " << i;
            }
        });
    }
}

/// Every tile is anywhere sooner or later where the middle one leaves it room: at the upper right of a tile of two
/// colours a fourth of them is, and of template tiles each.
TEST_P(RandomNeighbours, AreAllThatCanBe)
{
    const PoissonTileParameters& p = GetParam();
    if (p.dimension == 3 || p.tiles > 100) GTEST_SKIP() << "too many tiles to see all";
    const StreamKey stream = stream_key(2, Purpose::tile_ranking, 0);
    std::map<std::size_t, std::set<std::uint32_t>> seen;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const NeighbourTiles tiles = random_neighbours(p, 0, stream, i);
        visit_places(2, [&](const std::array<int, 3>& place) {
            const std::size_t number = neighbour_number(place[0], place[1], place[2]);
            seen[number].insert(tiles[number]);
        });
    }
    const bool is_template = p.kind == PoissonTileKind::frame;
    visit_places(2, [&](const std::array<int, 3>& place) {
        const bool across = place[0] != 0 && place[1] != 0, here = place[0] == 0 && place[1] == 0;
        const std::size_t expected = here          ? 1
                                     : is_template ? p.tiles
                                     : across      ? p.tiles / p.colors
                                                   : p.tiles / p.colors / p.colors;
        EXPECT_EQ(seen[neighbour_number(place[0], place[1], 0)].size(), expected);
    });
}

std::string kind_of(const testing::TestParamInfo<PoissonTileParameters>& info) { return kind_name(info.param); }

INSTANTIATE_TEST_SUITE_P(Kinds, RandomNeighbours,
                         testing::Values(corner_parameters(3), edge_parameters(2), template_parameters(5),
                                         sphere_parameters(2)),
                         kind_of);

}
}
