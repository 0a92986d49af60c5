// The checks of chains, against plain definitions in floating point.
#include "tiles/poisson/chain_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

UnitPosition random_position(std::mt19937& random, int reach)
{
    std::uniform_int_distribution<std::int32_t> coordinate(-reach, reach);
    return {coordinate(random), coordinate(random), 0};
}

/// A star around (7, -3), whose corners are at whole degrees.
std::vector<UnitPosition> star(std::mt19937& random, int corners)
{
    std::vector<UnitPosition> polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners, radius = 5000 + static_cast<double>(random() % 20000);
        polygon.push_back({7 + static_cast<std::int32_t>(radius * std::cos(angle)),
                           -3 + static_cast<std::int32_t>(radius * std::sin(angle)), 0});
    }
    return polygon;
}

/// True if a polygon goes around a point, by the sum of the angles under which the point sees the edges.
bool is_wound_around(const std::vector<UnitPosition>& polygon, const UnitPosition& point)
{
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const UnitPosition &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double ax = a[0] - point[0], ay = a[1] - point[1], bx = b[0] - point[0], by = b[1] - point[1];
        sum += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    }
    return std::abs(sum) > std::numbers::pi;
}

TEST(ChainGeometry, InsideIsWhereThePolygonGoesAround)
{
    std::mt19937 random(1);
    int inside = 0;
    for (int corners = 3; corners < 40; ++corners) {
        const auto polygon = star(random, corners);
        EXPECT_TRUE(is_simple(polygon)) << corners;
        EXPECT_GT(twice_area(polygon), 0);
        for (int n = 0; n < 200; ++n) {
            const UnitPosition point = random_position(random, 20000);
            inside += is_wound_around(polygon, point);
            EXPECT_EQ(is_strictly_inside(polygon, point), is_wound_around(polygon, point));
        }
        for (const UnitPosition& corner : polygon) EXPECT_FALSE(is_strictly_inside(polygon, corner));
    }
    EXPECT_GT(inside, 1000);
}

TEST(ChainGeometry, BordersAreOutside)
{
    const std::vector<UnitPosition> square{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}};
    for (std::int32_t y = -1; y < 10; ++y)
        for (std::int32_t x = -1; x < 10; ++x)
            EXPECT_EQ(is_strictly_inside(square, {x, y, 0}), x > 0 && x < 8 && y > 0 && y < 8) << x << " " << y;
    EXPECT_EQ(twice_area(square), 128);
}

TEST(ChainGeometry, PolygonsThatTouchThemselvesAreNotSimple)
{
    EXPECT_FALSE(is_simple(std::vector<UnitPosition>{{0, 0, 0}, {8, 8, 0}, {8, 0, 0}, {0, 8, 0}})) << "crosses";
    EXPECT_FALSE(is_simple(std::vector<UnitPosition>{{0, 0, 0}, {8, 0, 0}, {4, 0, 0}, {4, 8, 0}})) << "goes back";
    EXPECT_FALSE(is_simple(std::vector<UnitPosition>{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {4, 0, 0}, {0, 8, 0}}))
        << "touches";
    EXPECT_FALSE(is_simple(std::vector<UnitPosition>{{0, 0, 0}, {0, 0, 0}, {8, 0, 0}, {0, 8, 0}})) << "twice";
    EXPECT_TRUE(is_simple(std::vector<UnitPosition>{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}))
        << "straight";
}

TEST(ChainGeometry, ConesAreThoseOfTheirSides)
{
    std::mt19937 random(2);
    const std::int64_t distance = 6000;
    int in = 0;
    for (int n = 0; n < 4000; ++n) {
        const UnitPosition point = random_position(random, 30000), corner = random_position(random, 3000);
        for (std::size_t direction = 0; direction < 2; ++direction)
            for (const int outward : {1, -1}) {
                const double along = outward * (point[direction] - corner[direction]);
                const double across = point[1 - direction] - corner[1 - direction];
                // The distances from the two sides, positive inside.
                const double one = (along - across) / std::sqrt(2.0), other = (along + across) / std::sqrt(2.0);
                const bool expected = one >= distance / 2.0 && other >= distance / 2.0;
                if (std::min(std::abs(one - distance / 2.0), std::abs(other - distance / 2.0)) < 1e-6) continue;
                in += expected;
                EXPECT_EQ(is_in_cone(point, corner, direction, outward, distance * distance), expected);
            }
    }
    EXPECT_GT(in, 1000);
}

TEST(ChainGeometry, PointsNearTheirEdgeLeaveHalfTheDistance)
{
    const std::int64_t distance = 6000;
    EXPECT_TRUE(is_near_edge({0, 32768 - 3000, 0}, 0, distance * distance));
    EXPECT_FALSE(is_near_edge({0, 32768 - 2999, 0}, 0, distance * distance));
    EXPECT_TRUE(is_near_edge({-32768 + 3000, 0, 0}, 1, distance * distance));
    EXPECT_FALSE(is_near_edge({0, 40000, 0}, 0, distance * distance));
}

/// A chain of one colour, whose corner point is 8,000 units above the lattice point.
std::string fault_of(const Chain& chain, std::int64_t distance)
{
    ChainPieces pieces(1, 1);
    pieces.corners = {{0, 8000, 0}};
    pieces.chains[0] = {chain};
    return fault_of_chain(pieces, 0, 0, 0, distance * distance).value_or("none");
}

TEST(ChainGeometry, FaultsNameThePoint)
{
    const Chain chain{{20000, 8000, 0}, {32768, 22000, 0}, {45536, 8000, 0}};
    EXPECT_EQ(fault_of(chain, 20000), "none");
    EXPECT_EQ(fault_of({chain[0], {32768, 26000, 0}, chain[2]}, 20000),
              "point at (32768, 26000): must be nearer to its edge");
    EXPECT_EQ(fault_of({chain[0], {32768, 27000, 0}, chain[2]}, 20000),
              "point at (32768, 27000): must be in the cones of its ends");
    EXPECT_EQ(fault_of({chain[0], chain[2]}, 14000),
              "link from (20000, 8000) to (45536, 8000) of length 25536.0: must be at most sqrt 3 times the minimum "
              "distance, 24248.7");
}

/// The lemma: a point that is 2 r from both ends of a link of length 2 sqrt 3 r is r away from all of it.
TEST(ChainGeometry, ShortLinksKeepDisksApart)
{
    EXPECT_TRUE(is_short_link(300, 100));
    EXPECT_FALSE(is_short_link(301, 100));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0, 1), place(-4, 4);
    double nearest = 1e9;
    for (int n = 0; n < 1'000'000; ++n) {
        const double length = std::sqrt(12.0), x = place(random), y = place(random); // r = 1
        if (std::hypot(x, y) < 2 || std::hypot(x - length, y) < 2) continue;
        nearest = std::min(nearest, std::hypot(x - std::clamp(x, 0.0, length), y));
    }
    EXPECT_GE(nearest, 1);
    EXPECT_LT(nearest, 1.01);
}

}
}
