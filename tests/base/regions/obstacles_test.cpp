// Obstacles: how they are read, what is left of a region without them, and what keeps away from them, by CGAL's exact
// distances.
#include "base/regions/obstacles.hpp"

#include "base/regions/fixed_region.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;

TEST(ObstacleTexts, HavePointsLinesAndPolygons)
{
    const std::string collection = R"({"type": "GeometryCollection", "geometries": [
        {"type": "Point", "coordinates": [500, 7]}, {"type": "MultiPoint", "coordinates": [[1, 2], [3, 4]]},
        {"type": "LineString", "coordinates": [[0, 0], [9, 9], [9, 0]]},
        {"type": "MultiLineString", "coordinates": [[[0, 0], [1, 1]], [[2, 2], [3, 3]]]},
        {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [0, 4], [0, 0]]]}]})";
    const Obstacles all = read_obstacles(collection);
    EXPECT_EQ(all.points, (std::vector<std::array<double, 2>>{{500, 7}, {1, 2}, {3, 4}}));
    ASSERT_EQ(all.lines.size(), 3U);
    EXPECT_EQ(all.lines[0], (RegionRing{{0, 0}, {9, 9}, {9, 0}}));
    EXPECT_EQ(all.polygons.size(), 1U);
    EXPECT_EQ(read_obstacles("POINT (3 4)").points, (std::vector<std::array<double, 2>>{{3, 4}}));
    EXPECT_EQ(read_obstacles("multipoint ((1 2), (3 4))").points.size(), 2U);
    EXPECT_EQ(read_obstacles("SRID=25832;LINESTRING (1 2, 3 4, 5 6)").lines.at(0).size(), 3U);
    EXPECT_EQ(read_obstacles("MULTILINESTRING ((1 2, 3 4), (5 6, 7 8))").lines.size(), 2U);
    EXPECT_EQ(read_obstacles("disk 1 2 3").polygons.size(), 1U);
    // Polygons may overlap each other, as those of a region may not.
    EXPECT_EQ(read_obstacles("MULTIPOLYGON (((0 0,2 0,0 2,0 0)),((0 0,1 0,0 1,0 0)))").polygons.size(), 2U);
}

TEST(ObstacleTexts, AreRefusedWhereTheyAreNone)
{
    for (const auto& [text, words] : std::initializer_list<std::pair<std::string, std::string>>{
             {"POLYGON ((0 0, 10 10, 10 0, 0 10, 0 0))", "the outline crosses or touches itself"},
             {"MULTIPOLYGON (((0 0,2 0,0 2,0 0)),((0 0,9 9,9 0,0 9,0 0)))", "polygon 2: the outline crosses or"},
             {"POINT (1)", "is not WKT: 1: must be two numbers"},
             {"MULTIPOINT ((1 2), ( 3 ))", "is not WKT: 3: must be two numbers"},
             {"LINESTRING (1 2, 4)", "is not WKT: 4: must be two numbers"},
             {"POINT (nan 1)", "has a coordinate that is not a number"},
             {"LINESTRING (1 2)", "a line must have two positions or more"},
             {R"({"type": "LineString", "coordinates": [[1000, 2]]})", "coordinates: must have two positions or more"},
             {R"({"type": "Point", "coordinates": [1000]})", "coordinates: must be a position: two numbers"},
             {R"({"type": "Circle", "coordinates": [1000, 3]})", "type: Circle: must be Point, LineString, Polygon"},
             {R"({"type": "FeatureCollection", "features": []})", "has no point, line or polygon to keep away from"},
             {R"({"type": "Point", "coordinates": [7, 50]})", "look like longitude and latitude"},
             {"SRID=4326;POINT (7 50)", "look like longitude and latitude"},
             {"points.geojson", "points.geojson"}, // a file's name, not WKT
             {"rectangle 0 0 0 1", "must be rectangle"}})
        EXPECT_THAT(message_of([&, &obstacle = text] { read_obstacles(obstacle); }), HasSubstr(words)) << text;
    EXPECT_EQ(read_obstacles(R"({"type": "Point", "crs": null, "coordinates": [7, 50]})").count(), 1U);
    EXPECT_EQ(read_obstacles(R"({"type": "Point", "coordinates": [7, 50]})", {.is_planar = true}).count(), 1U);
}

double area_left(const std::string& region, const std::string& obstacles)
{
    return area_of(without_polygons(read_region(region), read_obstacles(obstacles).polygons));
}

