// The aperiodic sets as data: their numbers, and the rules that they were made by.
#include "tiles/aperiodic/aperiodic_sets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

namespace poissonlab {
namespace {

using testing::ElementsAre;

/// Tiles, horizontal and vertical colours, as the dissertation and Jeandel and Rao print them.
std::array<std::size_t, 3> size_of(const WangList& list)
{
    return {list.tiles.size(), list.colors.horizontal, list.colors.vertical};
}

TEST(AperiodicSets, HaveTheirPrintedNumbers)
{
    EXPECT_THAT(size_of(culik_tiles()), ElementsAre(13, 4, 5));
    EXPECT_THAT(size_of(kari_tiles()), ElementsAre(14, 3, 6));
    EXPECT_THAT(size_of(ammann_tiles()), ElementsAre(16, 6, 6));
    EXPECT_THAT(size_of(robinson_tiles()), ElementsAre(24, 12, 12));
    EXPECT_THAT(size_of(jeandel_rao_tiles()), ElementsAre(11, 4, 4));
    EXPECT_THAT(aperiodic_set_names(), ElementsAre("culik", "kari", "ammann", "robinson", "jeandel-rao"));
}

TEST(AperiodicSets, HaveNoTileTwiceAndNoColourOnOneSideOnly)
{
    for (const AperiodicSet& set : aperiodic_sets()) {
        if (set.name.empty()) continue;
        const WangList list = set.tiles();
        std::set<std::array<Color, 4>> tiles;
        std::set<Color> north, east, south, west;
        for (const WangTile& t : list.tiles) {
            tiles.insert({t.north, t.east, t.south, t.west});
            north.insert(t.north);
            east.insert(t.east);
            south.insert(t.south);
            west.insert(t.west);
        }
        EXPECT_EQ(tiles.size(), list.tiles.size()) << set.name;
        EXPECT_EQ(north, south) << set.name;
        EXPECT_EQ(east, west) << set.name;
        EXPECT_EQ(north.size(), list.colors.horizontal) << set.name;
        EXPECT_EQ(east.size(), list.colors.vertical) << set.name;
    }
}

/// Kari's and Culik's rule in sixths: q N + W = S + E, with what each colour stands for. Tiles of the first machine
/// have vertical colours below `second`.
struct Machines
{
    std::map<Color, int> digits;  ///< of horizontal colours, times 6
    std::map<Color, int> carries; ///< of vertical colours, times 6
    Color second;
    int first_factor, second_factor; ///< times 6
};

void expect_products(const WangList& list, const Machines& m)
{
    for (const WangTile& t : list.tiles) {
        EXPECT_EQ(t.west < m.second, t.east < m.second);
        const int factor = t.west < m.second ? m.first_factor : m.second_factor;
        EXPECT_EQ(factor * m.digits.at(t.north) / 6 + m.carries.at(t.west),
                  m.digits.at(t.south) + m.carries.at(t.east));
    }
}

TEST(AperiodicSets, MultiplyAsKariAndCulikSay)
{
    expect_products(kari_tiles(),
                    {{{0, 0}, {1, 6}, {2, 12}}, {{0, -6}, {1, 0}, {2, -2}, {3, 0}, {4, 2}, {5, 4}}, 2, 12, 4});
    expect_products(culik_tiles(),
                    {{{0, 0}, {1, 6}, {2, 12}, {3, 0}}, {{0, 0}, {1, 6}, {2, 12}, {3, 0}, {4, 3}}, 3, 18, 3});
}

TEST(AperiodicSets, AreKnownByName)
{
    EXPECT_EQ(find_aperiodic_set("kari")->title, "Kari 14/6");
    EXPECT_EQ(find_aperiodic_set("penrose"), nullptr);
    EXPECT_EQ(find_aperiodic_set(""), nullptr);
}

}
}
