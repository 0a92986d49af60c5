// The search for periods: against a SAT solver, against trying everything, and on sets whose periods are known.
#include "tiles/aperiodic/cylinder_search.hpp"

#include "tests/support/errors.hpp"
#include "tests/tiles/aperiodic/brute_force_tilings.hpp"
#include "tests/tiles/aperiodic/sat_tiling.hpp"
#include "tiles/aperiodic/aperiodic_sets.hpp"
#include "tiles/aperiodic/corner_constructions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::Each;
using testing::Gt;
using testing::SizeIs;

constexpr int sat_width = 4;

/// The tallest cylinder as SAT sees it: it exists, and no taller one does. None is shorter than a torus with any shear.
void expect_heights_by_sat(const WangList& list, CylinderAxis axis)
{
    const WangList turned = axis == CylinderAxis::horizontal ? list : transposed(list);
    for (int width = 1; width <= sat_width; ++width) {
        const Cylinder found = longest_cylinder(list, static_cast<std::size_t>(width), axis);
        ASSERT_FALSE(found.period) << width;
        const int height = static_cast<int>(found.height);
        EXPECT_TRUE(height == 0 || SatTiling(turned, {width, height, true}).exists()) << width;
        EXPECT_FALSE(SatTiling(turned, {width, height + 1, true}).exists()) << width;
        for (int torus_height = 1; torus_height <= 4; ++torus_height)
            for (int shear = 0; shear < width; ++shear)
                EXPECT_FALSE(SatTiling(turned, {width, torus_height, true, true, shear}).exists())
                    << width << " x " << torus_height << ", " << shear;
    }
}

class CylinderSearch : public testing::TestWithParam<const char*>
{
};

TEST_P(CylinderSearch, AgreesWithSatOnSetsWithoutPeriods)
{
    const WangList list = find_aperiodic_set(GetParam())->tiles();
    expect_heights_by_sat(list, CylinderAxis::horizontal);
    expect_heights_by_sat(list, CylinderAxis::vertical);
}

INSTANTIATE_TEST_SUITE_P(Sets, CylinderSearch, testing::Values("culik", "kari", "ammann", "robinson", "jeandel-rao"));

/// All neighbours fit in several copies of the rectangle.
void expect_repeats(const WangList& list, const PeriodicTiling& tiling)
{
    ASSERT_EQ(tiling.tiles.size(), tiling.width * tiling.height);
    for (std::size_t y = 0; y < 4 * tiling.height; ++y)
        for (std::size_t x = 0; x < 4 * tiling.width; ++x) {
            const auto at = [&](std::size_t i, std::size_t j) { return list.tiles.at(tiling.at(i, j)); };
            EXPECT_EQ(at(x, y).east, at(x + 1, y).west);
            EXPECT_EQ(at(x, y).south, at(x, y + 1).north);
        }
}

bool has_torus(const WangList& list, int width, int height)
{
    for (int shear = 0; shear < width; ++shear)
        if (SatTiling(list, {width, height, true, true, shear}).exists()) return true;
    return false;
}

TEST(CylinderSearchOfPeriodicSets, AgreesWithSatOnRandomSets)
{
    // Random sets of 5 tiles over 3 colours: some tile, some do not. What is searched up to 3 is found there by SAT.
    std::mt19937 random(7);
    int periodic = 0;
    for (int trial = 0; trial < 60; ++trial) {
        std::set<std::array<Color, 4>> tiles;
        const auto color = [&] { return static_cast<Color>(random() % 3); };
        while (tiles.size() < 5) tiles.insert({color(), color(), color(), color()});
        WangList list{{}, {3, 3}};
        for (const auto& t : tiles) list.tiles.push_back({t[0], t[1], t[2], t[3]});
        for (int width = 1; width <= 3; ++width) {
            const Cylinder found = longest_cylinder(list, static_cast<std::size_t>(width), CylinderAxis::horizontal);
            if (found.period) {
                ++periodic;
                EXPECT_EQ(found.period->width, static_cast<std::size_t>(width));
                expect_repeats(list, *found.period);
                const int height = static_cast<int>(found.period->height);
                const int shear = static_cast<int>(found.period->shear);
                EXPECT_TRUE(SatTiling(list, {width, height, true, true, shear}).exists());
                for (int shorter = 1; shorter < height; ++shorter) EXPECT_FALSE(has_torus(list, width, shorter));
            } else {
                const int height = static_cast<int>(found.height);
                EXPECT_TRUE(height == 0 || SatTiling(list, {width, height, true}).exists());
                EXPECT_FALSE(SatTiling(list, {width, height + 1, true}).exists());
            }
        }
    }
    EXPECT_GT(periodic, 20);
    EXPECT_LT(periodic, 160);
}

