// Schemes of tilings by polygons: what they count, draw and store.
#include "host/schemes/scheme_run.hpp"

#include "base/files/whole_file.hpp"
#include "results/pictures/mark_picture.hpp"
#include "tests/support/exhibits.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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
    // What stands out of one tile is cut out of another; only the border of the patch makes a difference.
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
    SubstitutionSettings settings;
    settings.tiling.word = "chair";
    settings.depth = 50;
    settings.window = {12, 9};
    settings.address = {0, 1, 1, 2, 3, 1, 0, 1, 2, 2, 1, 3};
    const DistributionResult result = made(settings);
    EXPECT_EQ(number_of(result, "overlaps"), 0);
    EXPECT_GE(painted_area("tiling.json"), 12 * 9) << "in squares as large as the tile";
    EXPECT_LT(number_of(result, "tiles"), 1000);
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
