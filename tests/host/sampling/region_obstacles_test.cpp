// Darts among obstacles: kernel against reference, and saturation by a fine grid of places.
#include "host/sampling/dart_throwing.hpp"

#include "base/regions/obstacles.hpp"
#include "base/regions/region_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// In a square of side 100 that is the whole grid.
struct ObstacleCase
{
    std::string obstacles;
    double min_distance, from_lines, from_points; ///< of the square
    bool has_disks = false;
};

void PrintTo(const ObstacleCase& c, std::ostream* out) { *out << c.obstacles << ", distance " << c.min_distance; }

DartThrowingRequest request_among(const ObstacleCase& c)
{
    const PlaneRegion square = read_region("rectangle 0 0 100 100");
    const Obstacles obstacles = read_obstacles(c.obstacles);
    const double side = FixedRegion::torus_side(box_of(square));
    const KeptAway kept{lines_within(obstacles, box_of(square)), points_within(obstacles, box_of(square)),
                        c.from_lines / side, c.from_points / side, box_of(square)};
    DartThrowingRequest request;
    request.min_distance = c.min_distance / side;
    request.stream = stream_key(3, Purpose::dart_throwing, 0);
    request.region = std::make_shared<const FixedRegion>(without_polygons(square, obstacles.polygons),
                                                         c.has_disks ? request.min_distance / 2 : 0, kept);
    return request;
}

class DartsAmongObstacles : public testing::TestWithParam<ObstacleCase>
{
};

TEST_P(DartsAmongObstacles, AreThoseOfTheReferenceAndLeaveNoRoom)
{
    const DartThrowingRequest request = request_among(GetParam());
    const FixedRegion& region = *request.region;
    const PointSet expected = reference::throw_darts(request);
    ASSERT_GT(expected.size(), 3U);
    for (const DartSettling settling : {DartSettling::in_order, DartSettling::in_rounds})
        EXPECT_EQ(DartThrower(Device::open(), 0, settling).throw_darts(request), expected);
    const auto gap = [&](std::size_t i, double x, double y) {
        return std::hypot(expected[i][0] - x, expected[i][1] - y);
    };
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_TRUE(region.contains_plainly({static_cast<std::uint32_t>(expected[i][0] * 0x1p32),
                                             static_cast<std::uint32_t>(expected[i][1] * 0x1p32)}));
        for (std::size_t j = 0; j < i; ++j) ASSERT_GE(gap(j, expected[i][0], expected[i][1]), request.min_distance);
    }
    // Positions of the grid of coordinates themselves, all of which must be covered.
    constexpr std::uint32_t places = 200, step = (1u << 31) / places;
    for (std::uint32_t n = 0; n < places * places; ++n) {
        const TorusPoint<2> p{n % places * step + 1234, n / places * step + 567};
        if (!region.contains_plainly(p)) continue;
        bool is_covered = false;
        for (std::size_t i = 0; i < expected.size() && !is_covered; ++i)
            is_covered = gap(i, p[0] * 0x1p-32, p[1] * 0x1p-32) < request.min_distance;
        ASSERT_TRUE(is_covered) << p[0] << " " << p[1];
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, DartsAmongObstacles,
                         testing::Values(ObstacleCase{"POINT (50 50)", 45, 0.05, 45},
                                         ObstacleCase{"LINESTRING (10 10, 60 60)", 45, 3, 45},
                                         ObstacleCase{"rectangle 40 -10 60 50", 45, 1, 45}));

INSTANTIATE_TEST_SUITE_P(
    Kinds, DartsAmongObstacles,
    testing::Values(
        ObstacleCase{"MULTIPOINT ((20 20), (70 30), (50 90))", 5, 0.01, 5},
        ObstacleCase{"MULTIPOINT ((20 20), (20 20), (70 30))", 5, 0.01, 30},
        ObstacleCase{"LINESTRING (10 10, 50 60, 50 90, 130 40)", 5, 3, 5},
        ObstacleCase{"LINESTRING (10 10, 50 60, 50 90, 130 40)", 5, 0.005, 5}, // a thousandth of the distance
        ObstacleCase{"POLYGON ((20 20, 80 20, 80 80, 20 80, 20 20), (30 30, 30 70, 70 70, 70 30, 30 30))", 4, 2, 5},
        // They overlap, share an edge, all but share one, and lie over the boundary.
        ObstacleCase{"MULTIPOLYGON (((10 10,40 10,40 40,10 40,10 10)),((30 30,60 30,60 60,30 60,30 30)),"
                     "((60 30,80 30,80 60,60 60,60 30)),((80.00000001 30,90 30,90 60,80.00000001 60,80.00000001 30)),"
                     "((-10 70,110 70,50 80,-10 70)))",
                     5, 0.005, 5},
        ObstacleCase{"disk 50 50 30", 5, 1, 5, true}));

}
}
