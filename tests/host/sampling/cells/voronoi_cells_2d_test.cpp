// The cells of points on the 2-torus by kernels: against CGAL's, against closed forms, and the same bits
// whatever the device is told.
#include "host/sampling/cells/voronoi_cells.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

struct Case2D
{
    const char* name;
    PointSet points;
    /// The factor by which vertices magnify rounding: one over the smallest angle, in order of magnitude, between
    /// bisectors that make a vertex. 1 for even sets, about n for n random points (the smallest of n angles),
    /// more where clusters leave cells that reach through the torus.
    double magnification = 1;
};

void PrintTo(const Case2D& c, std::ostream* out) { *out << c.name << ", " << c.points.size() << " points"; }

PointSet random_set(std::size_t n)
{
    std::mt19937_64 random(n);
    return test::random_points(n, 2, random);
}

PointSet clusters(std::size_t n, std::size_t count, double width)
{
    std::mt19937_64 random(n + count);
    return test::clustered_points(n, 2, count, width, random);
}

/// Crowded grid cells between others: kernels go the slow way there, and back.
PointSet crowds_among_random_points(std::size_t n, std::size_t crowds)
{
    PointSet set = random_set(n);
    const PointSet crowded = clusters(150 * crowds, crowds, 5e-3);
    set.coordinates.insert(set.coordinates.end(), crowded.coordinates.begin(), crowded.coordinates.end());
    return set;
}

/// A lattice of side^2 points, every second row shifted by half a spacing, and points moved by up to half of
/// `jitter` spacings.
PointSet brick_lattice(int side, double jitter)
{
    std::mt19937_64 random(7);
    PointSet set{2, {}};
    for (int i = 0; i < side * side; ++i) {
        const double x = i % side + 0.5 * (i / side % 2) + jitter * (test::uniform(random) - 0.5);
        const double y = i / side + jitter * (test::uniform(random) - 0.5);
        set.coordinates.push_back(x / side - std::floor(x / side));
        set.coordinates.push_back(y / side - std::floor(y / side));
    }
    return set;
}

PointSet on_a_line(std::size_t n, double slope)
{
    std::mt19937_64 random(5);
    PointSet set{2, {}};
    for (std::size_t i = 0; i < n; ++i) {
        const double x = test::uniform_32(random);
        const double y = 0.25 + slope * x;
        set.coordinates.insert(set.coordinates.end(), {x, y - std::floor(y)});
    }
    return set;
}

/// A point in the middle of a circle of others: n edges.
PointSet circle_around_a_point(std::size_t n)
{
    PointSet set{2, {0.5, 0.5}};
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        set.coordinates.insert(set.coordinates.end(), {0.5 + 0.125 * std::cos(angle), 0.5 + 0.125 * std::sin(angle)});
    }
    return set;
}

/// Each point `copies` times, not next to each other.
PointSet repeated_2d(const PointSet& points, std::size_t copies)
{
    PointSet set{2, {}};
    for (std::size_t k = 0; k < copies; ++k) {
        set.coordinates.insert(set.coordinates.end(), points.coordinates.begin(), points.coordinates.end());
    }
    return set;
}

double total_2d(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

class VoronoiCells2d : public ::testing::TestWithParam<Case2D>
{
};

TEST_P(VoronoiCells2d, AgreeWithCgal)
{
    const PointSet& points = GetParam().points;
    const VoronoiCells cells = voronoi_cells(Device::open(), points);
    const VoronoiCells expected = reference::voronoi_cells(points);

    // Differences of positions and vertices are rounded to 2^-53 of a cell's diameter, which is at most 1; a
    // vertex moves by that, magnified, and with it an edge. Times 16 for the number of roundings and edges.
    const double n = static_cast<double>(points.size());
    const double diameter = GetParam().magnification > n ? 1 : std::min(1.0, 4 / std::sqrt(n));
    const double length_error = 16 * 0x1p-53 * GetParam().magnification * std::max(diameter, 1 / n);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(cells.volumes[i], expected.volumes[i], length_error * diameter) << "of point " << i;
        EXPECT_NEAR(cells.energies[i], expected.energies[i], length_error * std::pow(diameter, 3)) << "of point " << i;
        EXPECT_NEAR(cells.squared_near[i], expected.squared_near[i], 16 * 0x1p-53 * diameter) << "of point " << i;
        for (std::size_t k = 0; k < 2; ++k) {
            // A displacement is a moment over an area; the moments have errors as the areas have, times the
            // diameter.
            EXPECT_NEAR(cells.volumes[i] * cells.displacements[2 * i + k],
                        expected.volumes[i] * expected.displacements[2 * i + k], length_error * diameter * diameter)
                << "of point " << i;
        }
    }
}

TEST_P(VoronoiCells2d, FillTheTorus)
{
    const VoronoiCells cells = voronoi_cells(Device::open(), GetParam().points);
    // Neighbours compute their common edge from the same points; what one has too much, the other has too
    // little, but for roundings of each.
    const double n = static_cast<double>(GetParam().points.size());
    EXPECT_NEAR(total_2d(cells.volumes), 1, 0x1p-47 + n * 0x1p-53);
}

