// WKT and GeoJSON as programs write them: Z and M, collections, empty members, features with ids.
#include "base/regions/formats/region_shapes.hpp"

#include "base/regions/region_features.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

RegionShapes wkt(const std::string& text) { return shapes_of_wkt(text, "w"); }

TEST(WktShapes, HaveHeightsAndMeasuresThatAreLeftOut)
{
    for (const char* text : {"POINT Z (1 2 3)", "POINTZ(1 2 3)", "point m (1 2 3)", "POINT ZM (1 2 3 4)",
                             "POINTZM (1 2 3 4)", "POINT (1 2 3)"}) {
        const RegionShapes read = wkt(text);
        EXPECT_THAT(read.shapes.points, ElementsAre(std::array{1.0, 2.0})) << text;
        EXPECT_TRUE(read.has_further_numbers) << text;
    }
    EXPECT_FALSE(wkt("POINT (1 2)").has_further_numbers);
    const PlaneRegion region = read_region("POLYGON Z ((0 0 5, 9 0 5, 9 9 5, 0 0 5))");
    EXPECT_EQ(area_of(region), 40.5);
    EXPECT_THAT(region.source->notes, ElementsAre(HasSubstr("heights and measures of its positions are left out")));
}

TEST(WktShapes, AreCollectionsAndMayBeEmpty)
{
    const RegionShapes read =
        wkt("SRID=25832; GEOMETRYCOLLECTION Z (POINT Z (1 2 3), GEOMETRYCOLLECTION (LINESTRING (0 0, "
            "1 1), POLYGON EMPTY), MULTIPOLYGON (EMPTY, ((0 0, 1 0, 0 1, 0 0))), POINT EMPTY, "
            "MULTIPOINT (3 4, (5 6), EMPTY))");
    EXPECT_EQ(read.system, "EPSG:25832");
    EXPECT_THAT(read.shapes.points, ElementsAre(std::array{1.0, 2.0}, std::array{3.0, 4.0}, std::array{5.0, 6.0}));
    EXPECT_THAT(read.shapes.lines, SizeIs(1));
    EXPECT_THAT(read.shapes.polygons, SizeIs(1));
    EXPECT_THAT(wkt("GEOMETRYCOLLECTION EMPTY").shapes.points, IsEmpty());
    const PlaneRegion region = read_region("GEOMETRYCOLLECTION (POINT (1 2), LINESTRING (0 0, 1 1), LINESTRING (0 0, 5 "
                                           "1), POLYGON ((0 0, 9 0, 9 9, 0 0)))");
    EXPECT_THAT(region.source->notes, ElementsAre(HasSubstr("left out, as it has no inside: 1 point and 2 lines")));
    EXPECT_THAT(message_of([] { read_region("MULTIPOLYGON EMPTY"); }),
                HasSubstr("has no polygon: the region is empty"));
}

TEST(WktShapes, AreReadWhereAFileHasSeveral)
{
    const RegionShapes read = wkt("POLYGON ((0 0, 1 0, 0 1, 0 0));\r\nSRID=25832;POINT (1 2)\nSRID=25832;POINT EMPTY");
    EXPECT_THAT(read.shapes.polygons, SizeIs(1));
    EXPECT_THAT(read.shapes.points, SizeIs(1));
    EXPECT_EQ(read.system, "EPSG:25832");
    EXPECT_THAT(message_of([] { wkt("SRID=25832;POINT (1 2)\nSRID=4326;POINT (1 2)"); }),
                HasSubstr("has several systems of coordinates, EPSG:25832 and EPSG:4326"));
}

