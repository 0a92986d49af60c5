// Packings in closed form: each is a packing, by the lemma and by its neighbours, and place and tile lead to each
// other.
#include "tiles/packing/closed_packing.hpp"

#include "tests/support/errors.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace poissonlab {
namespace {

class ClosedPacking : public testing::TestWithParam<Color>
{
};

/// The lemma: all windows of 2 x 2 corner colours differ, counted here from the colours alone.
TEST_P(ClosedPacking, OfCornerTilesHasEveryWindowOnce)
{
    const Color colors = GetParam(), side = colors * colors;
    std::set<std::array<Color, 4>> windows;
    const auto color = [&](Color x, Color y) { return packed_corner_color({x % side, y % side}, colors); };
    for (Color y = 0; y < side; ++y)
        for (Color x = 0; x < side; ++x) {
            EXPECT_LT(color(x, y), colors);
            windows.insert({color(x, y), color(x + 1, y), color(x, y + 1), color(x + 1, y + 1)});
        }
    EXPECT_EQ(windows.size(), std::size_t{side} * side);
}

TEST_P(ClosedPacking, OfBothKindsFitsAndHasEveryTile)
{
    for (const TileKind kind : {TileKind::corner, TileKind::wang}) {
        const TilePacking packing = closed_packing(kind, GetParam());
        EXPECT_EQ(packing.tiles.size(), std::size_t{packing.side()} * packing.side());
        EXPECT_EQ(packing_fault(packing).value_or("none"), "none");
    }
}

TEST_P(ClosedPacking, KnowsThePlaceOfEveryTile)
{
    const Color side = GetParam() * GetParam();
    for (const TileKind kind : {TileKind::corner, TileKind::wang})
        for (Color y = 0; y < side; ++y)
            for (Color x = 0; x < side; ++x) {
                const PackingPlace place{x, y};
                ASSERT_EQ(place_of_tile(kind, packed_tile(kind, place, GetParam()), GetParam()), place)
                    << tile_kinds[kind] << " " << x << " " << y;
            }
}

INSTANTIATE_TEST_SUITE_P(Colors, ClosedPacking, testing::Range(Color{2}, Color{17}));

TEST(ClosedPacking, ReachesTheLargestNumberOfColors)
{
    const Color colors = max_colors, side = colors * colors;
    for (const Color each : {colors, colors - 1})
        for (const PackingPlace place : {PackingPlace{0, 0}, PackingPlace{side - 600, 12'345}, PackingPlace{3, 60'000}})
            for (const TileKind kind : {TileKind::corner, TileKind::wang})
                EXPECT_EQ(place_of_tile(kind, packed_tile(kind, place, each), each), place);
}

TEST(ClosedPacking, HasEveryPairOfColorsOnceOnItsCircle)
{
    for (Color colors = 2; colors < 12; ++colors) {
        std::set<std::pair<Color, Color>> pairs;
        for (Color n = 0; n < colors * colors; ++n) {
            const Color here = euler_color(n, colors), next = euler_color((n + 1) % (colors * colors), colors);
            pairs.insert({here, next});
            EXPECT_EQ(euler_place(here, next, colors), n);
        }
        EXPECT_EQ(pairs.size(), std::size_t{colors} * colors);
    }
}

/// Wei's order for three colours as dissertation and article print it: 00 01 11 10 02 21 12 22 20.
TEST(ClosedPacking, HasWeisOrderOfDominoes)
{
    const std::array<Color, 10> circle{0, 0, 1, 1, 0, 2, 1, 2, 2, 0};
    for (Color place = 0; place < 9; ++place) {
        EXPECT_EQ(wei_color(place), circle[place]);
        EXPECT_EQ(wei_place(circle[place], circle[place + 1]), place);
    }
}

TEST(ClosedPacking, RefusesNumbersOfColorsThatItCannotHold)
{
    EXPECT_EQ(message_of([] { closed_packing(TileKind::wang, 1); }), "colors = 1: must be an integer from 2 to 32");
    EXPECT_EQ(message_of([] { closed_packing(TileKind::corner, 33); }), "colors = 33: must be an integer from 2 to 32");
}

}
}
