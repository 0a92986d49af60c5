// Differences of directions along outlines: against closed forms, and against all starts of outlines in equal pieces.
#include "tiles/isohedral/goal_outline.hpp"

#include "tests/support/errors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

using TurnedPolygon = std::vector<PlanePoint>;

/// A rectangle turns earlier or later than a square on a part p of the perimeter, by a right angle: its directions
/// differ by pi / 2 sqrt(p (1 - p)) once the mean is taken away, where one of two pairs of corners coincides.
TEST(TurningDistances, OfRectanglesAreKnown)
{
    const TurnedPolygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (const double length : {1.0, 1.5, 2.0, 7.0, 100.0}) {
        const TurnedPolygon rectangle{{0, 0}, {length, 0}, {length, 1}, {0, 1}};
        const double p = 0.5 - 1 / (1 + length);
        EXPECT_NEAR(turning_distance(square, rectangle), std::numbers::pi / 2 * std::sqrt(p * (1 - p)), 1e-12);
        EXPECT_NEAR(turning_distance(rectangle, square), std::numbers::pi / 2 * std::sqrt(p * (1 - p)), 1e-12);
    }
}

/// Polyominoes have corners at whole lengths, so that pieces of equal length, as many as both perimeters divide, have
/// one direction each: all starts of these by brute force.
double distance_by_pieces(const TurnedPolygon& a, const TurnedPolygon& b)
{
    const auto perimeter = [](const TurnedPolygon& p) {
        double sum = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const PlanePoint &from = p[i], &to = p[(i + 1) % p.size()];
            sum += std::abs(to[0] - from[0]) + std::abs(to[1] - from[1]);
        }
        return static_cast<int>(sum);
    };
    const int pieces = std::lcm(perimeter(a), perimeter(b));
    const auto directions = [&](const TurnedPolygon& p) {
        std::vector<double> all;
        double turned = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const PlanePoint &from = p[i], &to = p[(i + 1) % p.size()], &next = p[(i + 2) % p.size()];
            const PlanePoint u{to[0] - from[0], to[1] - from[1]}, v{next[0] - to[0], next[1] - to[1]};
            const auto side = static_cast<int>(std::abs(u[0]) + std::abs(u[1]));
            all.insert(all.end(), static_cast<std::size_t>(side * (pieces / perimeter(p))), turned);
            turned += u[0] * v[1] - u[1] * v[0] > 0 ? std::numbers::pi / 2 : -std::numbers::pi / 2;
        }
        return all;
    };
    const std::vector<double> of_a = directions(a), of_b = directions(b);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t start = 0; start < of_b.size(); ++start) {
        double sum = 0, squares = 0;
        for (std::size_t i = 0; i < of_a.size(); ++i) {
            const std::size_t j = start + i;
            const double difference = of_a[i] - of_b[j % of_b.size()] - (j < of_b.size() ? 0 : 2 * std::numbers::pi);
            sum += difference / pieces;
            squares += difference * difference / pieces;
        }
        least = std::min(least, squares - sum * sum);
    }
    return std::sqrt(std::max(0.0, least));
}

TEST(TurningDistances, AgreeWithAllStartsOfPolyominoes)
{
    const std::vector<TurnedPolygon> shapes{
        {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
        {{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}},
        {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}},
        {{0, 0}, {5, 0}, {5, 1}, {0, 1}},
        {{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 2}, {2, 2}, {2, 3}, {0, 3}},
    };
    for (const TurnedPolygon& a : shapes)
        for (const TurnedPolygon& b : shapes)
            EXPECT_NEAR(turning_distance(a, b), distance_by_pieces(a, b), 1e-7); // the root of rounding where it is 0
}

TEST(TurningDistances, DoNotDependOnSizePlaceRotationAndStart)
{
    const TurnedPolygon shape{{0, 0}, {4, 0}, {4, 3}, {3, 3}, {2.5, 1}, {1, 1}, {1, 2}, {0, 3}};
    const TurnedPolygon other{{0, 0}, {3, 0}, {1, 1}, {0, 3}};
    TurnedPolygon moved;
    for (const auto& [x, y] : shape) moved.push_back({3 + 0.6 * 7 * x - 0.8 * 7 * y, -2 + 0.8 * 7 * x + 0.6 * 7 * y});
    std::ranges::rotate(moved, moved.begin() + 3);
    EXPECT_NEAR(turning_distance(shape, moved), 0, 1e-7);
    EXPECT_GT(turning_distance(shape, other), 0.1);
    EXPECT_NEAR(turning_distance(shape, other), turning_distance(other, moved), 1e-12);
}

TEST(GoalOutlines, GoRoundOnceInEqualSteps)
{
    const GoalOutline goal({{0, 0}, {0, 2}, {2, 2}, {2, 0}}); // clockwise
    EXPECT_EQ(goal.perimeter(), 8);
    EXPECT_NEAR(area_of(goal.corners()), 4.0 / 64, 1e-15);
    for (const std::size_t count : {1, 2, 4, 7, 8, 100}) {
        const auto places = goal.places(count);
        ASSERT_EQ(places.size(), count);
        for (std::size_t i = 0; i < count; ++i) { // the square from (1/4, 0) on, which was its last corner
            const double length = static_cast<double>(i) / static_cast<double>(count);
            const double along = length * 4 - std::floor(length * 4);
            const std::array<PlanePoint, 4> sides{PlanePoint{1, along}, {1 - along, 1}, {0, 1 - along}, {along, 0}};
            const auto side = static_cast<std::size_t>(length * 4);
            const PlanePoint& p = goal.corners()[0][0] > 0 ? sides[side] : sides[(side + 3) % 4];
            EXPECT_NEAR(places[i][0], p[0] / 4, 1e-12);
            EXPECT_NEAR(places[i][1], p[1] / 4, 1e-12);
        }
    }
    std::vector<PlanePoint> far;
    goal.append_places(5.9, 6.1, 2, far); // across the start, several rounds on
    const auto all = goal.places(10);
    EXPECT_NEAR(far[0][0], all[9][0], 1e-12);
    EXPECT_NEAR(far[0][1], all[9][1], 1e-12);
    EXPECT_NEAR(far[1][0], all[0][0], 1e-12);
    EXPECT_NEAR(far[1][1], all[0][1], 1e-12);
}

TEST(GoalOutlines, NeedAnArea)
{
    EXPECT_EQ(message_of([] { GoalOutline({{0, 0}, {1, 0}}); }), "has no area");
    EXPECT_EQ(message_of([] { GoalOutline({{0, 0}, {1, 1}, {2, 2}}); }), "has no area");
    EXPECT_EQ(message_of([] { GoalOutline({}); }), "has no area");
}

}
}
