// Schemes of tilings by polygons: what they count, draw and store.
#include "host/schemes/scheme_run.hpp"

#include "base/files/whole_file.hpp"
#include "host/schemes/polygon_tables.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "results/pictures/mark_picture.hpp"
#include "tests/support/exhibits.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

class PolygonSchemes : public testing::Test
{
protected:
    DistributionResult made(const auto& settings) { return made_of(settings, 1, folder_.path()); }

    static double number_of(const DistributionResult& result, const std::string& key)
    {
        const auto found = std::ranges::find(result.numbers, key, &DistributionNumber::key);
        EXPECT_NE(found, result.numbers.end()) << key;
        return found == result.numbers.end() ? -1 : found->value;
    }

    std::string text_of(const std::string& file) const { return read_whole_file(folder_.path() / file); }

    /// The area of the polygons of a picture, in its units.
    double painted_area(const std::string& file) const
    {
        double area = 0;
        for (const MarkGroup& group : read_mark_picture(folder_.path() / file).groups)
            for (const auto& polygon : group.polygons)
                for (std::size_t i = 0; i < polygon.size(); ++i) {
                    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
                    area += (a[0] * b[1] - a[1] * b[0]) / 2;
                }
        return area;
    }

    TemporaryFolder folder_;
};

TEST_F(PolygonSchemes, CountWhatTheyDraw)
{
    SubstitutionSettings settings;
    settings.tiling.word = "penrose-rhombs";
    settings.depth = 6;
    const DistributionResult result = made(settings);
    EXPECT_EQ(number_of(result, "tiles"), 377); // a Fibonacci number
    EXPECT_EQ(number_of(result, "overlaps"), 0);
    EXPECT_EQ(number_of(result, "mismatches"), 0);
    EXPECT_NEAR(number_of(result, "inflation"), std::numbers::phi, 1e-15);
    ASSERT_EQ(result.pictures.size(), 2U) << "the rules and the tiling";
    EXPECT_THAT(result.tables.at(0).rows.at(0), testing::ElementsAre("thick", "233", "0.618037", "0.618034"));
    const std::string csv = text_of("tiles.csv");
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 377);
    EXPECT_THAT(csv, testing::HasSubstr("\n0.0.0.0.0.0.0,thick,0,"));
    // Thick rhombs have the area 1 in the picture, thin ones sin 36 / sin 72 = 1/phi of it.
    EXPECT_NEAR(painted_area("tiling.json"), 233 + 144 / std::numbers::phi, 1e-6);
}

TEST_F(PolygonSchemes, DrawTabsAndShiftedOutlinesOfTheSameArea)
{
    // A part that stands out of one tile is cut out of another; only the border of the patch makes a difference.
    SubstitutionSettings settings;
    settings.depth = 7;
    made(settings);
    const double straight = painted_area("tiling.json");
    settings.style.edges = "puzzle";
    made(settings);
    EXPECT_NE(painted_area("tiling.json"), straight);
    EXPECT_NEAR(painted_area("tiling.json") / straight, 1, 0.002);
    settings.style.edges = "straight";
    settings.style.shifts = {0.2, -12, 0.2, -24};
    made(settings);
    EXPECT_NE(painted_area("tiling.json"), straight);
    EXPECT_NEAR(painted_area("tiling.json") / straight, 1, 0.02);
}

TEST_F(PolygonSchemes, FillWindowsFarInside)
{
    for (const auto& [word, depth] : {std::pair{"chair", 50}, {"hat", 40}, {"turtle", 40}, {"spectre", 36}}) {
        SubstitutionSettings settings;
        settings.tiling.word = word;
        settings.depth = depth;
        settings.window = {12, 9};
        settings.address = {0, 1, 1, 2, 3, 1, 0, 1, 2, 2, 1, 3};
        const DistributionResult result = made(settings);
        EXPECT_EQ(number_of(result, "overlaps"), 0);
        EXPECT_THAT(result.facts, testing::Not(testing::Contains(testing::HasSubstr("reaches beyond the tiles"))));
        EXPECT_GE(painted_area("tiling.json"), 12 * 9) << "in squares as large as the tile";
        EXPECT_LT(number_of(result, "tiles"), 1000);
    }
}

