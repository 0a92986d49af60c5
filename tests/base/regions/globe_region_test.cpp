// Regions in longitude and latitude: areas by closed forms of the ellipsoid, distances by Karney's geodesics, places in
// other systems by PROJ's program cs2cs.
#include "base/regions/globe/map_system.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/region_source.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"

#include <fmt/format.h>
#include <geodesic.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

constexpr double globe_a = 6378137, globe_flattening = 1 / 298.257223563;

/// The area of the ellipsoid from the equator to a latitude, for a radian of longitude (Snyder 1987, equation 3-12).
double area_to(double latitude)
{
    const double e2 = globe_flattening * (2 - globe_flattening), e = std::sqrt(e2);
    const double s = std::sin(latitude * std::numbers::pi / 180);
    const double q = (1 - e2) * (s / (1 - e2 * s * s) - std::log((1 - e * s) / (1 + e * s)) / (2 * e));
    return globe_a * globe_a * q / 2;
}

double area_between(double west, double south, double east, double north)
{
    return (area_to(north) - area_to(south)) * (east - west) * std::numbers::pi / 180;
}

std::string geojson_box(double west, double south, double east, double north)
{
    return fmt::format("[[[{0},{1}],[{2},{1}],[{2},{3}],[{0},{3}],[{0},{1}]]]", west, south, east, north);
}

std::string polygon_of(const std::string& coordinates)
{
    return R"({"type": "Polygon", "coordinates": )" + coordinates + "}";
}

PlaneRegion globe_box(double west, double south, double east, double north)
{
    return read_region(polygon_of(geojson_box(west, south, east, north)));
}

double geodesic_distance(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
    geod_geodesic globe;
    geod_init(&globe, globe_a, globe_flattening);
    double length = 0;
    geod_inverse(&globe, a[1], a[0], b[1], b[0], &length, nullptr, nullptr);
    return length;
}

TEST(GlobeRegions, HaveTheAreaOfTheEllipsoid)
{
    for (const auto& [west, south, east, north] :
         std::initializer_list<std::array<double, 4>>{{4.70, 50.86, 4.71, 50.87},
                                                      {2.5, 49.5, 6.4, 51.5},
                                                      {-20, -10, 20, 15},
                                                      {-70, -56, -66, -50},
                                                      {10, 78, 33, 81}}) {
        const PlaneRegion region = globe_box(west, south, east, north);
        const double area = area_between(west, south, east, north);
        EXPECT_NEAR(area_of(region) / area, 1, 4e-6) << west << " " << south;
        EXPECT_TRUE(is_mapped(region));
        EXPECT_EQ(region.crs, "");
    }
}

/// Distances of places that are anywhere in the region.
TEST(GlobeRegions, HaveDistancesWithinTheStatedError)
{
    std::mt19937 random(7);
    for (const auto& [west, south, east, north] : std::initializer_list<std::array<double, 4>>{
             {4.70, 50.86, 4.71, 50.87}, {2.5, 49.5, 6.4, 51.5}, {-20, -10, 20, 15}, {10, 60, 33, 81}}) {
        const PlaneRegion region = globe_box(west, south, east, north);
        const double stated = region.source->distortion;
        double largest = 0;
        for (int i = 0; i < 1000; ++i) {
            std::array<std::array<double, 2>, 2> places{};
            PointSet plane{2, {}};
            for (auto& place : places) {
                place = {std::uniform_real_distribution(west, east)(random),
                         std::uniform_real_distribution(south, north)(random)};
                plane.coordinates.insert(plane.coordinates.end(), place.begin(), place.end());
            }
            plane = as_in_plane(region, plane);
            const double there = std::hypot(plane[0][0] - plane[1][0], plane[0][1] - plane[1][1]);
            largest = std::max(largest, std::abs(there / geodesic_distance(places[0], places[1]) - 1));
            const PointSet back = as_in_files(region, plane);
            for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(back.coordinates[k], places[k / 2][k % 2], 1e-12);
        }
        EXPECT_LE(largest, stated * (1 + 1e-6) + 1e-9);
        EXPECT_GT(largest, stated / 20) << "the stated error is not far too large";
    }
}

