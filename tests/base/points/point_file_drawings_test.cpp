// Points as GeoJSON, read back by a JSON library, and as DXF, whose groups are pairs of lines.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace poissonlab {
namespace {

/// The property `id` of each feature, which must be a point, and its position.
std::vector<std::pair<int, std::vector<double>>> features_of(const nlohmann::json& json)
{
    EXPECT_EQ(json.at("type"), "FeatureCollection");
    std::vector<std::pair<int, std::vector<double>>> features;
    for (const nlohmann::json& feature : json.at("features")) {
        EXPECT_EQ(feature.at("type"), "Feature");
        EXPECT_EQ(feature.at("geometry").at("type"), "Point");
        features.emplace_back(feature.at("properties").at("id").get<int>(),
                              feature.at("geometry").at("coordinates").get<std::vector<double>>());
    }
    return features;
}

TEST(PointFileGeoJson, HasAFeatureForEachPoint)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "a.geojson";
    write_points(file, {2, {0.1, 1.0 / 3, 1e-9, 0}}, "two \"points\"\nhere");
    const auto json = nlohmann::json::parse(read_whole_file(file));
    EXPECT_EQ(json.at("comment"), "two \"points\"\nhere");
    EXPECT_TRUE(json.at("crs").is_null()); // lengths
    using Features = std::vector<std::pair<int, std::vector<double>>>;
    EXPECT_EQ(features_of(json), (Features{{0, {0.1, 1.0 / 3}}, {1, {1e-9, 0}}}));
    // Pieces join without a gap, and numbers are the same doubles.
    PointSet many{3, {}};
    for (int i = 0; i < 3 * 10'000; ++i) many.coordinates.push_back(i / 30'000.0);
    write_points(file, many);
    const auto all = features_of(nlohmann::json::parse(read_whole_file(file)));
    ASSERT_EQ(all.size(), many.size());
    for (std::size_t i = 0; i < many.size(); ++i)
        ASSERT_EQ(all[i], std::pair(static_cast<int>(i), (std::vector<double>{many[i][0], many[i][1], many[i][2]})));
    write_points(file, {2, {}});
    EXPECT_EQ(features_of(nlohmann::json::parse(read_whole_file(file))), Features{});
}

/// Points in a region in metres say so, and the next run can keep away from them.
TEST(PointFileGeoJson, SaysTheSystemOfTheRegion)
{
    const TemporaryFolder folder;
    const std::string crs = R"({"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::25832"}})";
    const PlaneRegion region =
        read_region(R"({"type": "Polygon", "crs": )" + crs + R"(, "coordinates": [[[0,0],[9,0],[9,9],[0,0]]]})");
    EXPECT_EQ(nlohmann::json::parse(region.crs), nlohmann::json::parse(crs));
    const std::vector<double> points{1, 0.5, 8, 2};
    const auto file = folder.path() / "a.geojson";
    write_geojson_points(file, 2, region.crs, "", [&](const PointSink& sink) { sink(points); });
    EXPECT_EQ(nlohmann::json::parse(read_whole_file(file)).at("crs"), nlohmann::json::parse(crs));
    EXPECT_THAT(read_obstacles(file.string()).points, testing::ElementsAre(std::array{1.0, 0.5}, std::array{8.0, 2.0}));
    EXPECT_EQ(read_region("rectangle 0 0 1 1").crs, "");
}

TEST(PointFileDxf, HasAPointForEach)
{
    const TemporaryFolder folder;
    write_points(folder.path() / "a.dxf", {2, {0.5, 0.25, 0.75, 0}}, "two\n\npoints");
    EXPECT_EQ(read_whole_file(folder.path() / "a.dxf"),
              "999\ntwo\n999\npoints\n0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n"
              "0\nSECTION\n2\nENTITIES\n"
              "0\nPOINT\n8\n0\n10\n0.5\n20\n0.25\n30\n0\n"
              "0\nPOINT\n8\n0\n10\n0.75\n20\n0\n30\n0\n"
              "0\nENDSEC\n0\nEOF\n");
    write_points(folder.path() / "b.dxf", {3, {0.5, 0.25, 0.125}});
    EXPECT_THAT(read_whole_file(folder.path() / "b.dxf"), testing::HasSubstr("\n30\n0.125\n"));
}

/// Strings of release 12 have at most 255 characters; together the lines are the comment, and no character is cut.
TEST(PointFileDxf, SplitsLongComments)
{
    for (const std::size_t size : {1, 249, 250, 251, 500, 501, 5000}) {
        std::string comment = "e";
        while (comment.size() < size) comment += comment.size() % 3 == 0 ? "\xc3\xa9" : "f";
        std::istringstream dxf(dxf_begin(comment));
        std::string joined;
        std::size_t count = 0;
        for (std::string code, line; std::getline(dxf, code) && code == "999" && std::getline(dxf, line); ++count) {
            EXPECT_LE(line.size(), 255U);
            EXPECT_EQ(printable(line), line) << "whole characters of UTF-8";
            joined += line;
        }
        EXPECT_EQ(joined, comment);
        EXPECT_LE(count, comment.size() / 249 + 1);
    }
}

}
}
