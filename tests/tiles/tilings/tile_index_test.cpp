// Indices against the polynomials of the dissertation, and back.
#include "tiles/tilings/tile_index.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(TileIndex, IsTheNumberWhoseDigitsAreTheColors)
{
    // Equations 2.1 and 2.5, with base 10: the digits can be read.
    EXPECT_EQ(wang_index({1, 2, 3, 4}, {10, 10}), 1234u);
    EXPECT_EQ(corner_index({1, 2, 3, 4}, 10), 1234u);
    EXPECT_EQ(cube_index({{1, 2, 3, 4}, {5, 6, 7, 8}}, 10), 12345678u);
    EXPECT_EQ(domino_index({1, 2}, 10), 12u);
    // The members are in the order of the dissertation.
    EXPECT_EQ(wang_index({.north = 1, .east = 0, .south = 0, .west = 0}, {3, 3}), 27u);
    EXPECT_EQ(wang_index({.north = 0, .east = 1, .south = 0, .west = 0}, {3, 3}), 9u);
    EXPECT_EQ(corner_index({.north_east = 0, .south_east = 0, .south_west = 1, .north_west = 0}, 3), 3u);
    EXPECT_EQ(corner_index({.north_east = 0, .south_east = 0, .south_west = 0, .north_west = 1}, 3), 1u);
}

TEST(TileIndex, OfWangTilesHasTwoBases)
{
    // 5 horizontal and 7 vertical colours: N has the place value 7 * 5 * 7, E 5 * 7, S 7.
    EXPECT_EQ(wang_index({4, 6, 4, 6}, {5, 7}), 5u * 7 * 5 * 7 - 1);
    EXPECT_EQ(wang_index({1, 0, 0, 0}, {5, 7}), 245u);
    EXPECT_EQ(wang_index({0, 1, 0, 0}, {5, 7}), 35u);
    EXPECT_EQ(wang_index({0, 0, 1, 0}, {5, 7}), 7u);
}

TEST(TileIndex, GoesBothWays)
{
    for (Color c = 2; c <= 8; ++c) {
        for (TileIndex index = 0; index < c * c * c * c; ++index) {
            ASSERT_EQ(corner_index(corner_tile(index, c), c), index);
            ASSERT_LT(corner_tile(index, c).north_east, c);
        }
        for (Color v = 2; v <= 8; ++v) {
            for (TileIndex index = 0; index < c * v * c * v; ++index) {
                const WangTile tile = wang_tile(index, {c, v});
                ASSERT_EQ(wang_index(tile, {c, v}), index);
                ASSERT_TRUE(tile.north < c && tile.south < c && tile.east < v && tile.west < v) << index;
            }
        }
        for (TileIndex index = 0; index < c * c; ++index) ASSERT_EQ(domino_index({index / c, index % c}, c), index);
        // All cubes up to 3 colours, then one in so many as to hit every digit.
        const TileIndex cubes = c * c * c * c * c * c * c * c;
        for (TileIndex index = 0; index < cubes; index += c <= 3 ? 1 : 1009)
            ASSERT_EQ(cube_index(cube_tile(index, c), c), index);
        ASSERT_EQ(cube_index(cube_tile(cubes - 1, c), c), cubes - 1);
    }
}

TEST(TileIndex, FitsForTheMostColors)
{
    EXPECT_EQ(corner_index({255, 255, 255, 255}, max_colors), 0xffffffffu);
    EXPECT_EQ(wang_index({255, 254, 253, 252}, {max_colors, max_colors}), 0xfffefdfcu);
    EXPECT_EQ(wang_tile(0xfffefdfcu, {max_colors, max_colors}), (WangTile{255, 254, 253, 252}));
    const CornerTile all{15, 15, 15, 15};
    EXPECT_EQ(cube_index({all, all}, max_cube_colors), 0xffffffffu);
    EXPECT_EQ(cube_tile(0x12345678u, max_cube_colors), (CornerCube{{1, 2, 3, 4}, {5, 6, 7, 8}}));
}

}
}
