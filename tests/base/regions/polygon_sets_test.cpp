// Unions, differences and corridors: areas by closed forms and by counting squares.
#include "base/regions/polygon_sets.hpp"

#include "base/regions/region_source.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::string square(double x, double y, double side)
{
    return fmt::format("(({0} {1}, {2} {1}, {2} {3}, {0} {3}, {0} {1}))", x, y, x + side, y + side);
}

TEST(Layers, BecomeTheirUnion)
{
    const std::string overlapping = "MULTIPOLYGON (" + square(0, 0, 10) + "," + square(5, 5, 10) + ")";
    const PlaneRegion region = read_region(overlapping);
    EXPECT_THAT(region.polygons, SizeIs(1));
    EXPECT_EQ(area_of(region), 175);
    EXPECT_THAT(region.source->notes,
                ElementsAre(HasSubstr("2 polygons overlap or share edges: the region is their union, of 1 polygon")));
    EXPECT_THAT(message_of([&] { read_region(overlapping, {.overlap = PolygonOverlap::refuse}); }),
                HasSubstr("polygon 1: the outline and polygon 2: the outline cross"));
    // Parcels side by side, one with a corner more; around a court, which is a hole; one within another.
    EXPECT_EQ(area_of(read_region("MULTIPOLYGON (((0 0, 4 0, 4 4, 0 4, 0 0)), ((4 0, 8 0, 8 4, 4 4, 4 2, 4 0)))")), 32);
    const PlaneRegion court =
        read_region("GEOMETRYCOLLECTION (POLYGON ((0 0, 9 0, 9 3, 0 3, 0 0)), POLYGON ((0 6, 9 6, "
                    "9 9, 0 9, 0 6)), POLYGON ((0 3, 3 3, 3 6, 0 6, 0 3)), POLYGON ((6 3, 9 3, 9 "
                    "6, 6 6, 6 3)))");
    ASSERT_THAT(court.polygons, SizeIs(1));
    EXPECT_THAT(court.polygons[0].holes, SizeIs(1));
    EXPECT_EQ(area_of(court), 72);
    EXPECT_EQ(area_of(read_region("MULTIPOLYGON (" + square(0, 0, 10) + "," + square(2, 2, 3) + ")")), 100);
    // Polygons that touch in points stay as they are, without a word.
    const PlaneRegion touching = read_region("MULTIPOLYGON (" + square(0, 0, 4) + "," + square(4, 4, 4) + ")");
    EXPECT_THAT(touching.polygons, SizeIs(2));
    EXPECT_TRUE(touching.source->notes.empty());
    // A polygon that is wrong by itself is not mended.
    EXPECT_THAT(message_of([&] { read_region("MULTIPOLYGON (" + square(0, 0, 4) + ", ((0 0, 4 4, 4 0, 0 4, 0 0)))"); }),
                HasSubstr("polygon 2: the outline crosses or touches itself"));
}

/// Squares on a lattice, whose union is counted cell by cell.
TEST(Layers, HaveAsMuchAreaAsTheCellsThatTheyCover)
{
    std::mt19937 random(3);
    for (int round = 0; round < 20; ++round) {
        std::array<std::array<bool, 30>, 30> is_covered{};
        std::string text;
        for (int i = 0; i < 25; ++i) {
            const int x = static_cast<int>(random() % 24), y = static_cast<int>(random() % 24),
                      side = 1 + static_cast<int>(random() % 6);
            text += (text.empty() ? "MULTIPOLYGON (" : ",") + square(x, y, side);
            for (int u = x; u < x + side; ++u)
                for (int v = y; v < y + side; ++v)
                    is_covered[static_cast<std::size_t>(u)][static_cast<std::size_t>(v)] = true;
        }
        double cells = 0;
        for (const auto& row : is_covered)
            for (const bool each : row) cells += each;
        EXPECT_EQ(area_of(read_region(text + ")")), cells);
    }
}

/// The area of the polygon with 360 corners that stands for a disk.
double disk_area(double radius) { return 180 * std::sin(std::numbers::pi / 180) * radius * radius; }

TEST(Corridors, HaveTheAreaAroundLines)
{
    const RegionReading two{.buffer = 2};
    EXPECT_NEAR(area_of(read_region("LINESTRING (0 0, 30 0)", two)), 120 + disk_area(2), 1e-9);
    EXPECT_NEAR(area_of(read_region("POINT (7 7)", two)), disk_area(2), 1e-9);
    EXPECT_NEAR(area_of(read_region("POLYGON ((0 0, 10 0, 10 5, 0 5, 0 0))", two)), 50 + 30 * 2 + disk_area(2), 1e-9);
    // Two that cross at a right angle share a square; a turn fills the outer corner by a quarter of a disk.
    EXPECT_NEAR(area_of(read_region("MULTILINESTRING ((-10 0, 10 0), (0 -10, 0 10))", two)),
                160 - 16 + 2 * disk_area(2), 1e-9);
    EXPECT_NEAR(area_of(read_region("LINESTRING (0 0, 20 0, 20 20)", two)), 160 - 4 + 1.25 * disk_area(2), 1e-9);
    EXPECT_EQ(read_region("MULTIPOINT (0 0, 3 0, 9 0)", two).polygons.size(), 2U);
    EXPECT_THAT(message_of([] { read_region("LINESTRING (0 0, 30 0)"); }),
                HasSubstr("has points or lines and no polygon: the region is empty, unless a buffer"));
}

/// In degrees the distance is in metres: a road of ten kilometres.
TEST(Corridors, GrowByMetresOnTheGlobe)
{
    const double degree = 111319.49079327357; // of the equator of WGS 84
    const PlaneRegion road =
        read_region(R"({"type": "LineString", "coordinates": [[10, 0], [10.1, 0]]})", {.buffer = 5});
    EXPECT_NEAR(area_of(road), 10 * degree / 10 + disk_area(5), 0.1);
}

}
}