TEST_P(VoronoiCells2d, AreTheSameBitsForAllWorkGroupsAndThreads)
{
    const PointSet& points = GetParam().points;
    const VoronoiCells expected = voronoi_cells(Device::open(), points);
    for (const std::size_t group_size : {1, 16, 100}) {
        for (const unsigned threads : {1u, 2u}) {
            const VoronoiCells cells = voronoi_cells(Device::open({}, threads), points, group_size);
            EXPECT_EQ(cells.volumes, expected.volumes);
            EXPECT_EQ(cells.displacements, expected.displacements);
            EXPECT_EQ(cells.energies, expected.energies);
            EXPECT_EQ(cells.squared_near, expected.squared_near);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Sets, VoronoiCells2d,
    ::testing::Values(
        Case2D{"one", random_set(1)}, Case2D{"two", random_set(2), 8}, Case2D{"three", random_set(3), 8},
        Case2D{"four", random_set(4), 8}, Case2D{"ten", random_set(10), 10}, Case2D{"random", random_set(37), 37},
        Case2D{"random", random_set(100), 100}, Case2D{"random", random_set(1000), 1000},
        Case2D{"random", random_set(16384), 16384}, Case2D{"even", brick_lattice(64, 0.3)},
        Case2D{"nearly a lattice", brick_lattice(32, 1e-9)}, Case2D{"brick lattice", brick_lattice(32, 0)},
        Case2D{"square lattice", test::square_lattice(32, 2)},
        Case2D{"square lattice of odd size", test::square_lattice(21, 2)},
        Case2D{"small square lattice", test::square_lattice(2, 2)}, Case2D{"a cluster", clusters(1000, 1, 1e-3), 1e6},
        Case2D{"a tiny cluster", clusters(500, 1, 1e-6), 1e9}, Case2D{"clusters", clusters(2000, 5, 1e-2), 1e6},
        Case2D{"crowds", crowds_among_random_points(3000, 20), 1e6},
        Case2D{"pairs", repeated_2d(random_set(100), 2), 200}, Case2D{"triples", repeated_2d(random_set(100), 3), 300},
        Case2D{"coinciding lattice", repeated_2d(test::square_lattice(8, 2), 4)},
        Case2D{"all in one place", repeated_2d(random_set(1), 50)}, Case2D{"collinear", on_a_line(200, 0), 1e4},
        Case2D{"collinear, skew", on_a_line(200, 1), 1e4}, Case2D{"many edges", circle_around_a_point(300), 1e4}));

/// Few points of every kind, for interpreters of kernels.
INSTANTIATE_TEST_SUITE_P(Small, VoronoiCells2d,
                         ::testing::Values(Case2D{"even", brick_lattice(8, 0.3)}, Case2D{"random", random_set(60), 60},
                                           Case2D{"square lattice", test::square_lattice(6, 2)},
                                           Case2D{"a cluster", clusters(30, 1, 1e-3), 1e6},
                                           Case2D{"pairs", repeated_2d(random_set(12), 2), 200}));

TEST(VoronoiCells2dClosedForms, SquareLattice)
{
    const int side = 16;
    const VoronoiCells cells = voronoi_cells(Device::open(), test::square_lattice(side, 2));
    for (std::size_t i = 0; i < cells.volumes.size(); ++i) {
        EXPECT_DOUBLE_EQ(cells.volumes[i], 1.0 / (side * side));
        EXPECT_NEAR(cells.energies[i], 1.0 / 6 / std::pow(side, 4), 1e-15 / std::pow(side, 2));
        EXPECT_DOUBLE_EQ(cells.squared_near[i], 1.0 / (side * side));
        EXPECT_NEAR(std::hypot(cells.displacements[2 * i], cells.displacements[2 * i + 1]), 0, 1e-16);
    }
}

TEST(VoronoiCells2dClosedForms, OnePointOwnsTheTorus)
{
    const VoronoiCells cells = voronoi_cells(Device::open(), PointSet{2, {0.3, 0.9}});
    EXPECT_DOUBLE_EQ(cells.volumes[0], 1);
    EXPECT_DOUBLE_EQ(cells.energies[0], 1.0 / 6);
    EXPECT_DOUBLE_EQ(cells.squared_near[0], 1);
}

TEST(VoronoiCells2dClosedForms, CoincidingPointsSplitTheirCellFromLeftToRight)
{
    const VoronoiCells cells = voronoi_cells(Device::open(), PointSet{2, {0.5, 0.5, 0.5, 0.5, 0.5, 0.5}});
    EXPECT_EQ(cells.volumes, (std::vector<double>{0.5, 0, 0.5}));
    const std::vector<double> displacements = {-0.25, 0, 0, 0, 0.25, 0};
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(cells.displacements[i], displacements[i], 0x1p-53);
}

/// The slow way is for rare sites, or the kernels are slow without anybody noticing.
TEST(VoronoiCells2dSpeed, FewPointsNeedTheSlowWay)
{
    const PointSet points = random_set(16384);
    Device device = Device::open();
    PointGrid grid(device, 2, points.size(), VoronoiKernels::cells_per_axis(2, points.size()), 64);
    VoronoiKernels kernels(device, 2, points.size(), 64);
    grid.load(points);
    grid.sort();
    kernels.find_cells(grid);
    EXPECT_LT(kernels.slow_points(), points.size() / 20);
    EXPECT_GT(kernels.slow_points(), 0u); // the slow way is tested on ordinary sets, too
}

}
}
