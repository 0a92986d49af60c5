#include "analysis/measures/voronoi_diagram.hpp"

#include "base/errors/errors.hpp"
#include "tests/support/point_patterns.hpp"
#include "tests/support/set_features.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace poissonlab {
namespace {

using namespace test;
using Position = std::array<double, 2>;

/// The Voronoi cell of a site: a large square cut by the bisectors with all images of all points.
std::vector<Position> cell_by_cutting(const PointSet& points, std::size_t site)
{
    std::vector<Position> cell{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
    for (std::size_t j = 0; j < points.size(); ++j) {
        for (int image = 0; image < 49; ++image) {
            const Position to{points[j][0] - points[site][0] + image % 7 - 3,
                              points[j][1] - points[site][1] + image / 7 - 3};
            const double half = (to[0] * to[0] + to[1] * to[1]) / 2;
            if (half == 0) continue;
            const auto side = [&](const Position& p) { return p[0] * to[0] + p[1] * to[1] - half; };
            std::vector<Position> rest;
            for (std::size_t k = 0; k < cell.size(); ++k) {
                const Position& p = cell[k];
                const Position& q = cell[(k + 1) % cell.size()];
                const double a = side(p), b = side(q);
                if (a <= 0) rest.push_back(p);
                if ((a < 0 && b > 0) || (a > 0 && b < 0)) {
                    const double t = a / (a - b);
                    rest.push_back({p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])});
                }
            }
            cell = rest;
        }
    }
    return cell;
}

double area_of(const std::vector<Position>& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Position& p = polygon[i];
        const Position& q = polygon[(i + 1) % polygon.size()];
        twice += p[0] * q[1] - p[1] * q[0];
    }
    return twice / 2;
}

double total_area(const VoronoiDiagram& diagram)
{
    double sum = 0;
    for (const VoronoiCell& cell : diagram.cells) sum += cell.area;
    return sum;
}

TEST(VoronoiDiagram, HasTheCellsThatBisectorsCut)
{
    std::mt19937_64 random(1);
    for (const std::size_t n : {1, 2, 3, 4, 7, 20, 150}) {
        const PointSet points = test::random_points(n, 2, random);
        const VoronoiDiagram diagram = voronoi_diagram(points);
        ASSERT_EQ(diagram.cells.size(), n);
        for (std::size_t i = 0; i < n; ++i) {
            const auto expected = cell_by_cutting(points, i);
            const VoronoiCell& cell = diagram.cells[i];
            EXPECT_EQ(cell.polygon.size(), static_cast<std::size_t>(cell.neighbours));
            EXPECT_NEAR(cell.area, area_of(expected), 1e-12) << i << " of " << n;
            EXPECT_NEAR(cell.area, area_of(cell.polygon), 1e-15);
            // For one point corners coincide up to rounding, which cutting keeps.
            if (n > 1) {
                EXPECT_EQ(cell.polygon.size(), expected.size()) << i << " of " << n;
            }
            for (const Position& corner : cell.polygon) {
                double least = 1;
                for (const Position& p : expected) {
                    least = std::min(least, std::hypot(p[0] - corner[0], p[1] - corner[1]));
                }
                EXPECT_LT(least, 1e-10); // corners of sharp angles amplify rounding
            }
        }
    }
}

TEST(VoronoiDiagram, HasSixNeighboursOnAverageAndTheWholeArea)
{
    std::mt19937_64 random(2);
    for (const std::size_t n : {5, 100, 5000}) {
        const VoronoiDiagram diagram = voronoi_diagram(test::random_points(n, 2, random));
        int sum = 0;
        for (const VoronoiCell& cell : diagram.cells) sum += cell.neighbours;
        EXPECT_EQ(sum, static_cast<int>(6 * n)); // Euler's formula on the torus
        EXPECT_NEAR(total_area(diagram), 1, 1e-12);
    }
}

TEST(VoronoiDiagram, OfTinyClustersLosesNoEdges)
{
    std::mt19937_64 random(5);
    const VoronoiDiagram diagram = voronoi_diagram(clustered_points(300, 2, 2, 1e-7, random));
    int sum = 0;
    for (const VoronoiCell& cell : diagram.cells) {
        sum += cell.neighbours;
        EXPECT_GT(cell.area, 0);
    }
    EXPECT_EQ(sum, 1800);
    // Triangles with one point of the other cluster have angles down to some 1e-8, the distance of
    // neighbours: their corners are off by 1e-15 / 1e-8.
    EXPECT_NEAR(total_area(diagram), 1, 1e-7);
}

