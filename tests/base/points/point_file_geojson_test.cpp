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
    write_geojson_points(folder.path() / "b.geojson", 2, crs_of_lengths, "",
                         [&](const PointSink& sink) { sink(points.coordinates); }, {"\"oak\"", "null"});
    EXPECT_EQ(read_points(folder.path() / "b.geojson").at(0), points);
    const PointSet space{3, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}};
    write_points(folder.path() / "c.geojson", space);
    EXPECT_EQ(read_points(folder.path() / "c.geojson").at(0), space);
}

/// Coordinates are degrees by the standard, which are not lengths; where the region has lengths, a sentence says so.
TEST(GeoJsonPointFiles, AreRefusedAsLengthsUnlessTheirSystemIsAnotherOne)
{
    const TemporaryFolder folder;
    const auto message = [&](const std::string& crs, const std::string& first, PointReading how = {}) {
        if (!how.domain) how.domain = CoordinateRange{0, 512};
        const auto file = folder.write("a.geojson", R"({"type": "MultiPoint", )" + crs + R"("coordinates": [)" + first +
                                                        ", [4.5, 50.9]]}");
        try {
            read_points(file, how);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("is read");
    };
    const auto named = [](const std::string& name) {
        return R"("crs": {"type": "name", "properties": {"name": ")" + name + "\"}}, ";
    };
    for (const std::string& degrees : {std::string(), named("urn:ogc:def:crs:OGC:1.3:CRS84"), named("EPSG:4326"),
                                       named("urn:ogc:def:crs:EPSG::4326")})
        EXPECT_THAT(message(degrees, "[4.35, 50.85]"),
                    HasSubstr("a.geojson: coordinates: are longitude and latitude in degrees, which are not lengths: "
                              "\"crs\": null in the file says that they are lengths"))
            << degrees;
    for (const std::string& lengths : {std::string(R"("crs": null, )"), named("EPSG:31370")})
        EXPECT_EQ(message(lengths, "[4.35, 50.85]"), "is read") << lengths;
    EXPECT_EQ(message("", "[180.5, 50.85]"), "is read"); // no place of the globe

    std::vector<std::string> told;
    PointReading how{.domain = any_coordinates, .degrees_sentence = "taken for lengths"};
    how.told = [&](const std::string& sentence) { told.push_back(sentence); };
    EXPECT_EQ(message(R"("crs": null, )", "[4.35, 50.85]", how), "is read");
    EXPECT_THAT(told, testing::IsEmpty());
    EXPECT_EQ(message("", "[4.35, 50.85]", how), "is read");
    EXPECT_THAT(told, ElementsAre(HasSubstr("a.geojson: taken for lengths")));
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
