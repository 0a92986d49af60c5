// The tilings of small tori with recursive Wang tiles: all that fit, counted by trying every one.
#include "host/tile_sampling/recursive/recursive_points.hpp"

#include "tiles/tilings/even_wang_tiles.hpp"

#include <gtest/gtest.h>

#include <set>

namespace poissonlab {
namespace {

bool fits_on_torus(const RootTiles& tiles, std::uint32_t side)
{
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            if (!may_lie_beside(tiles[y * side + x], tiles[y * side + (x + 1) % side], 1, 0) ||
                !may_lie_beside(tiles[y * side + x], tiles[(y + 1) % side * side + x], 0, 1))
                return false;
    return true;
}

/// All tilings of 2 x 2 tiles of which none is another one shifted.
std::set<RootTiles> all_of_two()
{
    std::set<RootTiles> all;
    for (std::uint32_t word = 0; word < 8 * 8 * 8 * 8; ++word) {
        RootTiles tiles;
        for (std::uint32_t place = 0; place < 4; ++place)
            tiles.push_back(static_cast<std::uint8_t>(word >> 3 * place & 7U));
        if (fits_on_torus(tiles, 2)) all.insert(least_shifted(tiles, 2));
    }
    return all;
}

TEST(RecursiveRoots, AreAllTilingsOfTwoByTwoTiles)
{
    EXPECT_EQ(all_of_two().size(), 14U);
    for (const std::uint64_t seed : {1, 2, 3}) {
        RealizationRoots roots(2, seed);
        std::set<RootTiles> drawn;
        for (std::uint32_t k = 0; k < 14; ++k) drawn.insert(least_shifted(roots.of(k), 2));
        EXPECT_EQ(drawn, all_of_two());
    }
}

TEST(RecursiveRoots, FitAndDifferUntilAllAreDrawn)
{
    for (const auto& [side, different] : {std::pair(3U, 128U), {4U, 300U}}) {
        RealizationRoots roots(side, 7);
        std::set<RootTiles> drawn;
        for (std::uint32_t k = 0; k < different; ++k) {
            EXPECT_TRUE(fits_on_torus(roots.of(k), side));
            EXPECT_TRUE(drawn.insert(least_shifted(roots.of(k), side)).second) << k;
        }
    }
    RealizationRoots all_of_three(3, 7);
    std::set<RootTiles> drawn;
    for (std::uint32_t k = 0; k < 129; ++k) drawn.insert(least_shifted(all_of_three.of(k), 3));
    EXPECT_EQ(drawn.size(), 128U);
}

/// Whichever were asked for before; and hashed ones unless these are there already.
TEST(RecursiveRoots, DependOnTheRealizationOnly)
{
    for (const std::uint32_t side : {1U, 2U, 3U, 4U, 9U}) {
        RealizationRoots in_order(side, 5), alone(side, 5);
        std::vector<RootTiles> all;
        for (std::uint32_t k = 0; k < 6; ++k) all.push_back(in_order.of(k));
        EXPECT_EQ(alone.of(5), all[5]);
        EXPECT_EQ(alone.of(2), all[2]);
        EXPECT_EQ(all[0], hashed_root_tiles(side, stream_key(5, Purpose::recursive_tilings, 0)));
    }
}

}
}
