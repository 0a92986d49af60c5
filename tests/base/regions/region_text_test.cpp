// Regions as they are typed and as files hold them: what is read, and what is refused in one line.
#include "base/regions/region_text.hpp"

#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using testing::HasSubstr;

const std::string square_with_hole = "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (2 2, 2 4, 4 4, 4 2, 2 2))";

std::string refusal(const std::string& text)
{
    return message_of([&] { read_region(text); });
}

TEST(RegionTexts, HaveTheAreaAndTheBoxOfWhatTheySay)
{
    EXPECT_EQ(area_of(read_region("rectangle -3 1 5 4.5")), 28);
    EXPECT_EQ(area_of(read_region(square_with_hole)), 96);
    EXPECT_EQ(area_of(read_region("  multipolygon(((0 0,1 0,0 1,0 0)),((2 0,3 0,3 1,2 0)))")), 1);
    const RegionBox box = box_of(read_region("rectangle -3 1 5 4.5"));
    EXPECT_EQ(box.low, (std::array{-3.0, 1.0}));
    EXPECT_EQ(box.high, (std::array{5.0, 4.5}));
    // The inscribed polygon of n corners has n / 2 sin(2 pi / n) of the squared radius.
    const double expected = disk_corners / 2.0 * std::sin(2 * std::numbers::pi / disk_corners) * 49;
    EXPECT_NEAR(area_of(read_region("disk 100 -3 7")), expected, 1e-10);
}

TEST(RegionTexts, OfGeoJsonAreAllPolygonsWithin)
{
    const std::string polygon =
        R"({"type": "Polygon", "coordinates": [[[0,0,7],[1000,0],[1000,1000],[0,1000],[0,0,7]]]})";
    EXPECT_EQ(area_of(read_region(polygon)), 1e6);
    EXPECT_EQ(area_of(read_region(R"({"type": "Feature", "properties": {}, "geometry": )" + polygon + "}")), 1e6);
    const std::string two =
        R"({"type": "MultiPolygon", "coordinates": [[[[2000,0],[3000,0],[3000,500],[2000,0]]],[[[4000,0],[4400,0],[4400,100],[4000,100],[4000,0]],[[4100,20],[4100,30],[4110,30],[4100,20]]]]})";
    EXPECT_EQ(area_of(read_region(two)), 250'000 + 40'000 - 50);
    EXPECT_EQ(read_region(two).polygons.at(1).holes.size(), 1U);
    const std::string all = R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry": )" + polygon +
                            R"(}, {"type": "Feature", "geometry": null}, {"type": "Feature", "geometry": )" + two +
                            "}]}";
    EXPECT_EQ(read_region(all).polygons.size(), 3U);
    EXPECT_EQ(area_of(read_region(all)), 1'289'950);
}

TEST(RegionFiles, AreKnownByWhatTheyHold)
{
    const TemporaryFolder folder;
    const std::string geojson = folder.write("a.geojson",
                                             R"({"type": "Polygon",
 "coordinates": [[[0,0],[1000,0],[0,1000],[0,0]]]})");
    EXPECT_EQ(area_of(read_region(geojson)), 500'000);
    EXPECT_EQ(area_of(read_region(folder.write("b.txt", "\xef\xbb\xbf\n" + square_with_hole + "\n"))), 96);
    EXPECT_EQ(area_of(read_region(folder.write("c", "rectangle 0 0 2 3\n"))), 6);
    EXPECT_THAT(refusal(folder.write("d.csv", "x,y\n0,0\n")), HasSubstr("d.csv: is neither GeoJSON nor WKT"));
    EXPECT_THAT(refusal(folder.write("e.geojson", "{\n\n\"type\": }")), HasSubstr("e.geojson:3: is not JSON"));
    EXPECT_THAT(refusal((folder.path() / "none").string()), HasSubstr("none"));
}

