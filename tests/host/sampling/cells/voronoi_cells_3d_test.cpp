// The cells of points on the 3-torus by kernels: against CGAL's, against closed forms, and the same bits
// whatever the device is told.
#include "host/sampling/cells/voronoi_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>

namespace poissonlab {
namespace {

using Draw = std::function<double()>;

Draw uniform(std::uint64_t seed)
{
    return [engine = std::mt19937_64(seed)]() mutable { return static_cast<double>(engine() >> 11) * 0x1p-53; };
}

void add(PointSet& set, double x, double y, double z)
{
    for (double c : {x, y, z}) {
        c -= std::floor(c);
        set.coordinates.push_back(c < 1 ? c : 0);
    }
}

PointSet random_points(std::size_t n, std::uint64_t seed)
{
    PointSet set{3, {}};
    const Draw u = uniform(seed);
    for (std::size_t i = 0; i < 3 * n; ++i) set.coordinates.push_back(u());
    return set;
}

/// Balls of points with centres anywhere, also across the borders of the unit cube.
PointSet clusters(std::size_t balls, std::size_t n, double radius, std::uint64_t seed)
{
    PointSet set{3, {}};
    const Draw u = uniform(seed);
    for (std::size_t ball = 0; ball < balls; ++ball) {
        const double x = u(), y = u(), z = u();
        for (std::size_t i = 0; i < n;) {
            const double dx = 2 * u() - 1, dy = 2 * u() - 1, dz = 2 * u() - 1;
            if (dx * dx + dy * dy + dz * dz > 1) continue;
            add(set, x + radius * dx, y + radius * dy, z + radius * dz);
            ++i;
        }
    }
    return set;
}

/// A lattice of side^3 cubes with a point in each corner, and in each centre (`bcc`), moved by up to `jitter`
/// times the cubes' width.
PointSet lattice(int side, bool bcc, double jitter, std::uint64_t seed)
{
    PointSet set{3, {}};
    const Draw u = uniform(seed);
    for (int i = 0; i < side * side * side; ++i) {
        for (int k = 0; k < (bcc ? 2 : 1); ++k) {
            const auto at = [&](int c) { return (c + 0.5 * k + jitter * (u() - 0.5)) / side; };
            add(set, at(i % side), at(i / side % side), at(i / side / side));
        }
    }
    return set;
}

/// Each point `copies` times, not next to each other.
PointSet repeated_3d(const PointSet& points, std::size_t copies)
{
    PointSet set{3, {}};
    for (std::size_t k = 0; k < copies; ++k) {
        set.coordinates.insert(set.coordinates.end(), points.coordinates.begin(), points.coordinates.end());
    }
    return set;
}

PointSet on_a_line(std::size_t n, bool is_skew)
{
    PointSet set{3, {}};
    const Draw u = uniform(5);
    for (std::size_t i = 0; i < n; ++i) {
        const double t = u();
        add(set, t, is_skew ? t : 0.3, is_skew ? 0.1 + t : 0.6);
    }
    return set;
}

PointSet on_a_plane(std::size_t n)
{
    PointSet set{3, {}};
    const Draw u = uniform(6);
    for (std::size_t i = 0; i < n; ++i) add(set, u(), u(), 0.25);
    return set;
}

/// A site in the centre of a sphere of others: more faces than one cell has room for on the way.
PointSet sphere_around_a_point(std::size_t n)
{
    PointSet set{3, {}};
    add(set, 0.5, 0.5, 0.5);
    const Draw u = uniform(7);
    while (set.size() < n + 1) {
        const double x = 2 * u() - 1, y = 2 * u() - 1, z = 2 * u() - 1;
        const double r = std::sqrt(x * x + y * y + z * z);
        if (r > 1 || r < 0.1) continue;
        add(set, 0.5 + 0.125 * x / r, 0.5 + 0.125 * y / r, 0.5 + 0.125 * z / r);
    }
    return set;
}

double total_3d(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Neighbours compute their common corners from different sums, so what one cell has too much is missing in
/// the other but for roundings: some units of 2^-53 for cells that reach through the torus, and of 2^-53 / n
/// for those of even sets.
double sum_tolerance(std::size_t n) { return 0x1p-47 + static_cast<double>(n) * 0x1p-53; }

struct Case3D
{
    const char* what;
    PointSet points;
    /// Sets with empty regions: the angle, in order of magnitude, that is between bisectors of which the
    /// reference makes vertices. 0: an even set.
    double angle = 0;
};

void PrintTo(const Case3D& c, std::ostream* out) { *out << c.what << ", " << c.points.size() << " points"; }

class VoronoiCells3d : public ::testing::TestWithParam<Case3D>
{
protected:
    /// The diameter of cells.
    double diameter() const
    {
        return GetParam().angle > 0 ? 1 : 3 / std::cbrt(static_cast<double>(GetParam().points.size()));
    }

    /// A vertex is off by some roundings of coordinates, 2^-53 of the diameter, divided by the angle of the
    /// bisectors that make it. Times 8 for their number.
    double volume_tolerance() const
    {
        return 0x1p-50 * std::pow(diameter(), 3) / (GetParam().angle > 0 ? GetParam().angle : 1);
    }
};

TEST_P(VoronoiCells3d, AreThoseOfTheReference)
{
    const PointSet& points = GetParam().points;
    const std::size_t n = points.size();
    const VoronoiCells expected = reference::voronoi_cells(points);
    const VoronoiCells cells = voronoi_cells(Device::open(), points);

    double volume_error = 0, moment_error = 0, energy_error = 0, near_error = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double volume = cells.volumes[i];
        // An empty cell is so exactly.
        EXPECT_EQ(volume == 0, expected.volumes[i] == 0) << i;
        volume_error = std::max(volume_error, std::abs(volume - expected.volumes[i]));
        energy_error = std::max(energy_error, std::abs(cells.energies[i] - expected.energies[i]));
        near_error = std::max(near_error, std::abs(cells.squared_near[i] - expected.squared_near[i]));
        for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
            moment_error = std::max(moment_error, std::abs(volume * cells.displacements[k] -
                                                           expected.volumes[i] * expected.displacements[k]));
        }
    }
    EXPECT_LE(volume_error, volume_tolerance());
    EXPECT_LE(moment_error, volume_tolerance() * diameter());
    EXPECT_LE(energy_error, volume_tolerance() * diameter() * diameter());
    EXPECT_LE(near_error, 0x1p-50 * diameter());
    EXPECT_NEAR(total_3d(cells.volumes), 1, sum_tolerance(n));
}

INSTANTIATE_TEST_SUITE_P(
    Sets, VoronoiCells3d,
    ::testing::Values(
        Case3D{"random", random_points(1, 1)}, Case3D{"random", random_points(2, 2)},
        Case3D{"random", random_points(3, 3)}, Case3D{"random", random_points(10, 4)},
        Case3D{"random", random_points(500, 5)}, Case3D{"random", random_points(4096, 6)},
        Case3D{"one cluster", clusters(1, 500, 1e-3, 7), 1e-3}, Case3D{"clusters", clusters(8, 100, 0.02, 8), 0.02},
        Case3D{"tiny cluster", clusters(1, 40, 1e-9, 9), 1e-9},
        Case3D{"jittered lattice", lattice(12, false, 1e-3, 10)},
        Case3D{"hardly jittered lattice", lattice(8, false, 1e-9, 11)},
        Case3D{"jittered bcc", lattice(8, true, 0.2, 12)}, Case3D{"cubic lattice", lattice(8, false, 0, 0)},
        Case3D{"bcc lattice", lattice(7, true, 0, 0)}, Case3D{"pairs", repeated_3d(random_points(300, 13), 2)},
        Case3D{"triples", repeated_3d(random_points(300, 14), 3)},
        Case3D{"all the same", repeated_3d(random_points(1, 15), 50)}, Case3D{"collinear", on_a_line(24, false), 1e-3},
        Case3D{"skew collinear", on_a_line(24, true), 1e-3}, Case3D{"coplanar", on_a_plane(150), 1e-2},
        Case3D{"sphere around a point", sphere_around_a_point(150), 1e-2}));

/// Few points of every kind, for interpreters of kernels.
INSTANTIATE_TEST_SUITE_P(Small, VoronoiCells3d,
                         ::testing::Values(Case3D{"jittered lattice", lattice(6, false, 0.3, 16)},
                                           Case3D{"random", random_points(100, 17)},
                                           Case3D{"cubic lattice", lattice(3, false, 0, 0)},
                                           Case3D{"cluster", clusters(1, 20, 1e-3, 18), 1e-3},
                                           Case3D{"pairs", repeated_3d(random_points(6, 19), 2)}));

TEST(VoronoiCells3dClosedForms, CubicLattice)
{
    for (const int side : {1, 2, 3, 8, 16}) {
        const PointSet points = lattice(side, false, 0, 0);
        const auto n = static_cast<double>(points.size());
        const VoronoiCells cells = voronoi_cells(Device::open(), points);
        double error = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            error = std::max(error, std::abs(cells.volumes[i] * n - 1));
            error = std::max(error, std::abs(cells.energies[i] * std::pow(n, 5.0 / 3) * 4 - 1));
            error = std::max(error, std::abs(cells.squared_near[i] * std::pow(n, 2.0 / 3) - 1));
            for (int k = 0; k < 3; ++k) error = std::max(error, std::abs(cells.displacements[3 * i + k]) * side);
        }
        EXPECT_LT(error, 0x1p-44 * side) << side;
    }
}

