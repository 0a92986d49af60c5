// Tile sets: their numbers in the dissertation, and what they are made for.
#include "tiles/tilings/tile_set.hpp"

#include "base/errors/errors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <numeric>
#include <set>

namespace poissonlab {
namespace {

/// The indices of a set, in order.
std::vector<TileIndex> indices_of(const TileSet& set)
{
    std::vector<TileIndex> indices;
    for (std::uint64_t position = 0; position < set.size(); ++position) indices.push_back(set.index(position));
    return indices;
}

TEST(TileSet, CompleteSetsHaveTheNumbersOfTheDissertation)
{
    // Section 2.7, for 2 to 8 colours.
    const std::array<std::uint64_t, 7> expected{16, 81, 256, 625, 1296, 2401, 4096};
    for (Color c = 2; c <= 8; ++c) {
        EXPECT_EQ(TileSet::complete(TileKind::wang, c).size(), expected[c - 2]);
        EXPECT_EQ(TileSet::complete(TileKind::corner, c).size(), expected[c - 2]);
        EXPECT_EQ(TileSet::complete(TileKind::cube, c).size(), expected[c - 2] * expected[c - 2]);
        EXPECT_EQ(TileSet::complete(TileKind::domino, c).size(), c * c);
        for (Color v = 2; v <= 8; ++v)
            EXPECT_EQ(TileSet::complete(TileKind::wang, {c, v}).size(), c * v * c * v); // (Ch Cv)^2
    }
    EXPECT_EQ(TileSet::complete(TileKind::corner, max_colors).size(), std::uint64_t{1} << 32);
    EXPECT_EQ(TileSet::complete(TileKind::cube, max_cube_colors).size(), std::uint64_t{1} << 32);
}

TEST(TileSet, CompactSetsHaveTheNumbersOfTheDissertation)
{
    // Sections 3.2.1 (which leaves out 72, for 6 colours) and 3.2.2; C^3 in section 3.3.2.2.
    const std::array<std::uint64_t, 7> wang{8, 18, 32, 50, 72, 98, 128};
    const std::array<std::uint64_t, 7> corner{16, 54, 128, 250, 432, 686, 1024};
    const std::array<std::uint64_t, 7> one_hash{8, 27, 64, 125, 216, 343, 512};
    for (Color c = 2; c <= 8; ++c) {
        EXPECT_EQ(compact_wang_set(c).size(), wang[c - 2]);
        EXPECT_EQ(compact_corner_set(c).size(), corner[c - 2]);
        EXPECT_EQ(one_hash_wang_set(c).size(), one_hash[c - 2]);
    }
}

TEST(TileSet, CompactSetsLeaveTwoChoicesEverywhere)
{
    for (Color c = 2; c <= 8; ++c) {
        std::map<std::array<Color, 2>, int> north_west;
        std::map<std::array<Color, 2>, int> south_east;
        for (const TileIndex index : indices_of(compact_wang_set(c))) {
            const WangTile tile = wang_tile(index, {c, c});
            ++north_west[{tile.north, tile.west}];
            ++south_east[{tile.south, tile.east}];
        }
        EXPECT_EQ(north_west.size(), c * c);
        EXPECT_EQ(south_east.size(), c * c);
        for (const auto& [colors, count] : north_west) EXPECT_EQ(count, 2);
        for (const auto& [colors, count] : south_east) EXPECT_EQ(count, 2);

        std::map<std::array<Color, 3>, int> corners;
        for (const TileIndex index : indices_of(compact_corner_set(c))) {
            const CornerTile tile = corner_tile(index, c);
            ++corners[{tile.north_east, tile.south_west, tile.north_west}];
        }
        EXPECT_EQ(corners.size(), c * c * c);
        for (const auto& [colors, count] : corners) EXPECT_EQ(count, 2);
    }
}

/// Cohen and others 2003, section 2 and figure 1: 8, 12 and 18 tiles, two for each pair of northern and western
/// colours.
TEST(TileSet, CompactWangSetsMayHaveTwoNumbersOfColours)
{
    for (Color h = 2; h <= 5; ++h)
        for (Color v = 2; v <= 5; ++v) {
            std::map<std::array<Color, 2>, int> north_west, south_east;
            for (const TileIndex index : indices_of(compact_wang_set({h, v}))) {
                const WangTile tile = wang_tile(index, {h, v});
                ++north_west[{tile.north, tile.west}];
                ++south_east[{tile.south, tile.east}];
            }
            EXPECT_EQ(north_west.size(), h * v);
            for (const auto& [colors, count] : north_west) EXPECT_EQ(count, 2);
            EXPECT_EQ(south_east.size(), h * v);
            for (const auto& [colors, count] : south_east) EXPECT_EQ(count, 2);
        }
    EXPECT_EQ(compact_wang_set({2, 3}).size(), 12);
    EXPECT_THROW(compact_wang_set({2, 1}), InputError);
}

TEST(TileSet, CompactSetsHaveTheTilesThatTheyPromise)
{
    for (Color c = 2; c <= 8; ++c) {
        for (const TileIndex index : indices_of(compact_wang_set(c))) {
            const WangTile tile = wang_tile(index, {c, c});
            EXPECT_LT((tile.east + c - tile.north) % c, 2u);
            EXPECT_EQ((tile.east + c - tile.north) % c, (tile.south + c - tile.west) % c);
        }
        for (const TileIndex index : indices_of(compact_corner_set(c))) {
            const CornerTile tile = corner_tile(index, c);
            EXPECT_LT((tile.south_east + 3 * c - tile.north_east - tile.south_west - tile.north_west) % c, 2u);
        }
    }
}

TEST(TileSet, OfTwoColorsTheCompactOnesAreTheKnownOnes)
{
    // The dissertation: the corner set is complete, and both Wang sets are the same; other than for more
    // colours.
    EXPECT_EQ(indices_of(compact_corner_set(2)), indices_of(TileSet::complete(TileKind::corner, 2)));
    EXPECT_EQ(indices_of(compact_wang_set(2)), indices_of(one_hash_wang_set(2)));
    EXPECT_NE(compact_wang_set(3).size(), one_hash_wang_set(3).size());
    EXPECT_TRUE(compact_corner_set(2).is_complete());
    EXPECT_FALSE(compact_corner_set(3).is_complete());
}

TEST(TileSet, TheOneHashSetHasTheSumsOfAllCornerColors)
{
    for (Color c = 2; c <= 8; ++c) {
        std::set<TileIndex> expected;
        for (TileIndex index = 0; index < c * c * c * c; ++index) {
            const CornerTile k = corner_tile(index, c);
            expected.insert(wang_index({(k.north_west + k.north_east) % c, (k.north_east + k.south_east) % c,
                                        (k.south_east + k.south_west) % c, (k.south_west + k.north_west) % c},
                                       {c, c}));
        }
        EXPECT_EQ(indices_of(one_hash_wang_set(c)), std::vector<TileIndex>(expected.begin(), expected.end()));
    }
}

TEST(TileSet, PositionsGoBothWays)
{
    for (const TileSet& set : {compact_corner_set(5), one_hash_wang_set(4), TileSet::complete(TileKind::wang, 3)}) {
        std::set<TileIndex> members;
        for (std::uint64_t position = 0; position < set.size(); ++position) {
            EXPECT_EQ(set.position(set.index(position)), position);
            members.insert(set.index(position));
        }
        const TileIndex complete =
            set.colors().horizontal * set.colors().horizontal * set.colors().vertical * set.colors().vertical;
        for (TileIndex index = 0; index < complete + 5; ++index)
            EXPECT_EQ(set.position(index).has_value(), members.contains(index)) << index;
    }
}

/// True if the Wang tile `east` may be to the east of `west`.
bool fits_east(const WangTile& west, const WangTile& east) { return west.east == east.west; }
bool fits_north(const WangTile& south, const WangTile& north) { return south.north == north.south; }

TEST(TileSet, TheEquivalentWangTilesFitWhereTheCornerTilesFit)
{
    for (const Color c : {2u, 3u}) {
        const TileSet corners = TileSet::complete(TileKind::corner, c);
        EXPECT_EQ(equivalent_wang_set(corners).size(), corners.size());
        EXPECT_EQ(equivalent_wang_set(corners).colors(), (WangColors{c * c, c * c}));
        for (TileIndex i = 0; i < corners.size(); ++i) {
            const CornerTile a = corner_tile(i, c);
            const WangTile wang_a = equivalent_wang_tile(a, c);
            EXPECT_TRUE(equivalent_wang_set(corners).position(wang_index(wang_a, {c * c, c * c})));
            for (TileIndex j = 0; j < corners.size(); ++j) {
                const CornerTile b = corner_tile(j, c);
                const WangTile wang_b = equivalent_wang_tile(b, c);
                EXPECT_EQ(fits_east(wang_a, wang_b), a.north_east == b.north_west && a.south_east == b.south_west);
                EXPECT_EQ(fits_north(wang_a, wang_b), a.north_west == b.south_west && a.north_east == b.south_east);
            }
        }
    }
    EXPECT_EQ(equivalent_wang_set(compact_corner_set(4)).size(), 128u);
}

TEST(TileSet, RefusesColorsThatItCannotCount)
{
    EXPECT_THROW(TileSet::complete(TileKind::wang, 1), InputError);
    EXPECT_THROW(TileSet::complete(TileKind::wang, {2, 257}), InputError);
    EXPECT_THROW(TileSet::complete(TileKind::corner, 257), InputError);
    EXPECT_THROW(TileSet::complete(TileKind::cube, 17), InputError);
    EXPECT_THROW(compact_wang_set(1), InputError);
    EXPECT_THROW(compact_corner_set(0), InputError);
    EXPECT_THROW(one_hash_wang_set(300), InputError);
    EXPECT_THROW(equivalent_wang_set(TileSet::complete(TileKind::corner, 17)), InputError);
    EXPECT_THROW(TileSet(TileKind::corner, {2, 2}, {3, 3}), std::logic_error);
    EXPECT_THROW(TileSet(TileKind::corner, {2, 2}, {16}), std::logic_error);
}

TEST(TileSet, TheCompactSetOverTwoColorsIsTheOneOfTheClassNotes)
{
    const TileSet set = compact_wang_set(2);
    std::vector<TileIndex> tiles;
    for (std::uint64_t i = 0; i < set.size(); ++i) tiles.push_back(set.index(i));
    EXPECT_EQ(tiles, (std::vector<TileIndex>{0, 3, 5, 6, 9, 10, 12, 15}));
}

}
}