TEST(RegionTexts, AreRefusedWhereTheyAreNoRegion)
{
    for (const auto& [text, words] : std::initializer_list<std::pair<std::string, std::string>>{
             {"POLYGON ((0 0, 10 10, 10 0, 0 10, 0 0))", "the outline crosses or touches itself"},
             {"POLYGON ((0 0, 10 0, 5 5, 10 10, 0 10, 5 5, 0 0))", "the outline crosses or touches itself"},
             {"POLYGON ((0 0, 10 0, 10 5, 10 -1, 0 10, 0 0))", "the outline crosses or touches itself"},
             {"POLYGON ((0 0, 5 0, 10 0, 3 0, 0 0))", "the outline crosses or touches itself"},
             {"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (20 20, 21 20, 21 21, 20 20))", "hole 1 lies outside the outline"},
             {"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (8 1, 12 1, 8 2, 8 1))", "the outline and hole 1 cross"},
             {"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (0 1, 1 1, 0 2, 0 1))", "share a piece of a line"},
             {"POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 1), (4 2, 6 2, 6 3, 4 2))",
              "hole 2 lies inside hole 1"},
             {"POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0), (5 5, 10 10, 15 5, 10 0, 5 5))",
              "hole 1 and the outline cross"}, // through corners
             {"POLYGON ((0 0, 1 0, 1 1))", "is not closed"},
             {"POLYGON ((0 0, 1 0, 0 0))", "is not closed: its last position must be its first, of four or more"},
             {"POLYGON ((0 0, 1 1, 1 1, 0 0, 0 0))", "the outline has fewer than three corners"},
             {"POLYGON ((0 0, 1000000000 0, 1000000000 0.001, 0 0))", "is nothing beside its extent"},
             {"POLYGON ((1e9 1e9, 1000000000.1 1e9, 1e9 1000000000.1, 1e9 1e9))", "which doubles cannot resolve"},
             {"POLYGON ((0 0, 1e308 0, 1e308 1e308, 0 0))",
              "has coordinates of up to 1e+308: must be less than 1e+150"},
             {"POLYGON ((50.8 104.3, 50.9 104.3, 50.9 104.4, 50.8 104.3))", "longitude must come first"},
             {R"({"type": "Polygon", "coordinates": [[[50.8,104.3],[50.9,104.3],[50.9,104.4],[50.8,104.3]]]})",
              "look like latitude and longitude: longitude must come first; if they are lengths, give --planar (planar "
              "= true)"},
             {"POLYGON EMPTY", "has no polygon: the region is empty"},
             {"POLYGON (0 0, 1 0)", "is not WKT"},
             {"rectangle 0 0 0 1", "must be rectangle X0 Y0 X1 Y1 with X0 < X1 and Y0 < Y1"},
             {"rectangle 0 0 1", "must be rectangle"},
             {"rectangle 0 0 1,5 2", "the comma of \"1,5\" is no decimal point: must be 1.5"},
             {"disk 0 0 1,5", "the comma of \"1,5\" is no decimal point: must be 1.5"},
             {"formula 0 0 1,5 2 -x", "the comma of \"1,5\" is no decimal point: must be 1.5"},
             {"formula 0 0 2 1,5 -x", "the comma of \"1,5\" is no decimal point: must be 1.5"},
             {"formula 0 0 1 1 0,5-x", "the comma of \"0,5\" is no decimal point: must be 0.5"},
             {"disk 0 0 -1", "must be disk X Y RADIUS with RADIUS > 0"},
             {R"({"type": "LineString", "coordinates": [[0,0],[1,1]]})",
              "has points or lines and no polygon: the region is empty"},
             {R"({"type": "Polygon", "coordinates": [[[0,0],[500,0],[0,500],[0,400]]]})",
              "coordinates[0]: is not closed"},
             {R"({"type": "Polygon", "coordinates": [[[0,0],[500,0],["a",500],[0,0]]]})",
              "coordinates[0][2]: must be a position: two numbers"},
             {R"({"type": "Polygon"})", "coordinates: is missing"},
             {R"({"type": "FeatureCollection", "features": []})", "has no polygon: the region is empty"},
             {R"({"features": []})", "type: is missing: this is no GeoJSON"}})
        EXPECT_THAT(refusal(text), HasSubstr(words)) << text;
}

/// Rings that touch in single points are valid, and so are islands in holes.
TEST(RegionTexts, MayTouchInPoints)
{
    EXPECT_EQ(area_of(read_region("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (0 0, 3 1, 1 3, 0 0))")), 77);
    EXPECT_EQ(area_of(read_region("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0)), ((9 9, 10 9, 10 10, 9 9)))")), 81.5);
    EXPECT_EQ(area_of(read_region("MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 8 1, 8 8, 1 8, 1 1)), "
                                  "((2 2, 3 2, 3 3, 2 3, 2 2)))")),
              81 - 49 + 1);
    // Corners that come twice do not matter, nor does the direction.
    EXPECT_EQ(area_of(read_region("POLYGON ((0 0, 0 9, 0 9, 9 9, 9 0, 0 0))")), 81);
}

/// Other tests hold against oracles what longitudes and latitudes become: see globe_region_test.cpp.
TEST(RegionTexts, HaveLengthsWhereTheySayItOrCannotHaveDegrees)
{
    const std::string park =
        R"("type": "Polygon", "coordinates": [[[4.70,50.86],[4.71,50.86],[4.71,50.87],[4.70,50.86]]])";
    EXPECT_NEAR(area_of(read_region("{" + park + "}", {.is_planar = true})), 5e-5, 1e-12);
    const std::string belgian = R"("crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::31370"}})";
    EXPECT_NEAR(area_of(read_region("{" + belgian + ", " + park + "}")), 5e-5, 1e-12);
    const std::string unknown = R"("crs": {"type": "name", "properties": {"name": "our own"}})";
    EXPECT_THAT(refusal("{" + unknown + ", " + park + "}"), HasSubstr("our own: PROJ knows no such system"));
    const std::string wkt = "POLYGON ((4.70 50.86, 4.71 50.86, 4.71 50.87, 4.70 50.86))";
    EXPECT_THAT(refusal(wkt), HasSubstr("longitude and latitude"));
    EXPECT_NO_THROW(read_region("SRID=31370;" + wkt));
    EXPECT_NO_THROW(read_region(wkt, {.is_planar = true}));
    EXPECT_NO_THROW(read_region(square_with_hole)) << "near 0, and as large as it is far from there";
}

/// Islands are as wide as they are, however far apart they lie; what is refused is narrower everywhere.
TEST(RegionTexts, MayHaveIslandsFarApart)
{
    const PlaneRegion region = read_region(
        "MULTIPOLYGON (((0 0,9 0,0 9,0 0)),((9000000 9000000,9000009 9000000,9000000 9000009,9000000 9000000)))");
    EXPECT_EQ(area_of(region), 81);
}

}
}
