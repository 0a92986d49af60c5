// Points in regions of longitude and latitude, from the file to the file: distances by Karney's geodesics.
#include "base/points/point_file.hpp"
#include "tests/support/program.hpp"

#include <geodesic.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// In metres on the ellipsoid of WGS 84.
double metres_between(std::span<const double> a, std::span<const double> b)
{
    geod_geodesic globe;
    geod_init(&globe, 6378137, 1 / 298.257223563);
    double length = 0;
    geod_inverse(&globe, a[1], a[0], b[1], b[0], &length, nullptr, nullptr);
    return length;
}

/// The least distance of points of two sets, or of one.
double least_metres(const PointSet& a, const PointSet& b)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = &a == &b ? i + 1 : 0; j < b.size(); ++j)
            least = std::min(least, metres_between(a[i], b[j]));
    return least;
}

class GlobeRegionFiles : public testing::Test
{
protected:
    GlobeRegionFiles()
    {
        folder_.write("park.geojson", R"({"type": "Polygon", "coordinates": [[[4.700, 50.860], [4.712, 50.861], [4.709,
            50.869], [4.704, 50.866], [4.700, 50.860]], [[4.705, 50.862], [4.705, 50.864], [4.707, 50.864], [4.705, 50.862]]]})");
    }

    Outcome run(const std::vector<std::string>& words) const { return run_program(folder_.path(), words); }

    PointSet read(const std::string& name) const { return read_points(folder_.path() / name, any_coordinates).at(0); }

    TemporaryFolder folder_;
};

TEST_F(GlobeRegionFiles, HaveLongitudeAndLatitudeWhoseDistancesAreMetres)
{
    const Outcome made = run({"distribute", "darts", "--region", "park.geojson", "--min-distance", "20", "--json",
                              "--out", "a.csv", "--out", "a.geojson", "--out", "a.npy", "--out", "a.dxf"});
    ASSERT_EQ(made.status, 0) << made.error;
    EXPECT_THAT(made.error,
                HasSubstr("park.geojson: longitude and latitude (WGS 84 (CRS84)) are mapped to Lambert's "
                          "azimuthal equal-area plane around (4.706, 50.8645): lengths are metres there, off by"));
    EXPECT_THAT(made.error, HasSubstr("points at least 20 m apart"));
    EXPECT_THAT(content_of(folder_.path() / "a.csv"), testing::StartsWith("longitude,latitude\n4.7"));
    const json numbers = json::parse(made.out);
    const double distortion = numbers.at("distortion");
    EXPECT_LT(distortion, 1e-6);
    EXPECT_EQ(numbers.at("center_latitude"), 50.8645);
    const PointSet points = read("a.csv");
    EXPECT_GT(points.size(), 500U);
    EXPECT_EQ(points, read("a.geojson"));
    EXPECT_EQ(points, read("a.npy"));
    EXPECT_GE(least_metres(points, points), 20 * (1 - distortion) - 1e-6);
    EXPECT_LT(least_metres(points, points), 20.5);
    EXPECT_THAT(content_of(folder_.path() / "a.dxf"), testing::Not(HasSubstr("\n10\n4.7"))) << "metres, for drawings";
    // They are obstacles for others, and sets for the analysis.
    const Outcome other =
        run({"distribute", "points", "--method", "elimination", "--region", "park.geojson", "--obstacles", "a.geojson",
             "--obstacle-distance", "9", "--points", "200", "--out", "b.csv"});
    ASSERT_EQ(other.status, 0) << other.error;
    EXPECT_GE(least_metres(read("b.csv"), points), 9 * (1 - distortion) - 1e-6);
    const Outcome analysed = run({"analyze", "a.geojson", "--region", "park.geojson", "--set", "analysis.envelope=0"});
    ASSERT_EQ(analysed.status, 0) << analysed.error;
    EXPECT_THAT(analysed.out, HasSubstr("are mapped to Lambert's"));
    const json series = json::parse(content_of(folder_.path() / "out/a/results.json"))["series"][0];
    EXPECT_NEAR(series["min_distance"]["min"].get<double>() * series["region"]["unit_length"].get<double>(),
                least_metres(points, points), 1e-3);
}

/// Sets of methods are stored as the region's file has its coordinates; realization 0 is that of the command.
TEST_F(GlobeRegionFiles, AreWhatMethodsOfConfigsStore)
{
    folder_.write("c.toml", "[analysis]\nregion = \"park.geojson\"\npoints = 300\nrealizations = 1\nenvelope = 0\n"
                            "[[method]]\nsampler = \"bridson\"\nmin_distance = 25\n");
    const Outcome outcome = run({"run", "c.toml", "--set", "engine=reference"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_THAT(outcome.out, HasSubstr("are mapped to Lambert's"));
    ASSERT_EQ(run({"distribute", "points", "--method", "bridson", "--region", "park.geojson", "--min-distance", "25",
                   "--out", "b.txt", "--quiet"})
                  .status,
              0);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path() / "out"))
        if (entry.path().filename() == "realization-000.dat") {
            EXPECT_EQ(read_points(entry.path(), any_coordinates).at(0), read("b.txt"));
        }
}