TEST_F(PolygonSchemes, FindTilesByPlaceAndByAddress)
{
    for (const std::string word : {"hat", "turtle", "spectre", "chair", "penrose-rhombs"}) {
        SubstitutionSettings settings;
        settings.tiling.word = word;
        settings.depth = 30;
        settings.window = {6, 6};
        settings.address = {0, 1, 0, 2, 1, 0, 1};
        made(settings);
        const std::string rows = text_of("tiles.csv");
        // The middle of the window is the place of a tile, whose row says where that is.
        const PolygonTiling tiling = built_in_tiling(word);
        const Substitution substitution(tiling, 0);
        const WindowMiddle middle = window_middle(tiling, substitution, settings).value();
        const auto point = point_of(tiling, middle.place);
        settings.address = {};
        settings.place = {point[0] / middle.scale, point[1] / middle.scale};
        const WindowMiddle found = window_middle(tiling, substitution, settings).value();
        EXPECT_THAT(rows, testing::HasSubstr(fmt::format("\n{},", fmt::join(found.address, ".")))) << word;
        const auto away = point_of(tiling, found.place - middle.place);
        EXPECT_LT(std::hypot(away[0], away[1]), 1.8 * middle.scale + 1e-3 * std::abs(point[0]) / 0x1p40) << word;
        settings.place = {-1e12, 1e12};
        settings.depth = 4;
        EXPECT_FALSE(window_middle(tiling, substitution, settings)) << word;
    }
}

TEST_F(PolygonSchemes, BendEdgesOfSpectres)
{
    SubstitutionSettings settings;
    settings.tiling.word = "spectre";
    settings.depth = 3;
    const DistributionResult result = made(settings);
    EXPECT_NEAR(number_of(result, "inflation"), std::sqrt(4 + std::sqrt(15.0)), 1e-14);
    EXPECT_NEAR(painted_area("tiling.json"), 559, 1e-6);
    // Each edge is its own half-turn, so that it adds as much to a tile as it takes away, and bends to the same side of
    // the tile wherever it lies; mirrored tiles are mirror images.
    settings.style.edges = "curved";
    made(settings);
    EXPECT_NEAR(painted_area("tiling.json"), 559, 1e-6);
    for (settings.depth = 0; settings.depth < 3; ++settings.depth) {
        made(settings);
        for (const MarkGroup& group : read_mark_picture(folder_.path() / "tiling.json").groups)
            for (const auto& polygon : group.polygons) {
                ASSERT_EQ(polygon.size(), 14U * 12);
                for (std::size_t i = 0; i < polygon.size(); i += 12) {
                    const auto point = [&](std::size_t k) { return polygon[(i + k) % polygon.size()]; };
                    for (std::size_t axis = 0; axis < 2; ++axis)
                        for (std::size_t k = 0; k < 6; ++k)
                            EXPECT_NEAR(point(k)[axis] + point(12 - k)[axis], point(0)[axis] + point(12)[axis], 1e-5);
                    const double left = (point(12)[0] - point(0)[0]) * (point(3)[1] - point(0)[1]) -
                                        (point(12)[1] - point(0)[1]) * (point(3)[0] - point(0)[0]);
                    EXPECT_EQ(left > 0, settings.depth % 2 == 0);
                }
            }
    }
}

TEST_F(PolygonSchemes, SayWhereAWindowReachesBeyondTheTiles)
{
    const auto says_so = testing::Contains(testing::HasSubstr("reaches beyond the tiles"));
    SubstitutionSettings settings;
    settings.tiling.word = "chair";
    settings.depth = 6;
    settings.window = {6, 6};
    EXPECT_THAT(made(settings).facts, says_so) << "the first parts are at a corner of the whole";
    settings.address = {0, 1, 1, 1};
    EXPECT_THAT(made(settings).facts, testing::Not(says_so));
}

TEST_F(PolygonSchemes, CountClassesOfPeriodicTilings)
{
    PeriodicSettings settings;
    settings.tiling.word = "trihedral";
    const DistributionResult result = made(settings);
    EXPECT_EQ(number_of(result, "tile_classes"), 5);
    EXPECT_EQ(number_of(result, "overlaps"), 0);
    // Figure 4 of the class notes: one direct and one reflected aspect, two aspects, a single one.
    EXPECT_THAT(result.tables.at(0).rows.at(0), testing::ElementsAre("s-tile", "2", "1", "1", "2"));
    EXPECT_THAT(result.tables.at(0).rows.at(1), testing::ElementsAre("bar", "2", "2", "0", "2"));
    EXPECT_THAT(result.tables.at(0).rows.at(2), testing::ElementsAre("domino", "1", "1", "0", "1"));
    EXPECT_GE(painted_area("tiling.json"), 16 * 12);
}

TEST_F(PolygonSchemes, PlaceBricksByDigits)
{
    const DistributionResult result = made(BrickSettings{24});
    EXPECT_EQ(number_of(result, "bricks"), 48);
    EXPECT_EQ(number_of(result, "ones"), 13) << "11.0010010000111111011010";
    EXPECT_NEAR(painted_area("tiling.json"), 24 * 4, 1e-9);
}

}
}
