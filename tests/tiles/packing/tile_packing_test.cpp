// Packings and lists that are none, and packings as text.
#include "tiles/packing/tile_packing.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tiles/packing/closed_packing.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(TilePacking, NamesTilesThatAreThereTwice)
{
    TilePacking packing = closed_packing(TileKind::corner, 2);
    packing.tiles.assign(16, 0);
    EXPECT_EQ(packing_fault(packing), "tile 0 at (1, 0) is there twice");
}

TEST(TilePacking, NamesNeighboursThatDoNotFit)
{
    for (const TileKind kind : {TileKind::corner, TileKind::wang}) {
        TilePacking packing = closed_packing(kind, 2);
        std::swap(packing.tiles[9], packing.tiles[10]);
        const std::string fault = packing_fault(packing).value_or("none");
        EXPECT_NE(fault.find("does not fit to its "), std::string::npos) << fault;
    }
}

/// Two rows exchanged leave all neighbours to the east as they were.
TEST(TilePacking, LooksToTheNorthAsWell)
{
    TilePacking packing = closed_packing(TileKind::wang, 3);
    std::swap_ranges(packing.tiles.begin(), packing.tiles.begin() + 9, packing.tiles.begin() + 9);
    const std::string fault = packing_fault(packing).value_or("none");
    EXPECT_NE(fault.find("northern"), std::string::npos) << fault;
}

TEST(TilePacking, IsItsCorners)
{
    const TilePacking packing = closed_packing(TileKind::corner, 4);
    EXPECT_EQ(packing_of_corner_colors(4, corner_colors_of(packing)).tiles, packing.tiles);
}

class PackingFile : public testing::Test
{
protected:
    std::string refusal(const std::string& text) const
    {
        const std::filesystem::path file = folder_.write("p.txt", text);
        const std::string message = message_of([&] { read_packing(file, TileKind::corner, 2); });
        return message.substr(folder_.path().string().size() + 1);
    }

    TemporaryFolder folder_;
};

TEST_F(PackingFile, HasNorthFirst)
{
    const TilePacking packing =
        read_packing(folder_.write("p.txt", "12 13 14 15\n\n8 9 10 11\n4 5 6 7\r\n0 1 2 3"), TileKind::corner, 2);
    for (TileIndex tile = 0; tile < 16; ++tile) EXPECT_EQ(packing.tiles[tile], tile);
}

TEST_F(PackingFile, SaysWhatIsWrong)
{
    const std::string row = "0 1 2 3\n";
    EXPECT_EQ(refusal(row), "p.txt: 1 rows: must have 4");
    EXPECT_EQ(refusal(row + "0 1 2\n"), "p.txt:2: a row of 3 tiles: must have 4");
    EXPECT_EQ(refusal(row + "\n0 1 2 16\n"), "p.txt:3: tile \"16\": must be an integer from 0 to 15");
    EXPECT_EQ(refusal("0 1 -2 3\n"), "p.txt:1: tile \"-2\": must be an integer from 0 to 15");
    EXPECT_EQ(refusal("0 1 2x 3\n"), "p.txt:1: tile \"2x\": must be an integer from 0 to 15");
    EXPECT_EQ(refusal("0 1 99999999999 3\n"), "p.txt:1: tile \"99999999999\": must be an integer from 0 to 15");
    EXPECT_EQ(refusal(row + row + row + row + row), "p.txt:5: a row too many: there must be 4");
}

}
}
