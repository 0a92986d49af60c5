// Scanline tilings: neighbours match, at least two tiles fit everywhere, and all tiles are as frequent.
#include "tiles/tilings/scanline_tiling.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/chi_square.hpp"
#include "tests/tiles/tilings/tile_colors.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace poissonlab {
namespace {

/// Complete and compact sets of 2 to 8 colours, and some with two numbers of colours.
std::vector<TileSet> tile_sets()
{
    std::vector<TileSet> sets;
    for (Color c = 2; c <= 8; ++c) {
        sets.push_back(TileSet::complete(TileKind::wang, c));
        sets.push_back(compact_wang_set(c));
        sets.push_back(TileSet::complete(TileKind::corner, c));
        sets.push_back(compact_corner_set(c));
    }
    sets.push_back(one_hash_wang_set(3));
    sets.push_back(TileSet::complete(TileKind::wang, {2, 5}));
    sets.push_back(TileSet::complete(TileKind::wang, {4, 3}));
    return sets;
}

test::Sides sides(const TileSet& set, TileIndex index)
{
    return set.kind() == TileKind::wang ? test::wang_sides(index, set.colors())
                                        : test::corner_sides(index, set.colors().horizontal);
}

/// Row after row, from the north.
std::vector<std::vector<TileIndex>> rows_of(const TileSet& set, std::uint64_t width, int height, std::uint64_t seed)
{
    ScanlineTiling tiling(set, width, seed);
    std::vector<std::vector<TileIndex>> rows;
    for (int row = 0; row < height; ++row) {
        const auto tiles = tiling.next_row();
        rows.emplace_back(tiles.begin(), tiles.end());
    }
    return rows;
}

/// Tiles of the set that match a side of a tile to the west and one to the north.
std::vector<TileIndex> matching(const TileSet& set, const TileIndex* north, const TileIndex* west)
{
    std::vector<TileIndex> found;
    for (std::uint64_t position = 0; position < set.size(); ++position) {
        const TileIndex index = set.index(position);
        if (north != nullptr && sides(set, *north).south != sides(set, index).north) continue;
        if (west != nullptr && sides(set, *west).east != sides(set, index).west) continue;
        found.push_back(index);
    }
    return found;
}

TEST(ScanlineTiling, NeighboursMatch)
{
    // The equivalent Wang set of corner tiles is left out: it has the corner problem, and nothing fits
    // somewhere.
    for (const TileSet& set : tile_sets()) {
        const auto rows = rows_of(set, 57, 40, 1);
        for (std::size_t y = 0; y < rows.size(); ++y) {
            for (std::size_t x = 0; x < rows[y].size(); ++x) {
                ASSERT_TRUE(set.position(rows[y][x]));
                const test::Sides here = sides(set, rows[y][x]);
                if (x > 0) {
                    ASSERT_EQ(sides(set, rows[y][x - 1]).east, here.west);
                }
                if (y > 0) {
                    ASSERT_EQ(sides(set, rows[y - 1][x]).south, here.north);
                }
            }
        }
    }
}

TEST(ScanlineTiling, WhatFitsIsWhatMatches)
{
    for (const TileSet& set : tile_sets()) {
        if (set.size() > 260) continue; // pairs of tiles, each with all tiles
        const FittingTiles fitting(set);
        const auto expect_matching = [&](const TileIndex* north, const TileIndex* west) {
            const auto choices = fitting.choices(north, west);
            EXPECT_TRUE(std::ranges::equal(choices, matching(set, north, west)));
        };
        expect_matching(nullptr, nullptr);
        for (std::uint64_t i = 0; i < set.size(); i += 13) {
            const TileIndex north = set.index(i);
            expect_matching(&north, nullptr);
            expect_matching(nullptr, &north);
            for (std::uint64_t j = 0; j < set.size(); j += 17) {
                // Tiles with a common corner: of corner tiles, those to the north and west share the
                // north-west.
                const TileIndex west = set.index(j);
                const bool meet =
                    set.kind() == TileKind::wang || test::corner_sides(north, set.colors().horizontal).south[0] ==
                                                        test::corner_sides(west, set.colors().horizontal).east[1];
                if (meet) expect_matching(&north, &west);
            }
        }
    }
}

TEST(ScanlineTiling, ThereAreAlwaysAtLeastTwoChoices)
{
    for (Color c = 2; c <= 8; ++c) {
        EXPECT_EQ(FittingTiles(compact_wang_set(c)).fewest_choices(), 2u);
        EXPECT_EQ(FittingTiles(compact_corner_set(c)).fewest_choices(), 2u);
        EXPECT_EQ(FittingTiles(TileSet::complete(TileKind::wang, c)).fewest_choices(), c * c);
        EXPECT_EQ(FittingTiles(TileSet::complete(TileKind::corner, c)).fewest_choices(), c);
        EXPECT_EQ(FittingTiles(one_hash_wang_set(c)).fewest_choices(), c);
    }
    EXPECT_EQ(FittingTiles(TileSet::complete(TileKind::wang, {2, 5})).fewest_choices(), 10u);
}

TEST(ScanlineTiling, RefusesSetsThatLeaveNoChoice)
{
    // The first leaves one choice somewhere, the second none: nothing fits where two corners do not agree.
    std::vector<TileIndex> indices;
    const TileSet compact = compact_wang_set(3);
    for (std::uint64_t position = 1; position < compact.size(); ++position) indices.push_back(compact.index(position));
    EXPECT_THROW(ScanlineTiling(TileSet(TileKind::wang, {3, 3}, indices), 5, 1), InputError);
    EXPECT_THROW(ScanlineTiling(equivalent_wang_set(TileSet::complete(TileKind::corner, 2)), 5, 1), InputError);
    EXPECT_THROW(ScanlineTiling(TileSet::complete(TileKind::corner, 33), 5, 1), InputError);
    EXPECT_NO_THROW(ScanlineTiling(compact_wang_set(32), 5, 1));
    EXPECT_THROW(ScanlineTiling(compact_wang_set(2), max_scanline_width + 1, 1), InputError);
}

TEST(ScanlineTiling, FollowsFromItsSeedAndNotFromItsSize)
{
    const TileSet set = compact_corner_set(3);
    const auto wide = rows_of(set, 100, 20, 5);
    EXPECT_EQ(rows_of(set, 100, 20, 5), wide);
    EXPECT_NE(rows_of(set, 100, 20, 6), wide);
    const auto narrow = rows_of(set, 31, 25, 5);
    for (std::size_t y = 0; y < wide.size(); ++y)
        EXPECT_TRUE(std::equal(narrow[y].begin(), narrow[y].end(), wide[y].begin()));
}

TEST(ScanlineTiling, StreamsRowsFromNorthToSouth)
{
    const TileSet set = compact_wang_set(4);
    const auto rows = rows_of(set, 10, 6, 2);
    ScanlineTiling tiling(set, 10, 2);
    std::size_t next = 0;
    tiling.stream(6, [&](std::int64_t x, std::int64_t y, std::span<const TileIndex> tiles) {
        EXPECT_EQ(x, 0);
        EXPECT_EQ(y, 5 - static_cast<std::int64_t>(next));
        EXPECT_TRUE(std::ranges::equal(tiles, rows[next]));
        ++next;
    });
    EXPECT_EQ(next, 6u);
}

// In all sets here, a random choice between independent uniform colours to the north and west leaves such
// colours to the south and east. So the colours along a staircase from south-west to north-east are
// independent and uniform, and every second tile along such a diagonal is an independent draw from the whole
// set.
TEST(ScanlineTiling, EveryTileIsAsFrequent)
{
    const auto sets = tile_sets();
    for (const TileSet& set : sets) {
        std::vector<std::uint64_t> counts(set.size());
        const std::uint64_t samples = 20 * std::max<std::uint64_t>(set.size(), 100);
        std::uint64_t seen = 0;
        for (std::uint64_t seed = 0; seen < samples; ++seed) {
            const auto rows = rows_of(set, 32, 32, seed);
            for (std::size_t x = 0; x < 32; x += 2, ++seen) ++counts[set.position(rows[31 - x][x]).value()];
        }
        EXPECT_TRUE(test::are_equally_likely(counts, sets.size()))
            << static_cast<int>(set.kind()) << " " << set.colors().horizontal << " " << set.size();
    }
}

}
}
