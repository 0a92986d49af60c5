// Gaussian blue noise on surfaces: energies fall, points are as far apart as on the torus of the plane, and as dense
// beside open edges, along sharp edges and on small triangles as elsewhere.
#include "host/distribution/surfaces/relaxed_surface.hpp"

#include "host/distribution/surfaces/surface_neighbours.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"
#include "host/sampling/surfaces/surface_elimination.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

namespace poissonlab {
namespace {

std::vector<SurfacePoint> uniform_on(const FixedSurface& surface, std::size_t count, std::uint64_t seed = 1)
{
    return surface_candidates(surface, count, stream_key(seed, Purpose::surface_candidates, 7));
}

RelaxedSurface pushed(const FixedSurface& surface, std::vector<SurfacePoint> points, std::uint32_t iterations,
                      double angle = 120)
{
    MeshPointSettings settings;
    settings.method = SurfaceMethod::gaussian;
    settings.iterations = iterations;
    settings.normal_angle = angle;
    return descend_on_surface(surface, std::move(points), settings, {});
}

/// The cube of side 1 with outward faces of n x n squares.
TriangleMesh cube_mesh(std::uint32_t n)
{
    TriangleMesh cube;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const double height : {0.0, 1.0}) {
            const TriangleMesh face = square_mesh(n);
            const auto first = static_cast<std::uint32_t>(cube.vertices.size());
            for (const MeshPoint& v : face.vertices) {
                MeshPoint& place = cube.vertices.emplace_back();
                place[axis] = height;
                place[(axis + 1) % 3] = v[0];
                place[(axis + 2) % 3] = v[1];
            }
            for (const auto& [a, b, c] : face.triangles)
                cube.triangles.push_back(height > 0 ? MeshTriangle{first + a, first + b, first + c}
                                                    : MeshTriangle{first + a, first + c, first + b});
        }
    return cube;
}

TEST(GaussiansOnSurfaces, HaveEnergiesThatFall)
{
    const FixedSurface sphere = fixed_surface(sphere_mesh(20));
    const RelaxedSurface found = pushed(sphere, uniform_on(sphere, 400), 60);
    ASSERT_EQ(found.energies.size(), 61U);
    for (std::size_t i = 1; i < found.energies.size(); ++i)
        EXPECT_LE(found.energies[i], found.energies[i - 1] + 1e-4) << "step " << i;
    EXPECT_LT(found.energies.back(), 0.01); // of even sets: exponentially small
}

/// The mean of several sets, and its standard error.
struct MeanOfSets
{
    double sum = 0, squares = 0;
    int sets = 0;