/// Cut in two as RFC 7946 wants it, and beyond 180 degrees: these are one region.
TEST(GlobeRegions, CrossTheAntimeridian)
{
    const std::string cut = R"({"type": "MultiPolygon", "coordinates": [)" + geojson_box(177, -19, 180, -16) + "," +
                            geojson_box(-180, -19, -178, -16) + "]}";
    const std::string beyond = polygon_of(geojson_box(177, -19, 182, -16));
    const std::string uncut = polygon_of("[[[177,-19],[-178,-19],[-178,-16],[177,-16],[177,-19]]]");
    const double area = area_between(177, -19, 182, -16);
    EXPECT_THAT(
        message_of([&] { read_region(uncut); }),
        HasSubstr("the edge from (177, -19) to (-178, -19) goes around more than half of the Earth: what crosses "
                  "the antimeridian is cut there, or goes on beyond 180"));
    for (const std::string& text : {cut, beyond}) {
        const PlaneRegion region = read_region(text);
        EXPECT_THAT(region.polygons, SizeIs(1));
        EXPECT_NEAR(area_of(region) / area, 1, 4e-6) << text;
        EXPECT_LT(box_of(region).longest(), 600e3);
    }
    // Its points come back in longitudes of the standard.
    const PlaneRegion region = read_region(beyond);
    const PointSet back = as_in_files(region, as_in_plane(region, {2, {181, -17, -179, -17, 179, -17}}));
    EXPECT_NEAR(back[0][0], -179, 1e-9);
    EXPECT_NEAR(back[1][0], -179, 1e-9);
    EXPECT_NEAR(back[2][0], 179, 1e-9);
}

/// Rings around a pole have the seam that plate carrée wants.
TEST(GlobeRegions, LieAroundPoles)
{
    std::string around = "[180,90],", seamed;
    for (int i = 180; i >= -180; i -= 10) around += fmt::format("[{},75],", i);
    for (int i = -180; i <= 180; i += 10) seamed += fmt::format("[{},-75],", i);
    around = "[[" + around + "[-180,90],[180,90]]]";
    seamed = "[[" + seamed + "[180,-90],[-180,-90],[-180,-75]]]";
    const double cap = area_between(0, 75, 360, 90);
    const PlaneRegion north = read_region(polygon_of(around));
    EXPECT_NEAR(area_of(north) / cap, 1, 4e-6);
    EXPECT_EQ(std::abs(north.source->map->middle()[1]), 90);
    const PlaneRegion south = read_region(polygon_of(seamed));
    EXPECT_NEAR(area_of(south) / cap, 1, 4e-6);
    EXPECT_EQ(south.source->map->middle()[1], -90);
    // The seam is no edge: a place on it is as far from the boundary as others on its parallel.
    for (const auto& corner : south.polygons.at(0).outline) {
        PointSet place = as_in_files(south, {2, {corner[0], corner[1]}});
        EXPECT_NEAR(place[0][1], -75, 1e-4);
    }
}

TEST(GlobeRegions, AreRefusedWhereNoPlaneHasTheirDistances)
{
    EXPECT_THAT(message_of([] { globe_box(-80, -60, 80, 70); }),
                HasSubstr("is too large for a plane: lengths would be off by up to"));
    EXPECT_THAT(message_of([] { globe_box(-180, -90, 180, 90); }), HasSubstr("is too large for a plane"));
    EXPECT_THAT(message_of([] { globe_box(-170, -9, 170, 9); }), HasSubstr("goes around more than half of the Earth"));
    EXPECT_THAT(message_of([] { read_region("POLYGON ((4.70 50.86, 4.71 50.86, 4.71 50.87, 4.70 50.86))"); }),
                HasSubstr("say which they are (crs EPSG:4326), or that they are lengths (planar)"));
}

TEST(GlobeRegions, SayTheirPlane)
{
    const PlaneRegion region = globe_box(4.70, 50.86, 4.71, 50.87);
    EXPECT_THAT(region.source->notes,
                ElementsAre(HasSubstr("longitude and latitude (WGS 84 (CRS84)) are mapped to Lambert's azimuthal "
                                      "equal-area plane around (4.705, 50.865): lengths are metres there, off by")));
    EXPECT_EQ(region.source->features.size(), 0U);
}

