// Points of GeoJSON as GIS programs and this one write them.
#include "base/points/point_file.hpp"
#include "base/points/point_file_formats.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PointSet points_of(const std::string& text, std::vector<std::string>* told = nullptr)
{
    const TemporaryFolder folder;
    PointReading how{.domain = any_coordinates};
    how.told = [&](const std::string& sentence) {
        if (told) told->push_back(sentence);
    };
    return read_points(folder.write("a.geojson", text), how).at(0);
}

TEST(GeoJsonPointFiles, HavePointsOfAllObjects)
{
    EXPECT_EQ(points_of(R"({"type": "Point", "coordinates": [4.7, 50.8]})"), (PointSet{2, {4.7, 50.8}}));
    EXPECT_EQ(points_of(R"({"type": "MultiPoint", "coordinates": [[1, 2], [3, 5]]})"), (PointSet{2, {1, 2, 3, 5}}));
    std::vector<std::string> told;
    EXPECT_EQ(points_of(R"({"type": "FeatureCollection", "features": [
                  {"type": "Feature", "properties": {"species": "oak"}, "geometry": {"type": "Point", "coordinates": [1, 2]}},
                  {"type": "Feature", "geometry": null},
                  {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [
                      {"type": "LineString", "coordinates": [[0, 0], [1, 1]]}, {"type": "Point", "coordinates": [7, 9]}]}}]})",
                        &told),
              (PointSet{2, {1, 2, 7, 9}}));
    EXPECT_THAT(told, ElementsAre(HasSubstr("only its points are read; 1 line or polygon is left out")));
}

TEST(GeoJsonPointFiles, ReadBackAsTheyWereWritten)
{
    const TemporaryFolder folder;
    const PointSet points{2, {0.1, 1.0 / 3, 0.7, 1e-9}};
    write_points(folder.path() / "a.geojson", points);
    EXPECT_EQ(read_points(folder.path() / "a.geojson").at(0), points);
    write_geojson_features(folder.path() / "b.geojson", points, "", "", "feature", {"\"oak\"", "null"});
    EXPECT_EQ(read_points(folder.path() / "b.geojson").at(0), points);
    const PointSet space{3, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}};
    write_points(folder.path() / "c.geojson", space);
    EXPECT_EQ(read_points(folder.path() / "c.geojson").at(0), space);
}

TEST(GeoJsonPointFiles, AreRefusedByWhatIsWrong)
{
    for (const auto& [text, words] : std::initializer_list<std::pair<std::string, std::string>>{
             {R"({"type": "MultiPoint", "coordinates": [[1]]})", "[1]: must be a position: two numbers"},
             {R"({"type": "MultiPoint", "coordinates": [[1, "b"]]})", "must be a position: two numbers"},
             {R"({"type": "MultiPoint", "coordinates": [[1, 2], [1, 2, 3]]})",
              "must have 2 numbers as the first point has"},
             {R"({"type": "MultiPoint"})", "must have a list coordinates"},
             {R"({"type": "Point"})", "must have coordinates"},
             {R"({"kind": "Point"})", "must have a type: this is no GeoJSON"},
             {R"({"type": "LineString", "coordinates": [[0, 0], [1, 1]]})", "must have a Point or a MultiPoint"},
             {R"({"type": )", "is not JSON"}})
        EXPECT_THAT(message_of([&, &json = text] { points_of(json); }), HasSubstr(words)) << text;
}

}
}
