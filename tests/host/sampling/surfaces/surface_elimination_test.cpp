// Sample elimination on surfaces: kernels against the heap, what is kept, and beginnings of the order.
#include "host/sampling/surfaces/surface_elimination.hpp"

#include "tests/support/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

struct SurfaceEliminationCase
{
    std::string name;
    TriangleMesh mesh;
    std::size_t candidates, kept;
    double angle = 120;
};

void PrintTo(const SurfaceEliminationCase& c, std::ostream* out) { *out << c.name; }

std::vector<SurfacePoint> eliminated(const SurfaceEliminationCase& c, std::size_t group_size, bool by_kernels)
{
    const auto surface = std::make_shared<const FixedSurface>(fixed_surface(c.mesh));
    const auto candidates = surface_candidates(*surface, c.candidates, stream_key(3, Purpose::surface_candidates, 0));
    SurfaceElimination kernels(Device::open(), surface, group_size);
    return eliminate_on_surface(
        *surface, candidates, c.kept, c.angle, [&](const auto& points, const SurfaceReach& reach, std::size_t count) {
            return by_kernels ? kernels.removal_order(points, reach, count)
                              : reference::surface_removal_order(*surface, points, reach, count);
        });
}

PointSet places_of(const SurfaceEliminationCase& c, const std::vector<SurfacePoint>& points)
{
    return points_of(fixed_surface(c.mesh), points);
}

/// The least distance of the first points over that of the densest packing of as many in a plane of that area.
double relative_radius_of(const PointSet& places, std::size_t first, double area)
{
    double least = INFINITY;
    for (std::size_t i = 0; i < first; ++i)
        for (std::size_t j = 0; j < i; ++j)
            least = std::min(least, std::hypot(places[i][0] - places[j][0], places[i][1] - places[j][1],
                                               places[i][2] - places[j][2]));
    return least / std::sqrt(2 / std::numbers::sqrt3 * area / static_cast<double>(first));
}

class SurfaceEliminations : public testing::TestWithParam<SurfaceEliminationCase>
{
};

TEST_P(SurfaceEliminations, AreTheSameByKernels)
{
    const PointSet expected = places_of(GetParam(), eliminated(GetParam(), 0, false));
    EXPECT_EQ(expected.size(), GetParam().kept);
    for (const std::size_t group_size : {0, 16})
        EXPECT_EQ(places_of(GetParam(), eliminated(GetParam(), group_size, true)), expected);
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, SurfaceEliminations,
                         testing::Values(SurfaceEliminationCase{"square", square_mesh(), 20, 5},
                                         SurfaceEliminationCase{"one point", sheet_mesh(0.1), 4, 1}));
INSTANTIATE_TEST_SUITE_P(Sizes, SurfaceEliminations,
                         testing::Values(SurfaceEliminationCase{"sphere", sphere_mesh(20), 2500, 500},
                                         SurfaceEliminationCase{"sheet", sheet_mesh(0.01), 1500, 300},
                                         SurfaceEliminationCase{"all", square_mesh(), 300, 300, 180},
                                         SurfaceEliminationCase{"twenty a point", square_mesh(), 2000, 100}));

TEST(SurfaceElimination, KeepsPointsThatAreFarApart)
{
    const SurfaceEliminationCase c{"sphere", sphere_mesh(30), 5000, 1000};
    const double area = fixed_surface(c.mesh).area;
    const PointSet places = places_of(c, eliminated(c, 0, true));
    // Yuksel 2015, figure 3: some 0.7 to 0.8 of five times as many candidates; random points have 0.03 or less.
    EXPECT_GT(relative_radius_of(places, 1000, area), 0.65);
    EXPECT_GT(relative_radius_of(places, 500, area), 0.5);
    EXPECT_GT(relative_radius_of(places, 125, area), 0.5);
}

}
}