    void add(double value)
    {
        sum += value;
        squares += value * value;
        ++sets;
    }
    double mean() const { return sum / sets; }
    double error() const { return std::sqrt((squares / sets - mean() * mean()) / (sets - 1)); }
};

double mean_nearest_on_torus(const PointSet& flat)
{
    double mean = 0;
    for (std::size_t i = 0; i < flat.size(); ++i) {
        double least = INFINITY;
        for (std::size_t j = 0; j < flat.size(); ++j) {
            double dx = std::abs(flat[i][0] - flat[j][0]), dy = std::abs(flat[i][1] - flat[j][1]);
            dx = std::min(dx, 1 - dx), dy = std::min(dy, 1 - dy);
            if (i != j) least = std::min(least, std::hypot(dx, dy));
        }
        mean += least / static_cast<double>(flat.size());
    }
    return mean;
}

TEST(GaussiansOnSurfaces, SpaceThePointsAsInThePlane)
{
    constexpr std::size_t count = 400, sets = 6;
    GaussianRequest request{.iterations = 60};
    request.step = usual_gaussian_step(1, 2);
    const FixedSurface sphere = fixed_surface(sphere_mesh(40));
    MeanOfSets of_torus, of_sphere;
    for (std::uint64_t seed = 1; seed <= sets; ++seed) {
        std::mt19937_64 random(seed);
        of_torus.add(
            mean_nearest_on_torus(reference::descend(test::random_points_32(count, 2, random), request).points));
        const auto points = pushed(sphere, uniform_on(sphere, count, seed), 60).points;
        of_sphere.add(surface_distances(sphere, points, least_cosine(120), sphere.area).mean_nearest /
                      std::sqrt(sphere.area));
    }
    // Curvature shortens chords by (d / R)^2 / 24, less than 0.002 here.
    const double relative = std::hypot(of_torus.error() / of_torus.mean(), of_sphere.error() / of_sphere.mean());
    EXPECT_LT(relative, 0.01);
    EXPECT_NEAR(of_sphere.mean() / of_torus.mean(), 1, 4 * relative + 0.002);
}

/// Strips along borders and edges have their share of the points.
TEST(GaussiansOnSurfaces, AreAsDenseBesideEdgesAsElsewhere)
{
    constexpr std::size_t count = 600, sets = 4;
    const FixedSurface square = fixed_surface(square_mesh(3)), cube = fixed_surface(cube_mesh(2));
    double of_square = 0, of_cube = 0;
    for (std::uint64_t seed = 1; seed <= sets; ++seed) {
        const PointSet flat = points_of(square, pushed(square, uniform_on(square, count, seed), 60).points);
        const PointSet solid = points_of(cube, pushed(cube, uniform_on(cube, count, seed), 60).points);
        const double on_square = 1.5 / std::sqrt(count), on_cube = 1.5 * std::sqrt(6.0 / count);
        const auto rim = [](double c, double width) { return c < width || c > 1 - width; };
        std::size_t near_rim = 0, near_edge = 0;
        for (std::size_t i = 0; i < count; ++i) {
            near_rim += rim(flat[i][0], on_square) || rim(flat[i][1], on_square);
            int walls = 0; // a point of a face lies on one of them, beside an edge near another one
            for (std::size_t k = 0; k < 3; ++k) walls += rim(solid[i][k], on_cube);
            near_edge += walls >= 2;
        }
        const auto share = [](double width) { return 1 - (1 - 2 * width) * (1 - 2 * width); };
        of_square += static_cast<double>(near_rim) / count / share(on_square) / sets;
        of_cube += static_cast<double>(near_edge) / count / share(on_cube) / sets;
    }
    EXPECT_NEAR(of_square, 1, 0.06);
    EXPECT_NEAR(of_cube, 1, 0.06);
}

/// A strip of long triangles has as even points as one of short ones, and few charges.
TEST(GaussiansOnSurfaces, DivideLongTriangles)
{
    TriangleMesh strip;
    constexpr std::uint32_t columns = 100;
    for (std::uint32_t i = 0; i <= columns; ++i)
        for (const double y : {0.0, 1.0}) strip.vertices.push_back({i * 0.01, y, 0});
    for (std::uint32_t i = 0; i < 2 * columns; i += 2) {
        strip.triangles.push_back({i, i + 2, i + 1});
        strip.triangles.push_back({i + 1, i + 2, i + 3});
    }
    const FixedSurface narrow = fixed_surface(strip);
    constexpr std::size_t count = 400;
    EXPECT_LT(gaussian_charges(narrow, count), 40 * count);
    const RelaxedSurface found = pushed(narrow, uniform_on(narrow, count), 60);
    const FixedSurface wide = fixed_surface(square_mesh(3));
    EXPECT_NEAR(found.energies.back(), pushed(wide, uniform_on(wide, count), 60).energies.back(), 0.03);
}

TEST(GaussiansOnSurfaces, DoNotDependOnTheNumberOfThreads)
{
    const FixedSurface sphere = fixed_surface(sphere_mesh(8));
    std::vector<RelaxedSurface> found;
    for (const std::size_t threads : {1, 2, 4}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        found.push_back(pushed(sphere, uniform_on(sphere, 300), 5));
    }
    for (const RelaxedSurface& other : found) {
        EXPECT_EQ(other.energies, found[0].energies);
        EXPECT_EQ(std::memcmp(other.points.data(), found[0].points.data(), 300 * sizeof(SurfacePoint)), 0);
    }
}

TEST(GaussiansOnSurfaces, OfFewPointsStay)
{
    const FixedSurface square = fixed_surface(square_mesh(1));
    for (const std::size_t count : {1, 2, 3}) {
        const RelaxedSurface found = pushed(square, uniform_on(square, count), 3);
        EXPECT_EQ(found.points.size(), count);
        for (const double energy : found.energies) EXPECT_TRUE(std::isfinite(energy));
    }
}

}
}
