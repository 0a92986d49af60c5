#include "analysis/measures/largest_empty_ball.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/set_features.hpp"

#include <gtest/gtest.h>

#include <queue>

namespace poissonlab {
namespace {

using namespace test;

double distance_to_nearest(const PointSet& points, std::span<const double> x)
{
    double least = 10;
    for (std::size_t i = 0; i < points.size(); ++i) least = std::min(least, squared_distance(points[i], x));
    return std::sqrt(least);
}

/// The largest distance from any position to its nearest point by branch and bound, within `tolerance`: the
/// distance changes by no more than the position does. Shares nothing with Delaunay triangulations.
double largest_gap(const PointSet& points, double tolerance)
{
    struct Box
    {
        double bound = 0;
        std::array<double, 3> centre{};
        double half = 0;
        bool operator<(const Box& other) const { return bound < other.bound; }
    };
    const auto d = static_cast<std::size_t>(points.dimension);
    double best = 0;
    std::priority_queue<Box> boxes;
    const auto push = [&](std::array<double, 3> centre, double half) {
        const double distance = distance_to_nearest(points, std::span(centre).first(d));
        best = std::max(best, distance);
        boxes.push({distance + half * std::sqrt(static_cast<double>(d)), centre, half});
    };
    push({0.5, 0.5, 0.5}, 0.5);
    while (!boxes.empty() && boxes.top().bound > best + tolerance) {
        const Box box = boxes.top();
        boxes.pop();
        for (unsigned corner = 0; corner < 1u << d; ++corner) {
            auto centre = box.centre;
            for (std::size_t k = 0; k < d; ++k) centre[k] += ((corner >> k & 1) ? 0.5 : -0.5) * box.half;
            push(centre, box.half / 2);
        }
    }
    return best;
}

void expect_largest_gap(const PointSet& points)
{
    constexpr double tolerance = 1e-5;
    const LargestEmptyBall ball = largest_empty_ball(points);
    const double gap = largest_gap(points, tolerance);
    EXPECT_GE(ball.radius, gap - 1e-12) << points.size() << " points in " << points.dimension << "D";
    EXPECT_LE(ball.radius, gap + tolerance) << points.size() << " points in " << points.dimension << "D";
    const auto d = static_cast<std::size_t>(points.dimension);
    EXPECT_NEAR(distance_to_nearest(points, std::span(ball.centre).first(d)), ball.radius, 1e-11);
    EXPECT_DOUBLE_EQ(ball.relative_radius, ball.radius / max_min_distance(points.size(), points.dimension));
}

TEST(LargestEmptyBall, AgreesWithASearchOfAllPositions)
{
    std::mt19937_64 random(1);
    for (const std::size_t n : {1, 2, 3, 4, 5, 8, 13, 40, 200}) {
        for (int i = 0; i < 3; ++i) {
            expect_largest_gap(random_points(n, 2, random));
            expect_largest_gap(random_points_32(n, 3, random));
        }
    }
}

/// The order in which CGAL holds the corners of tetrahedra depends on addresses in memory.
TEST(LargestEmptyBall, IsTheSameToTheLastBitEachTime)
{
    std::mt19937_64 random(3);
    const PointSet points = random_points(150, 3, random);
    const LargestEmptyBall first = largest_empty_ball(points);
    for (int n = 0; n < 5; ++n) {
        const LargestEmptyBall again = largest_empty_ball(points);
        EXPECT_EQ(again.radius, first.radius);
        EXPECT_EQ(again.centre, first.centre);
    }
}

TEST(LargestEmptyBall, OfClustersAndCoincidingPoints)
{
    std::mt19937_64 random(2);
    for (const int d : {2, 3}) {
        for (const double width : {1e-3, 1e-9, 0.0}) {
            expect_largest_gap(clustered_points(60, d, 4, width, random));
        }
        PointSet points = random_points(50, d, random);
        const PointSet copy = points;
        points.coordinates.insert(points.coordinates.end(), copy.coordinates.begin(), copy.coordinates.end());
        expect_largest_gap(points);
    }
}

TEST(LargestEmptyBall, OfLatticesIsThatOfTheTextbooks)
{
    // Coordinates i / n are rounded to 2^-53: radii within some 1e-15.
    for (const int n : {1, 2, 3, 7, 16, 60}) {
        EXPECT_NEAR(largest_empty_ball(square_lattice(n, 2)).radius, std::sqrt(0.5) / n, 1e-14) << n;
    }
    for (const int n : {1, 2, 3, 7, 10}) {
        EXPECT_NEAR(largest_empty_ball(square_lattice(n, 3)).radius, std::sqrt(0.75) / n, 1e-13) << n;
    }
    // The octahedral holes of the face-centred cubic lattice of side a: a/2; its neighbours are a/sqrt 2.
    for (const int n : {1, 2, 3, 6}) {
        const LargestEmptyBall ball = largest_empty_ball(face_centred_cubic_lattice(n));
        EXPECT_NEAR(ball.radius, 0.5 / n, 1e-13) << n;
        EXPECT_NEAR(ball.relative_radius, std::sqrt(0.5), 1e-12) << n;
    }
    // Isosceles triangles of base b and height h have the circumradius (h^2 + b^2/4) / 2h.
    const double b = 1 / 97.0, h = 1 / 112.0;
    const LargestEmptyBall hexagonal = largest_empty_ball(staggered_lattice(97, 112));
    EXPECT_NEAR(hexagonal.radius, (h * h + b * b / 4) / (2 * h), 1e-14);
    EXPECT_NEAR(hexagonal.relative_radius, 1 / std::sqrt(3), 1e-4);
}

TEST(LargestEmptyBall, RejectsWhatHasNone)
{
    EXPECT_THROW(largest_empty_ball({2, {}}), InputError);
    EXPECT_THROW(largest_empty_ball({3, {}}), InputError);
    EXPECT_THROW(largest_empty_ball({1, {0.5}}), InputError);
}

}
}