TEST(VoronoiCells3dClosedForms, BodyCenteredCubicLattice)
{
    for (const int side : {1, 2, 5, 12}) {
        const PointSet points = lattice(side, true, 0, 0);
        const auto n = static_cast<double>(points.size());
        const VoronoiCells cells = voronoi_cells(Device::open(), points);
        // Conway, Sloane: Sphere packings, lattices and groups, chapter 21.
        const double normalised = 3 * 19 / (192 * std::cbrt(2.0));
        EXPECT_NEAR(total_3d(cells.energies) * std::pow(n, 2.0 / 3), normalised, 0x1p-44 * side) << side;
        EXPECT_NEAR(total_3d(cells.volumes), 1, sum_tolerance(points.size())) << side;
    }
}

TEST(VoronoiCells3dOnDevices, WorkGroupsAndThreadsChangeNothing)
{
    for (const PointSet& points : {random_points(2000, 21), lattice(7, false, 1e-6, 22)}) {
        const VoronoiCells expected = voronoi_cells(Device::open(), points);
        for (const unsigned threads : {1u, 2u}) {
            for (const std::size_t group : {1u, 16u, 64u}) {
                const VoronoiCells cells = voronoi_cells(Device::open({}, threads), points, group);
                EXPECT_EQ(cells.volumes, expected.volumes) << threads << " threads, groups of " << group;
                EXPECT_EQ(cells.displacements, expected.displacements);
                EXPECT_EQ(cells.energies, expected.energies);
                EXPECT_EQ(cells.squared_near, expected.squared_near);
            }
        }
    }
}

}
}