TEST(WktShapes, AreRefusedByWhatIsWrong)
{
    for (const auto& [text, words] : std::initializer_list<std::pair<std::string, std::string>>{
             {"POLYGON ((0 0, 1 0, 0 1, 0 0)", "it ends where ) should follow"},
             {"POLYGON ((0 0, 1 0, 0 1, 0 0)) x", "goes on after its end: x"},
             {"POLYGON (0 0, 1 0)", "0 0, 1 0): ( should stand before it"},
             {"POINT (1 2, 3 4)", ", 3 4): ) should stand before it"},
             {"POINT (1 2 3 4 5)", "1 2 3 4 5: must be two numbers, or as many as four"},
             {"POINT (1 b)", "b: must be a number"},
             {"CIRCULARSTRING (0 0, 1 1, 2 0)", "CIRCULARSTRING: must be POINT, LINESTRING, POLYGON, MULTI..."},
             {"GEOMETRYCOLLECTION (CURVEPOLYGON (EMPTY))", "CURVEPOLYGON: must be POINT, LINESTRING"},
             {"SRID=abc;POINT (1 2)", "SRID=abc: must be SRID= and a number"},
             {"SRID=4326 POINT (1 2)", "no ; after SRID="}})
        EXPECT_THAT(message_of([&, &shape = text] { wkt(shape); }), HasSubstr("w: is not WKT: " + words)) << text;
    std::string nested = "POINT (1 2)";
    for (int i = 0; i < 40; ++i) nested = "GEOMETRYCOLLECTION (" + nested + ")";
    EXPECT_THAT(message_of([&] { wkt(nested); }), HasSubstr("collections are nested too deep"));
}

TEST(GeoJsonSequences, AreLayers)
{
    const std::string square = R"({"type": "Polygon", "coordinates": [[[0,0],[900,0],[900,900],[0,0]]]})";
    const std::string point = R"({"type": "Feature", "id": 7, "geometry": {"type": "Point", "coordinates": [1,2]}})";
    for (const std::string& text :
         {square + "\n" + point, "\x1e" + square + "\n\x1e" + point + "\n", square + "\r\n\r\n" + point + "\r\n"}) {
        const RegionShapes read = shapes_of_geojson(text, "g");
        EXPECT_THAT(read.shapes.polygons, SizeIs(1)) << text;
        EXPECT_THAT(read.shapes.points, SizeIs(1)) << text;
        EXPECT_THAT(read.ids, ElementsAre("0", "7")) << text;
    }
    EXPECT_THAT(shapes_of_geojson("\x1e" + square, "g").shapes.polygons, SizeIs(1));
    EXPECT_THAT(message_of([&] { shapes_of_geojson(square + "\n" + point + "\n{\"type\": 1\n", "g"); }),
                HasSubstr("g:3: is not JSON"));
    EXPECT_THAT(shapes_of_geojson("\n\x1e\n" + square + "\n" + point, "g").ids, ElementsAre("0", "7"));
    const std::string collection = R"({"type": "FeatureCollection", "features": [)" + point + "]}";
    EXPECT_THAT(shapes_of_geojson(collection + "\n" + square, "g").ids, ElementsAre("7", "1"));
}

TEST(GeoJsonSequences, HaveOneSystemOfCoordinates)
{
    const auto in = [](const std::string& system) {
        return R"({"type": "Point", "crs": {"type": "name", "properties": {"name": ")" + system +
               R"("}}, "coordinates": [1,2]})" + "\n";
    };
    EXPECT_EQ(shapes_of_geojson(in("EPSG:25832") + in("EPSG:25832"), "g").system, "EPSG:25832");
    for (const std::string& other : {in("EPSG:25833"), std::string(R"({"type": "Point", "coordinates": [1,2]})")})
        EXPECT_THAT(message_of([&] { shapes_of_geojson(in("EPSG:25832") + other, "g"); }),
                    HasSubstr("g:2: crs: must be the same on all lines, or on none"));
}

TEST(GeoJsonFeatures, TellWhichOfThemAPointLiesIn)
{
    const auto feature = [](const std::string& more, const std::string& coordinates) {
        return R"({"type": "Feature", )" + more + R"("geometry": {"type": "Polygon", "coordinates": )" + coordinates +
               "}}";
    };
    const PlaneRegion region = read_region(
        R"({"type": "FeatureCollection", "features": [)" +
        feature(R"("id": "north",)", "[[[0,500],[900,500],[900,900],[0,900],[0,500]]]") + "," +
        feature("", "[[[0,0],[900,0],[900,500],[0,500],[0,0]],[[100,100],[200,100],[200,200],[100,200],[100,100]]]") +
        "," + feature(R"("id": 7,)", "[[[100,100],[200,100],[200,200],[100,200],[100,100]]]") + "]}");
    EXPECT_EQ(area_of(region), 810'000);
    const PointSet points{2, {450, 700, 450, 300, 150, 150, 150, 250, 5000, 0}};
    EXPECT_THAT(ids_of_features(region.source->features, points), ElementsAre("\"north\"", "1", "7", "1", "null"));
}

}
}