TEST_F(GlobeRegionFiles, SayWhichFeatureOfALayerPointsLieIn)
{
    folder_.write(
        "layer.geojson", R"({"type": "FeatureCollection", "features": [
        {"type": "Feature", "id": "west", "properties": {"name": "oak \"wood\"", "id": 7, "feature_id": 8, "soil": {"ph": 5},
            "survey": ")" + std::string(1000, 'x') +
                             R"("}, "geometry": {"type": "Polygon", "coordinates": [[[4.70, 50.86], [4.705, 50.86],
            [4.705, 50.87], [4.70, 50.87], [4.70, 50.86]]]}},
        {"type": "Feature", "id": "east", "geometry": {"type": "Polygon", "coordinates": [[[4.705, 50.86], [4.71, 50.86],
            [4.71, 50.87], [4.705, 50.87], [4.705, 50.86]]]}}]})");
    const Outcome made =
        run({"distribute", "darts", "--region", "layer.geojson", "--min-distance", "40", "--out", "a.geojson"});
    ASSERT_EQ(made.status, 0) << made.error;
    EXPECT_THAT(made.error, HasSubstr("2 polygons overlap or share edges: the region is their union, of 1 polygon"));
    const json features = json::parse(content_of(folder_.path() / "a.geojson")).at("features");
    EXPECT_GT(features.size(), 200U);
    for (const json& feature : features)
        EXPECT_EQ(feature["properties"]["feature"], feature["geometry"]["coordinates"][0] < 4.705 ? "west" : "east");
    // Attributes of the layer's features, which are copied.
    for (const char* command : {"darts", "classes"}) {
        const std::string file = std::string(command) + ".geojson";
        const Outcome copied =
            command == std::string("darts")
                ? run({"distribute", "darts", "--region", "layer.geojson", "--min-distance", "60", "--out", file})
                : run({"distribute", "classes", "--region", "layer.geojson", "--distances", "90", "60", "--out", file});
        ASSERT_EQ(copied.status, 0) << copied.error;
        std::size_t id = 0, west = 0;
        const json written = json::parse(content_of(folder_.path() / file)).at("features");
        for (const json& feature : written) {
            json expected{{"id", id++}, {"feature", "east"}};
            if (feature["geometry"]["coordinates"][0] < 4.705) {
                ++west;
                expected = {{"id", id - 1},       {"feature", "west"},       {"name", "oak \"wood\""},
                            {"feature_id", 8},    {"feature_feature_id", 7}, // "survey" is longer than what is copied
                            {"soil", {{"ph", 5}}}};
            }
            if (feature["properties"].contains("class")) expected["class"] = feature["properties"]["class"];
            EXPECT_EQ(feature["properties"].contains("class"), command == std::string("classes"));
            EXPECT_EQ(feature["properties"], expected);
        }
        EXPECT_GT(west, 20U);
    }
    EXPECT_EQ(read("a.geojson").size(), features.size());
}

/// Columns of degrees are measured as degrees by no command: as points of a region they are in metres.
TEST_F(GlobeRegionFiles, AreMeasuredInMetres)
{
    ASSERT_EQ(run({"distribute", "darts", "--region", "rectangle 4.70 50.86 4.71 50.87", "--crs", "EPSG:4326",
                   "--min-distance", "40", "--out", "a.csv", "--quiet"})
                  .status,
              0);
    const Outcome refused = run({"analyze", "a.csv"});
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.error,
                HasSubstr("a.csv:1: longitude, latitude: are longitude and latitude in degrees, which are "
                          "not lengths: a region of the globe maps them to metres, such as --region "
                          "'rectangle 4.7 50.86 4.71 50.87' with --set analysis.crs=EPSG:4326"));
    const Outcome measured = run({"analyze", "a.csv", "--region", "rectangle 4.70 50.86 4.71 50.87", "--set",
                                  "analysis.crs=EPSG:4326", "--set", "analysis.envelope=0", "--quiet"});
    ASSERT_EQ(measured.status, 0) << measured.error;
    const json series = json::parse(content_of(folder_.path() / "out/a/results.json"))["series"][0];
    EXPECT_EQ(series["region"]["is_in_metres"], true);
    const PointSet points = read("a.csv");
    EXPECT_NEAR(series["min_distance"]["min"].get<double>() * series["region"]["unit_length"].get<double>(),
                least_metres(points, points), 0.01);
    const std::string page = content_of(folder_.path() / "out/a/a/index.html");
    EXPECT_THAT(page, HasSubstr("Minimum distance (m)"));
    EXPECT_THAT(page, testing::Not(HasSubstr("of the torus' side")));
    const Outcome as_lengths = run({"analyze", "a.csv", "--region", "rectangle 4.70 50.86 4.71 50.87", "--set",
                                    "analysis.envelope=0", "--out", "b"});
    EXPECT_THAT(as_lengths.out, HasSubstr("poissonlab: note: a.csv: its longitude and latitude are taken for "
                                          "lengths"));
}

}
}