TEST(VoronoiDiagram, OfLatticesIsTheirTiling)
{
    for (const int n : {1, 2, 3, 9, 40}) {
        const VoronoiDiagram squares = voronoi_diagram(square_lattice(n, 2));
        for (const VoronoiCell& cell : squares.cells) {
            ASSERT_EQ(cell.neighbours, 4) << n;
            EXPECT_NEAR(cell.area, 1.0 / (n * n), 1e-14);
            EXPECT_NEAR(cell.polygon[0][0], -0.5 / n, 1e-14); // direction -135 degrees
            EXPECT_NEAR(cell.polygon[0][1], -0.5 / n, 1e-14);
        }
        const VoronoiStatistics statistics = voronoi_statistics(squares);
        EXPECT_NEAR(statistics.relative_area_variance, 0, 1e-20);
        EXPECT_EQ(statistics.neighbour_share, (std::array<double, 5>{1, 0, 0, 0, 0}));
    }
    const VoronoiStatistics hexagons = voronoi_statistics(voronoi_diagram(staggered_lattice(26, 30)));
    EXPECT_NEAR(hexagons.relative_area_variance, 0, 1e-20);
    EXPECT_EQ(hexagons.neighbour_share, (std::array<double, 5>{0, 0, 1, 0, 0}));
}

TEST(VoronoiDiagram, OfIndependentPointsHasThePublishedMoments)
{
    // Relative variance of areas 0.280176 (Gilbert 1962). Shares of Poisson-Voronoi cells: triangles 0.01124
    // (Hayen and Quine 2000), 4 to 7 neighbours 0.10685, 0.25944, 0.29472, 0.19877 (Okabe et al.,
    // chapter 5).
    std::mt19937_64 random(3);
    std::vector<std::vector<double>> samples(5);
    for (int i = 0; i < 30; ++i) {
        const VoronoiStatistics statistics = voronoi_statistics(voronoi_diagram(test::random_points(2000, 2, random)));
        samples[0].push_back(statistics.relative_area_variance);
        for (std::size_t k = 0; k < 4; ++k) samples[k + 1].push_back(statistics.neighbour_share[k]);
    }
    const std::array<double, 5> expected{0.280176, 0.01124 + 0.10685, 0.25944, 0.29472, 0.19877};
    for (std::size_t k = 0; k < 5; ++k) {
        const Mean mean = mean_of(samples[k]);
        // N fixed instead of Poisson distributed lowers the variance of areas by 1/N relative: not seen here.
        EXPECT_LT(std::abs(mean.value - expected[k]), z_bound(5) * mean.standard_error) << k;
    }
}

TEST(VoronoiDiagram, GivesCoincidingPointsOneCell)
{
    const VoronoiDiagram diagram = voronoi_diagram({2, {0.25, 0.5, 0.75, 0.5, 0.25, 0.5, 0.25, 0.5}});
    EXPECT_NEAR(diagram.cells[0].area, 0.5, 1e-15);
    EXPECT_EQ(diagram.cells[0].neighbours, 4);
    EXPECT_NEAR(diagram.cells[1].area, 0.5, 1e-15);
    for (const std::size_t i : {2, 3}) {
        EXPECT_EQ(diagram.cells[i].area, 0);
        EXPECT_EQ(diagram.cells[i].neighbours, 0);
        EXPECT_TRUE(diagram.cells[i].polygon.empty());
    }
    // Areas 2, 2, 0, 0 times the mean: variance 1.
    EXPECT_NEAR(voronoi_statistics(diagram).relative_area_variance, 1, 1e-14);
}

TEST(VoronoiDiagram, IsTheSameEveryTime)
{
    std::mt19937_64 random(4);
    for (const PointSet& points : {test::random_points(500, 2, random), square_lattice(13, 2)}) {
        const VoronoiDiagram first = voronoi_diagram(points), second = voronoi_diagram(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_EQ(first.cells[i].polygon, second.cells[i].polygon);
        }
    }
}

TEST(VoronoiDiagram, RejectsWhatHasNone)
{
    EXPECT_THROW(voronoi_diagram({2, {}}), InputError);
    EXPECT_THROW(voronoi_diagram({3, {0.1, 0.2, 0.3}}), InputError);
    EXPECT_EQ(voronoi_statistics({}).relative_area_variance, 0);
}

}
}