/// Areas that anybody can count on paper.
TEST(RegionsWithoutPolygons, HaveTheAreaThatIsLeft)
{
    EXPECT_EQ(area_left("rectangle 0 0 10 10", "rectangle 20 20 30 30"), 100);
    EXPECT_EQ(area_left("rectangle 0 0 10 10", "rectangle 2 2 4 5"), 94);
    EXPECT_EQ(area_left("rectangle 0 0 10 10", "rectangle -3 4 40 6"), 80); // two parts are left
    EXPECT_EQ(area_left("rectangle 0 0 10 10", "rectangle -1 -1 11 11"), 0);
    // Two that overlap, one within another, two that share an edge, and one in a hole of another.
    EXPECT_EQ(area_left("rectangle 0 0 10 10", "MULTIPOLYGON (((1 1,4 1,4 4,1 4,1 1)),((3 3,6 3,6 6,3 6,3 3)))"), 83);
    EXPECT_EQ(area_left("rectangle 0 0 10 10", "MULTIPOLYGON (((1 1,4 1,4 4,1 4,1 1)),((2 2,3 2,3 3,2 2)))"), 91);
    EXPECT_EQ(area_left("rectangle 0 0 10 10", "MULTIPOLYGON (((1 1,4 1,4 4,1 4,1 1)),((4 1,6 1,6 3,4 3,4 1)))"), 87);
    EXPECT_EQ(area_left("rectangle 0 0 10 10", "POLYGON ((1 1,9 1,9 9,1 9,1 1),(3 3,3 7,7 7,7 3,3 3))"), 52);
    EXPECT_EQ(area_left("POLYGON ((0 0,10 0,10 10,0 10,0 0),(4 4,6 4,6 6,4 6,4 4))", "rectangle 5 5 12 12"), 72);
    EXPECT_EQ(without_polygons(read_region("rectangle 0 0 9 9"), read_obstacles("rectangle -3 4 40 6").polygons)
                  .polygons.size(),
              2U);
}

TEST(ObstacleLines, EndAtTheBox)
{
    const RegionBox box{{0, 0}, {10, 10}};
    Obstacles obstacles;
    obstacles.lines = {{{-5, 5}, {15, 5}, {15, 30}}, {{2, 3}, {4, 5}}, {{-4, 8}, {2, 14}}, {{-1, 9}, {1, 11}}};
    const std::vector<std::array<double, 4>> expected{{0, 5, 10, 5}, {2, 3, 4, 5}, {0, 10, 0, 10}};
    EXPECT_EQ(lines_within(obstacles, box), expected);
    obstacles = read_obstacles("POLYGON ((2 2, 20 2, 2 8, 2 2))");
    EXPECT_EQ(lines_within(obstacles, box).size(), 3U);
    obstacles.points = {{0, 0}, {10, 10}, {10.5, 3}};
    EXPECT_EQ(points_within(obstacles, box).size(), 2U);
}

/// Corners of whole numbers in the whole grid, so that nothing is rounded: the margins of lines and of points by
/// CGAL's exact numbers, and what is said of boxes.
TEST(KeptAwayFrom, IsWhatIsNearByExactNumbers)
{
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
    const double w = 0x1p31 - 1;
    PlaneRegion region;
    region.polygons.push_back({{{0, 0}, {w, 0}, {w, w}, {0, w}}});
    std::mt19937 random(4);
    const auto coordinate = [&] { return static_cast<double>(random() >> 1); };
    KeptAway kept{{}, {}, 0.01, 0.03, box_of(region)};
    for (int i = 0; i < 6; ++i) kept.lines.push_back({coordinate(), coordinate(), coordinate(), coordinate()});
    kept.lines.push_back({0x1p29, 0x1p30, 0x1p29, 0x1p30}); // a line of no length has the margin of lines
    for (int i = 0; i < 6; ++i) kept.points.push_back({coordinate(), coordinate()});
    const FixedRegion fixed(region, 0, kept);
    const auto is_free = [&](const TorusPoint<2>& p) {
        const Exact::Point_2 place(p[0], p[1]);
        const auto square = [](double distance) { return Exact::FT(distance * 0x1p32) * Exact::FT(distance * 0x1p32); };
        return p[0] <= w && p[1] <= w &&
               std::ranges::all_of(kept.lines,
                                   [&](const auto& l) {
                                       const Exact::Segment_2 line({l[0], l[1]}, {l[2], l[3]});
                                       return CGAL::squared_distance(line, place) >= square(kept.from_lines);
                                   }) &&
               std::ranges::all_of(kept.points, [&](const auto& q) {
                   return CGAL::squared_distance(Exact::Point_2(q[0], q[1]), place) >= square(kept.from_points);
               });
    };
    int inside = 0;
    std::array<int, 3> count{};
    for (int i = 0; i < 1000; ++i) {
        TorusPoint<2> p{static_cast<std::uint32_t>(coordinate()), static_cast<std::uint32_t>(coordinate())};
        if (i % 2 == 0) { // about as far from a point as its margin
            const auto& q = kept.points[static_cast<std::size_t>(i) % kept.points.size()];
            const double angle = i;
            p = {static_cast<std::uint32_t>(std::clamp(q[0] + 0.03 * 0x1p32 * std::cos(angle), 0.0, w)),
                 static_cast<std::uint32_t>(std::clamp(q[1] + 0.03 * 0x1p32 * std::sin(angle), 0.0, w))};
        }
        const bool expected = is_free(p);
        inside += expected;
        ASSERT_EQ(fixed.contains(p), expected) << p[0] << " " << p[1];
        ASSERT_EQ(fixed.contains_plainly(p), expected);
        const std::uint32_t extent = (1u << i % 30) - 1;
        const RegionSide side = fixed.side_of({p, {p[0] + extent, p[1] + extent}});
        ++count[static_cast<std::size_t>(side)];
        for (int j = 0; j < 5 && side != RegionSide::crossed; ++j)
            ASSERT_EQ(is_free({p[0] + static_cast<std::uint32_t>(random()) % (extent + 1),
                               p[1] + static_cast<std::uint32_t>(random()) % (extent + 1)}),
                      side == RegionSide::inside);
    }
    EXPECT_GT(inside, 100);
    EXPECT_LT(inside, 900);
    for (const int each : count) EXPECT_GT(each, 20);
}

}
}