/// EWKT, the member crs of older GeoJSON, and an option say the system; grads of Paris are angles as well.
TEST(RegionSystems, AreSaidInSeveralWays)
{
    const std::string box = "POLYGON ((4.70 50.86, 4.71 50.86, 4.71 50.87, 4.70 50.87, 4.70 50.86))";
    const double area = area_between(4.70, 50.86, 4.71, 50.87);
    EXPECT_NEAR(area_of(read_region("SRID=4326;" + box)) / area, 1, 4e-6);
    EXPECT_NEAR(area_of(read_region(box, {.crs = "EPSG:4326"})) / area, 1, 4e-6);
    EXPECT_NEAR(area_of(read_region("rectangle 4.70 50.86 4.71 50.87", {.crs = "EPSG:4326"})) / area, 1, 4e-6);
    EXPECT_NEAR(area_of(read_region("SRID=4258;" + box)) / area, 1, 4e-6) << "of GRS 80, nearly the same ellipsoid";
    EXPECT_FALSE(is_mapped(read_region("SRID=0;POLYGON ((0 0, 9 0, 9 9, 0 0))")));
    const std::string grads = "POLYGON ((0 50, 1 50, 1 51, 0 51, 0 50))"; // 0.9 degrees
    EXPECT_NEAR(area_of(read_region(grads, {.crs = "EPSG:4807"})) / area_between(0, 45, 0.9, 45.9), 1, 1e-3)
        << "of Clarke's ellipsoid";
    const PlaneRegion belgian = read_region("SRID=31370;POLYGON ((0 0, 9 0, 9 9, 0 0))");
    EXPECT_FALSE(is_mapped(belgian));
    EXPECT_EQ(belgian.crs, R"({"properties":{"name":"EPSG:31370"},"type":"name"})");
    EXPECT_EQ(area_of(belgian), 40.5);
    EXPECT_THAT(message_of([&] { read_region("SRID=999999;" + box); }),
                HasSubstr("EPSG:999999: PROJ knows no such system of coordinates"));
    EXPECT_THAT(message_of([&] { read_region(box, {.crs = "EPSG:5773"}); }),
                HasSubstr("EGM96 height, a system neither of a plane"));
    EXPECT_EQ(read_region("SRID=4326;" + box, {.is_planar = true}).polygons.at(0).outline.at(0),
              (std::array{4.70, 50.86}));
}

/// In Mercator's map of the web a metre in Belgium is 1.58 long: 1 / cos(50.86 degrees).
TEST(RegionSystems, WhoseMetresAreNoneAreTold)
{
    const PlaneRegion region =
        read_region("SRID=3857;POLYGON ((523000 6595000, 524000 6595000, 524000 6596000, 523000 6595000))");
    ASSERT_THAT(region.source->notes, SizeIs(1));
    EXPECT_THAT(region.source->notes[0], HasSubstr("a metre on the ground is 1.58"));
}

TEST(GlobeObstacles, LieInThePlaneOfTheRegion)
{
    const PlaneRegion region = globe_box(4.70, 50.86, 4.71, 50.87);
    const std::string point = R"({"type": "Point", "coordinates": [4.7051, 50.8612]})";
    const Obstacles own = read_obstacles(point, {}, region);
    const PointSet expected = as_in_plane(region, {2, {4.7051, 50.8612}});
    EXPECT_THAT(own.points, ElementsAre(std::array{expected[0][0], expected[0][1]}));
    EXPECT_EQ(read_obstacles("POINT (4.7051 50.8612)", {}, region).points, own.points) << "without SRID: the region's";
    // By cs2cs OGC:CRS84 EPSG:31370, and back.
    const auto near = [](const std::array<double, 2>& a, double x, double y) {
        return std::hypot(a[0] - x, a[1] - y) < 1e-3;
    };
    const PlaneRegion belgian =
        read_region("SRID=31370;POLYGON ((173000 172000, 174000 172000, 174000 173000, 173000 172000))");
    EXPECT_TRUE(near(read_obstacles(point, {}, belgian).points.at(0), 173680.168984, 172366.408921));
    EXPECT_TRUE(near(read_obstacles("SRID=31370;POINT (173680.168984 172366.408921)", {}, region).points.at(0),
                     expected[0][0], expected[0][1]));
    EXPECT_THAT(message_of([&] { read_obstacles(point, {}, read_region("rectangle 0 0 9 9")); }),
                HasSubstr("the region's system of coordinates is not said"));
}

/// A track along a parallel bends in the plane, and the far end of a long one does not matter.
TEST(GlobeObstacles, HaveLinesThatBend)
{
    RegionReading along;
    along.is_along = true;
    const PlaneRegion inside = globe_box(4, 50, 6, 51);
    const PlaneRegion track = read_region(R"({"type": "LineString", "coordinates": [[4, 50], [6, 51]]})", along);
    for (const PlaneRegion& region : {inside, track}) {
        const Obstacles line =
            read_obstacles(R"({"type": "LineString", "coordinates": [[-60, 50.5], [70, 50.5]]})", {}, region);
        ASSERT_THAT(line.lines, SizeIs(1));
        EXPECT_GT(line.lines[0].size(), 50U);
        EXPECT_LT(line.lines[0].size(), 5000U);
        const RegionBox box = lines_of(region).empty() ? box_of(region) : box_around(lines_of(region));
        for (const auto& a : lines_within(line, box))
            for (const double part : {0.0, 0.5, 1.0}) {
                const PointSet place =
                    as_in_files(region, {2, {a[0] + part * (a[2] - a[0]), a[1] + part * (a[3] - a[1])}});
                EXPECT_NEAR(place[0][1], 50.5, 3e-6);
            }
    }
}

}
}