TEST(CylinderSearchOfPeriodicSets, FindsThePeriodsOfAStaircase)
{
    // Three tiles that follow each other eastwards, and below each the one that comes next: rows that repeat after
    // three tiles, and a row below another moved by one tile to the west.
    const WangList list{{{0, 1, 1, 0}, {1, 2, 2, 1}, {2, 0, 0, 2}}, {3, 3}};
    EXPECT_EQ(longest_cylinder(list, 1, CylinderAxis::horizontal).height, 0U);
    EXPECT_EQ(longest_cylinder(list, 2, CylinderAxis::vertical).height, 0U);
    const PeriodSearch search = search_periods(list, 8);
    ASSERT_TRUE(search.period);
    EXPECT_EQ(search.period->width, 3U);
    EXPECT_EQ(search.period->height, 1U);
    EXPECT_EQ(search.period->shear, 2U);
    EXPECT_THAT(search.horizontal_heights, testing::ElementsAre(0, 0));
    EXPECT_THAT(search.vertical_heights, testing::ElementsAre(0, 0));
    expect_repeats(list, *search.period);
    // Columns close after two tiles, in which rows close after any number: found along the rows first.
    const WangList stripes{{{0, 0, 1, 0}, {1, 1, 0, 1}}, {2, 2}};
    const PeriodSearch of_stripes = search_periods(stripes, 8);
    ASSERT_TRUE(of_stripes.period);
    EXPECT_EQ(of_stripes.period->axis, CylinderAxis::horizontal);
    EXPECT_EQ(of_stripes.period->width, 1U);
    EXPECT_EQ(of_stripes.period->height, 2U);
    const Cylinder columns = longest_cylinder(stripes, 2, CylinderAxis::vertical);
    EXPECT_EQ(columns.period->height, 2U);
    EXPECT_EQ(columns.period->width, 1U);
    expect_repeats(stripes, *columns.period);
}

TEST(CylinderSearchOfPeriodicSets, ListsTheHeightsOfTheOtherAxisUpToItsOwnPeriod)
{
    // 44 corner tiles of Ammann's set repeat in rows of 2, and in columns of 3: the heights of columns are those that a
    // search of columns alone has.
    const WangList list = wang_list_of(construct_corners(ammann_tiles(), CornerConstruction::horizontal).list);
    std::vector<std::size_t> steps;
    const PeriodSearch search =
        search_periods(list, 6, [&](const PeriodSearch& so_far) { steps.push_back(so_far.vertical_heights.size()); });
    EXPECT_EQ(search.period->axis, CylinderAxis::horizontal);
    EXPECT_THAT(search.horizontal_heights, SizeIs(1));
    ASSERT_THAT(search.vertical_heights, SizeIs(2));
    for (std::size_t width = 1; width <= 2; ++width) {
        const Cylinder columns = longest_cylinder(list, width, CylinderAxis::vertical);
        ASSERT_FALSE(columns.period);
        EXPECT_EQ(search.vertical_heights[width - 1], columns.height);
    }
    EXPECT_TRUE(longest_cylinder(list, 3, CylinderAxis::vertical).period);
    EXPECT_THAT(steps, testing::ElementsAre(1, 2, 2));
}

TEST(CylinderSearchOfPeriodicSets, CountsRowsOfATower)
{
    // Layers 0 over 1 over 2 over 3, closed after two tiles: a cylinder of three rows, and nothing above or below.
    const WangList tower{{{0, 0, 1, 1}, {0, 1, 1, 0}, {1, 0, 2, 1}, {1, 1, 2, 0}, {2, 0, 3, 1}, {2, 1, 3, 0}}, {4, 2}};
    const PeriodSearch search = search_periods(tower, 4);
    EXPECT_FALSE(search.period);
    EXPECT_THAT(search.horizontal_heights, testing::ElementsAre(0, 3, 0, 3));
    EXPECT_THAT(search.vertical_heights, testing::ElementsAre(0, 0, 0, 0));
}

TEST(CylinderSearchOfPeriodicSets, MergingOtherColoursOfJeandelAndRaosSetGivesPeriods)
{
    // Their set with five colours has 4 instead of 0 at the north of tile 0 and the south of tile 9. Merged with 0 it
    // is the one with four colours; merged with 1 or 2 it would tile with a period.
    WangList five = jeandel_rao_tiles();
    five.tiles[0].north = five.tiles[9].south = 4;
    five.colors.horizontal = 5;
    EXPECT_FALSE(search_periods(five, 8).period);
    EXPECT_FALSE(search_periods(jeandel_rao_tiles(), 8).period);
    for (const Color merged : {1, 2, 3}) {
        WangList other = jeandel_rao_tiles();
        other.tiles[0].north = other.tiles[9].south = merged;
        EXPECT_TRUE(search_periods(other, 8).period) << merged;
    }
}

