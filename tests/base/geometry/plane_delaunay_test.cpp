// Triangulations of the plane against the definition: no point lies in the circle through a triangle.
#include "base/geometry/plane_delaunay.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

std::vector<PlanePosition> random_positions(std::size_t count)
{
    std::mt19937_64 random(7);
    std::vector<PlanePosition> positions;
    for (std::size_t i = 0; i < count; ++i)
        positions.push_back(
            {static_cast<double>(random() >> 11) * 0x1p-53, static_cast<double>(random() >> 11) * 0x1p-53});
    return positions;
}

double away(const PlanePosition& a, const PlanePosition& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

TEST(PlaneDelaunay, HasNoPointInTheCircleOfATriangle)
{
    const auto points = random_positions(200);
    for (const PlaneTriangle& triangle : plane_triangles(points)) {
        const PlanePosition &a = points[triangle.points[0]], &b = points[triangle.points[1]],
                            &c = points[triangle.points[2]];
        EXPECT_GT((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0) << "clockwise";
        const PlanePosition centre = circumcentre(a, b, c);
        const double radius = away(centre, a);
        EXPECT_NEAR(away(centre, b), radius, 1e-9 * (1 + radius));
        EXPECT_NEAR(away(centre, c), radius, 1e-9 * (1 + radius));
        for (const PlanePosition& point : points) EXPECT_GT(away(centre, point), radius * (1 - 1e-9));
    }
}

/// Triangles know each other, those at the border nothing beyond it; by Euler there are 2 n - 2 - h of them.
TEST(PlaneDelaunay, TrianglesKnowTheirNeighbours)
{
    const auto points = random_positions(300);
    const auto triangles = plane_triangles(points);
    std::size_t border = 0;
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t next = triangles[i].across[k];
            border += next == UINT32_MAX;
            if (next == UINT32_MAX) continue;
            int shared = 0;
            for (const std::uint32_t own : triangles[i].points)
                for (const std::uint32_t other : triangles[next].points) shared += own == other;
            EXPECT_EQ(shared, 2);
            for (const std::uint32_t other : triangles[next].points) EXPECT_NE(other, triangles[i].points[k]);
        }
    EXPECT_EQ(triangles.size(), 2 * points.size() - 2 - border);
}

TEST(PlaneDelaunay, TakesOneOfPointsThatCoincide)
{
    const std::vector<PlanePosition> points{{0, 0}, {1, 0}, {0, 1}, {1, 0}};
    EXPECT_EQ(plane_triangles(points).size(), 1U);
}

}
}
