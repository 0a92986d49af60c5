// Recursive Wang tiles: points and sub-points as exact multisets, what is refused, and files.
#include "tiles/recursive/recursive_tile_set.hpp"

#include "base/files/whole_file.hpp"
#include "host/tile_construction/recursive/recursive_construction.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace poissonlab {
namespace {

using ::testing::HasSubstr;

/// Tiles that are divided as they should, with links in any order.
RecursiveTiles shuffled_tiles(std::uint32_t points, std::uint64_t seed)
{
    std::mt19937_64 random(seed);
    const auto cells = random_divisions(seed);
    RecursiveTiles tiles;
    for (std::size_t i = 0; i < even_wang_tiles; ++i) {
        tiles[i].children = cells[i];
        for (std::uint32_t cell = 0; cell < recursive_cells; ++cell)
            for (std::uint32_t k = 0; k < points; ++k) tiles[i].links.push_back(RecursiveLink::to(cell, k));
        std::ranges::shuffle(tiles[i].links, random);
    }
    return tiles;
}

/// Own points first, then sub-points: together those of the smaller tiles, each once and to the last bit.
TEST(RecursiveTileSet, PointsAndSubPointsAreThoseOfTheSmallerTiles)
{
    const RecursiveTileSet set(128, 1, shuffled_tiles(128, 1));
    for (std::size_t tile = 0; tile < even_wang_tiles; ++tile) {
        std::vector<RecursivePlace> ranked(set.places(tile)), scaled;
        for (std::uint32_t rank = 128; rank < 16 * 128; ++rank) ranked.push_back(set.place(tile, rank));
        for (std::uint32_t cell = 0; cell < 16; ++cell)
            for (const RecursivePlace& place : set.places(set.tile(tile).children[cell]))
                scaled.push_back({static_cast<std::uint32_t>((std::uint64_t{cell % 4} << 32 | place[0]) / 4),
                                  static_cast<std::uint32_t>((std::uint64_t{cell / 4} << 32 | place[1]) / 4)});
        std::ranges::sort(ranked);
        std::ranges::sort(scaled);
        EXPECT_EQ(ranked, scaled);
    }
}

/// A place's digits to the base of 4 are the cells that its links lead through.
TEST(RecursiveTileSet, PlacesAreTheCellsThatLinksLeadThrough)
{
    const RecursiveTileSet set(128, 2, shuffled_tiles(128, 2));
    for (std::uint32_t point = 0; point < 128; ++point) {
        std::size_t tile = 3;
        std::uint32_t number = point;
        const RecursivePlace place = set.places(tile)[point];
        for (int digit = 1; digit <= 16; ++digit) {
            const RecursiveLink link = set.tile(tile).links[number];
            EXPECT_EQ(place[0] >> (32 - 2 * digit) & 3U, link.cell() % 4);
            EXPECT_EQ(place[1] >> (32 - 2 * digit) & 3U, link.cell() / 4);
            tile = set.tile(tile).children[link.cell()];
            number = link.point();
        }
    }
}

TEST(RecursiveTileSet, RefusesWhatDoesNotFit)
{
    const RecursiveTiles good = shuffled_tiles(128, 3);
    const auto refused = [](std::uint32_t points, const RecursiveTiles& tiles) {
        return refusal_of([&] { RecursiveTileSet(points, 0, tiles); });
    };
    EXPECT_EQ(refused(128, good), "accepted");
    EXPECT_THAT(refused(127, good), HasSubstr("127 points per tile: must be from 128 to 4096"));
    EXPECT_THAT(refused(129, good), HasSubstr("tile 0 does not have each point of its smaller tiles once"));
    RecursiveTiles bad = good;
    bad[5].links[7] = bad[5].links[8];
    EXPECT_THAT(refused(128, bad), HasSubstr("tile 5 does not have each point"));
    bad = good;
    bad[2].children[3] = 8;
    EXPECT_THAT(refused(128, bad), HasSubstr("tile 2 has a smaller tile 8: must be below 8"));
    bad = good;
    bad[2].children[5] ^= 1; // another colour of some edge
    EXPECT_THAT(refused(128, bad), HasSubstr("do not fit beside each other"));
    // All tiles of this one division fit inside, but their borders are not those of their colours.
    bad = good;
    for (RecursiveTile& tile : bad) tile.children = good[0].children;
    std::swap(bad[1].children, bad[0].children);
    bad[7].children = good[7].children;
    EXPECT_THAT(refused(128, bad), HasSubstr("borders of one colour are not divided in one way"));
}

TEST(RecursiveTileFile, HoldsTheSet)
{
    const TemporaryFolder folder;
    const RecursiveTileSet set(200, 0x123456789ABCDEF0, shuffled_tiles(200, 4));
    write_recursive_tiles(folder.path() / "a.rtiles", set);
    EXPECT_EQ(read_recursive_tiles(folder.path() / "a.rtiles"), set);
}

TEST(RecursiveTileFile, IsRefusedWhereItIsDamaged)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.rtiles";
    write_recursive_tiles(file, RecursiveTileSet(128, 5, shuffled_tiles(128, 5)));
    const std::string good = read_whole_file(file);
    const auto refused = [&](const std::string& bytes) {
        write_whole_file(file, bytes);
        return message_of([&] { read_recursive_tiles(file); });
    };
    for (std::size_t i = 0; i < good.size(); i += 1999) {
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ 4);
        EXPECT_THAT(refused(bad), HasSubstr("a.rtiles: ")) << i;
    }
    for (const std::size_t length : {std::size_t{0}, std::size_t{7}, std::size_t{27}, good.size() - 1})
        EXPECT_THAT(refused(good.substr(0, length)), HasSubstr("a.rtiles: ")) << length;
    EXPECT_THAT(refused(good + "x"), HasSubstr("bytes, which do not fit 128 points per tile"));
    EXPECT_THAT(message_of([&] { read_recursive_tiles(folder.path() / "none"); }), HasSubstr("none"));
}

}
}