TEST(CylinderSearchOfCornerSets, ThoseThatTellTheirWangTilesHaveNoPeriodUpToSix)
{
    for (const auto& [wang, construction] : {std::pair(ammann_tiles(), CornerConstruction::diagonal),
                                             {ammann_tiles(), CornerConstruction::rotation},
                                             {kari_tiles(), CornerConstruction::vertical},
                                             {culik_tiles(), CornerConstruction::rotation},
                                             {culik_tiles(), CornerConstruction::subdivision}}) {
        const PeriodSearch search = search_periods(wang_list_of(construct_corners(wang, construction).list), 6);
        EXPECT_FALSE(search.period);
        EXPECT_THAT(search.horizontal_heights, SizeIs(6));
        EXPECT_THAT(search.vertical_heights, SizeIs(6));
    }
}

/// All ways of giving the corners of a torus of width x height corner tiles one of `colors` colours.
bool can_tile_torus(const CornerList& list, std::size_t width, std::size_t height)
{
    std::set<std::array<Color, 4>> tiles;
    for (const CornerTile& t : list.tiles) tiles.insert({t.north_east, t.south_east, t.south_west, t.north_west});
    std::vector<Color> corners(width * height);
    const auto fits = [&] {
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = 0; x < width; ++x) {
                const auto at = [&](std::size_t i, std::size_t j) { return corners[j % height * width + i % width]; };
                if (!tiles.contains({at(x + 1, y), at(x + 1, y + 1), at(x, y + 1), at(x, y)})) return false;
            }
        return true;
    };
    for (;;) {
        if (fits()) return true;
        std::size_t i = 0;
        while (i < corners.size() && ++corners[i] == list.colors) corners[i++] = 0;
        if (i == corners.size()) return false;
    }
}

TEST(CylinderSearchOfCornerSets, TheSetOf44TilesOver6ColoursRepeats)
{
    // D. calls it the smallest aperiodic corner tile set known (figure 8.6). It has all the numbers that D. prints of
    // it and of what is made from it, but it tiles a torus: the colours of horizontal edges do not tell Ammann's tiles.
    const CornerList across = construct_corners(ammann_tiles(), CornerConstruction::horizontal).list;
    ASSERT_EQ(across.tiles.size(), 44U);
    ASSERT_EQ(across.colors, 6U);
    const WangList list = wang_list_of(across);
    const PeriodSearch search = search_periods(list, 6);
    ASSERT_TRUE(search.period);
    EXPECT_EQ(search.period->width, 2U);
    EXPECT_EQ(search.period->height, 3U);
    expect_repeats(list, *search.period);
    EXPECT_TRUE(can_tile_torus(across, 2, 3));
    for (const auto& [width, height] : {std::pair(1, 1), {1, 2}, {1, 3}, {2, 1}, {2, 2}, {1, 6}})
        EXPECT_FALSE(can_tile_torus(across, static_cast<std::size_t>(width), static_cast<std::size_t>(height)));
    EXPECT_TRUE(SatTiling(list, {2, 3, true, true}).exists());
    const CornerList upwards = construct_corners(ammann_tiles(), CornerConstruction::vertical).list;
    EXPECT_TRUE(can_tile_torus(upwards, 3, 2));
}

TEST(CylinderSearchOfCornerSets, DiagonalTilesHaveCylindersOneRowLower)
{
    // A row of diagonal corner tiles is two rows of Wang tiles.
    const WangList wang = culik_tiles();
    const WangList diagonal = wang_list_of(construct_corners(wang, CornerConstruction::diagonal).list);
    for (const CylinderAxis axis : {CylinderAxis::horizontal, CylinderAxis::vertical})
        for (std::size_t width = 1; width <= 7; ++width) {
            const std::size_t height = longest_cylinder(wang, width, axis).height;
            EXPECT_EQ(longest_cylinder(diagonal, width, axis).height, height > 0 ? height - 1 : 0) << width;
        }
}

TEST(ClosedRows, RefuseWordsWithoutANumber)
{
    const WangList colorful{{{0, 0, 69'999, 0}}, {70'000, 1}};
    EXPECT_EQ(message_of([&] { closed_rows(colorful, 8); }), "words of 70000 colours, 8 long, are too many");
}

}
}
