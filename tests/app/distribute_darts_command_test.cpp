// `poissonlab distribute darts`: its files, and what it refuses.
#include "base/points/point_file.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <tuple>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class DistributeDarts : public testing::Test
{
protected:
    Outcome run(const std::vector<std::string>& words) const
    {
        std::vector<std::string> all{"distribute", "darts", "--engine", "reference"};
        all.insert(all.end(), words.begin(), words.end());
        return run_program(folder_.path(), all);
    }

    TemporaryFolder folder_;
};

TEST_F(DistributeDarts, WritesPointsInUnitsOfTheRegion)
{
    folder_.write("park.geojson", R"({"type": "Polygon", "coordinates": [[[0,0],[900,0],[900,400],[0,0]]]})");
    const Outcome outcome = run(
        {"--region", "park.geojson", "--min-distance", "50", "--out", "a.txt", "--out", "b.csv", "--out", "c.geojson"});
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr("points at least 50 apart, between which no further one fits"));
    const PointSet points = read_points(folder_.path() / "a.txt", CoordinateRange{0, 1000}).at(0);
    EXPECT_GT(points.size(), 40U);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LE(points[i][1], points[i][0] * 4 / 9 + 1e-9);
    EXPECT_EQ(read_points(folder_.path() / "b.csv", CoordinateRange{0, 1000}).at(0), points);
    const auto json = nlohmann::json::parse(content_of(folder_.path() / "c.geojson"));
    const PointSet stored = read_points(folder_.path() / "a.txt", any_coordinates).at(0);
    ASSERT_EQ(json.at("features").size(), stored.size());
    for (std::size_t i = 0; i < stored.size(); ++i) {
        EXPECT_EQ(json.at("features")[i].at("properties"), (nlohmann::json{{"id", i}}));
        EXPECT_EQ(json.at("features")[i].at("geometry").at("coordinates"),
                  (nlohmann::json{stored[i][0], stored[i][1]}));
    }
}

TEST_F(DistributeDarts, KeepsAwayFromObstacles)
{
    folder_.write("trees.wkt", "MULTIPOINT ((20 20), (70 60))");
    const std::vector<std::string> words{"--region", "rectangle 0 0 90 90", "--min-distance", "9", "--out", "a.txt"};
    std::vector<std::string> among = words, far = words;
    among.insert(among.end(), {"--obstacles", "trees.wkt", "--obstacle-distance", "15"});
    far.insert(far.end(), {"--obstacles", "POINT (500 500)"});
    EXPECT_EQ(run(among).status, 0);
    const PointSet points = read_points(folder_.path() / "a.txt", CoordinateRange{0, 1000}).at(0);
    EXPECT_GT(points.size(), 20U);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_GE(std::hypot(points[i][0] - 20, points[i][1] - 20), 15);
        EXPECT_GE(std::hypot(points[i][0] - 70, points[i][1] - 60), 15);
    }
    const Outcome outcome = run(far);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.error, HasSubstr("no obstacle is near enough to matter: are they in the units of the region?"));
}

TEST_F(DistributeDarts, RefusesWhatItCannotDo)
{
    using Words = std::vector<std::string>;
    for (const auto& [words, message] :
         {std::tuple{Words{"--region", "none.geojson", "--points", "9"}, "distribute darts: --region: none.geojson"},
          {Words{"--region", "POLYGON ((4 50, 4.1 50, 4.1 50.1, 4 50))", "--points", "9"},
           "look like longitude and latitude"},
          {Words{"--region", "rectangle 0 0 1 1"}, "needs --points or --min-distance"},
          {Words{"--region", "rectangle 0 0 1 1", "--min-distance", "2"},
           "--min-distance: 2 is more than the region's longest side, 1"},
          {Words{"--region", "rectangle 0 0 1 1", "--min-distance", "0.1", "--points", "900"},
           "distribute darts: the region is saturated with"},
          {Words{"--region", "rectangle 0 0 1 1", "--min-distance", "0.1", "--obstacles", "none.geojson"},
           "distribute darts: --obstacles: none.geojson"},
          {Words{"--region", "rectangle 0 0 1 1", "--min-distance", "0.1", "--obstacles", "LINESTRING (1 2)"},
           "--obstacles: LINESTRING (1 2): a line must have two positions or more"},
          {Words{"--region", "rectangle 0 0 1 1", "--min-distance", "0.1", "--obstacle-distance", "0.2"},
           "--obstacle-distance 0.2: needs --obstacles"},
          {Words{"--region", "rectangle 0 0 1 1", "--min-distance", "0.1", "--obstacles", "rectangle 0 0 2 2"},
           "--obstacles: they cover the region: nothing is left of it"},
          {Words{"--region", "POLYGON ((0 0, 1 1, 1 0, 0 1, 0 0))", "--points", "9"}, "crosses or touches itself"}}) {
        Words all = words;
        all.insert(all.end(), {"--out", "out.txt"});
        const Outcome outcome = run(all);
        EXPECT_EQ(outcome.status, 2) << message;
        EXPECT_THAT(outcome.error, HasSubstr(message));
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out.txt"));
    }
}

}
}
