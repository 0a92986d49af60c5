// Eigenfunctions are compared with closed forms (cosines on the square, Lame's functions on the equilateral triangle,
// spherical harmonics) and with all eigenvectors of small meshes. The power of random points is 1.
#include "analysis/surfaces/mesh_eigenfunctions.hpp"

#include "analysis/surfaces/eigenvalue_band.hpp"
#include "analysis/surfaces/refined_mesh.hpp"
#include "analysis/surfaces/surface_rings.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

constexpr double pi = std::numbers::pi;

/// Returns an equilateral triangle of side 1 as rows of equilateral triangles.
TriangleMesh equilateral_mesh(std::uint32_t rows)
{
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= rows; ++i)
        for (std::uint32_t j = 0; j + i <= rows; ++j)
            mesh.vertices.push_back({(j + 0.5 * i) / rows, std::numbers::sqrt3 / 2 * i / rows, 0});
    std::uint32_t first = 0;
    for (std::uint32_t i = 0; i < rows; ++i) {
        const std::uint32_t next = first + rows + 1 - i;
        for (std::uint32_t j = 0; j + i < rows; ++j) {
            mesh.triangles.push_back({first + j, first + j + 1, next + j});
            if (j + i + 1 < rows) mesh.triangles.push_back({first + j + 1, next + j + 1, next + j});
        }
        first = next;
    }
    return mesh;
}

/// Returns an icosahedron with corners on the unit sphere, each of whose triangles is divided into four `steps` times.
TriangleMesh icosphere(int steps)
{
    const double g = std::numbers::phi;
    TriangleMesh mesh{.vertices = {{-1, g, 0},
                                   {1, g, 0},
                                   {-1, -g, 0},
                                   {1, -g, 0},
                                   {0, -1, g},
                                   {0, 1, g},
                                   {0, -1, -g},
                                   {0, 1, -g},
                                   {g, 0, -1},
                                   {g, 0, 1},
                                   {-g, 0, -1},
                                   {-g, 0, 1}},
                      .triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (int step = 0; step <= steps; ++step) {
        if (step > 0) {
            double shortest = INFINITY;
            for (const MeshTriangle& t : mesh.triangles) {
                const MeshPoint edge = difference(mesh.vertices[t[0]], mesh.vertices[t[1]]);
                shortest = std::min(shortest, std::sqrt(dot(edge, edge)));
            }
            mesh = with_edges_up_to(mesh, 0.8 * shortest);
        }
        for (MeshPoint& vertex : mesh.vertices) vertex = unit(vertex);
    }
    return mesh;
}

std::vector<double> eigenvalues_on(const TriangleMesh& mesh, double highest)
{
    return eigenfunction_powers(mesh, highest, {}).eigenvalues;
}

/// Returns the largest relative deviation from values in closed form, both ascending.
double largest_deviation(const std::vector<double>& found, std::vector<double> known)
{
    std::ranges::sort(known);
    double largest = 0;
    for (std::size_t i = 0; i < std::min(found.size(), known.size()); ++i)
        largest = std::max(largest, std::abs(found[i] / known[i] - 1));
    return largest;
}

/// Returns the eigenvalues of the square, pi^2 (m^2 + n^2).
std::vector<double> of_square(double highest)
{
    std::vector<double> known;
    for (int m = 0; m < 200; ++m)
        for (int n = 0; n < 200; ++n)
            if (const double value = pi * pi * (m * m + n * n); value > 0 && value < highest) known.push_back(value);
    return known;
}

TEST(Eigenfunctions, OfASquareAreCosines)
{
    const double highest = 300; // errors are less than half of the steps between eigenvalues, which stay in order
    const auto coarse = eigenvalues_on(square_mesh(40), highest), fine = eigenvalues_on(square_mesh(80), highest);
    const auto known = of_square(highest);
    ASSERT_GT(known.size(), 25U);
    EXPECT_EQ(fine.size(), known.size());
    const double of_coarse = largest_deviation(coarse, known), of_fine = largest_deviation(fine, known);
    // The five-point stencil of right triangles is wrong by (k h)^2 / 12 at most, less what the mass takes off.
    EXPECT_LT(of_fine, highest / (80 * 80) / 12);
    EXPECT_GT(of_coarse / of_fine, 3.5) << of_coarse << ' ' << of_fine;
}

TEST(Eigenfunctions, OfEquilateralTrianglesAreThoseOfLameToFourthOrder)
{
    const double highest = 1200;
    std::vector<double> known;
    for (int m = 0; m < 60; ++m)
        for (int n = 0; n < 60; ++n)
            if (const double value = 16 * pi * pi / 9 * (m * m + m * n + n * n); value > 0 && value < highest)
                known.push_back(value);
    ASSERT_GT(known.size(), 45U);
    const auto coarse = eigenvalues_on(equilateral_mesh(32), highest),
               fine = eigenvalues_on(equilateral_mesh(64), highest);
    EXPECT_EQ(fine.size(), known.size());
    const double of_coarse = largest_deviation(coarse, known), of_fine = largest_deviation(fine, known);
    EXPECT_GT(of_coarse / of_fine, 14) << of_coarse << ' ' << of_fine;
    EXPECT_LT(of_fine, 1e-3);
}

TEST(Eigenfunctions, OfTheSphereAreSphericalHarmonics)
{
    const double highest = 13.5 * 14.5 - 0.5; // between l = 13 and 14
    std::vector<double> known;
    for (int l = 1; l <= 13; ++l) known.insert(known.end(), static_cast<std::size_t>(2 * l + 1), l * (l + 1.0));
    const auto coarse = eigenvalues_on(icosphere(3), 1.03 * highest), fine = eigenvalues_on(icosphere(4), highest);
    ASSERT_EQ(fine.size(), known.size()); // each multiplicity, whatever the icosahedron's symmetries make equal
    const double of_coarse = largest_deviation(coarse, known), of_fine = largest_deviation(fine, known);
    EXPECT_LT(of_fine, 0.01);
    EXPECT_GT(of_coarse / of_fine, 3.5) << of_coarse << ' ' << of_fine;
}

TEST(Eigenfunctions, AreThoseOfAllEigenvectorsOfSmallMeshes)
{
    // Narrow triangles at the poles, two parts, one open surface: 400 to 800 vertices, three bands or more.
    for (const TriangleMesh& mesh : {sphere_mesh(20), with_edges_up_to(sheet_mesh(0.3), 0.1), square_mesh(24)}) {
        Eigen::MatrixXd stiffness =
            Eigen::MatrixXd::Zero(static_cast<int>(mesh.vertices.size()), static_cast<int>(mesh.vertices.size()));
        Eigen::MatrixXd mass = stiffness;
        double total = 0;
        for (const MeshTriangle& t : mesh.triangles) {
            const double area = area_of(mesh, t);
            total += area;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
                // the cotangent of the angle at k is the weight of the edge from i to j
                const MeshPoint u = difference(mesh.vertices[t[i]], mesh.vertices[t[k]]),
                                v = difference(mesh.vertices[t[j]], mesh.vertices[t[k]]);
                const double half = dot(u, v) / (2 * area) / 2;
                stiffness(t[i], t[j]) -= half, stiffness(t[j], t[i]) -= half;
                stiffness(t[i], t[i]) += half, stiffness(t[j], t[j]) += half;
                mass(t[i], t[i]) += area / 4;
                mass(t[i], t[j]) += area / 24, mass(t[j], t[i]) += area / 24;
            }
        }
        const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> all(stiffness, mass, Eigen::EigenvaluesOnly);
        const double highest = eigenvalue_of(frequency_of_eigenfunctions(150, total));
        std::vector<double> known;
        for (const double value : all.eigenvalues())
            if (value > 1e-6 && value < highest) known.push_back(value);
        const auto found = eigenvalues_on(mesh, highest);
        ASSERT_EQ(found.size(), known.size());
        EXPECT_LT(largest_deviation(found, known), 1e-9);
    }
}

std::vector<MeshPosition> random_positions(const TriangleMesh& mesh, std::size_t count, std::mt19937& engine)
{
    std::vector<double> areas;
    for (const MeshTriangle& t : mesh.triangles) areas.push_back(area_of(mesh, t));
    std::discrete_distribution<std::uint32_t> triangle(areas.begin(), areas.end());
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<MeshPosition> positions;
    while (positions.size() < count) {
        const double u = share(engine), v = share(engine);
        if (u + v <= 1) positions.push_back({triangle(engine), {1 - u - v, u, v}});
    }
    return positions;
}

TEST(EigenfunctionPowers, OfRandomPointsAreOneInEachRing)
{
    std::mt19937 engine(3);
    for (const TriangleMesh& mesh : {with_edges_up_to(sphere_mesh(14), 0.15), square_mesh(40)}) {
        std::vector<std::vector<MeshPosition>> sets;
        for (int seed = 0; seed < 20; ++seed) sets.push_back(random_positions(mesh, 300, engine));
        const double area = shape_of(mesh).area, highest = eigenvalue_of(frequency_of_eigenfunctions(500, area));
        const EigenfunctionPowers found = eigenfunction_powers(mesh, highest, sets);
        std::vector<std::vector<double>> powers;
        for (const auto& of_set : found.powers) {
            std::vector<double> of_rings;
            for (const RadialBin& ring : eigenfunction_rings(found.eigenvalues, of_set, area, highest))
                of_rings.push_back(ring.power);
            powers.push_back(of_rings);
        }
        ASSERT_GE(powers.front().size(), 11U);
        for (std::size_t ring = 0; ring < powers.front().size(); ++ring) {
            std::vector<double> of_seeds;
            for (const auto& of_set : powers) of_seeds.push_back(of_set[ring]);
            const test::Mean mean = test::mean_of(of_seeds);
            // of twenty values, whose Student's distribution has longer tails than the normal one
            EXPECT_LT(std::abs(mean.value - 1), 1.4 * test::z_bound(2 * powers.front().size()) * mean.standard_error)
                << ring;
        }
    }
}

TEST(EigenfunctionPowers, OfPointsOnAGridOfASquareAreThoseOfTheirCosines)
{
    // Points are the middles of 8 x 8 squares: only cosines of 16 j half waves have power.
    const TriangleMesh mesh = square_mesh(64);
    const TriangleTree tree(mesh);
    std::vector<MeshPosition> grid;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j) grid.push_back(tree.nearest({(i + 0.5) / 8, (j + 0.5) / 8, 0}));
    const EigenfunctionPowers found = eigenfunction_powers(mesh, pi * pi * 300, {grid});
    double most = 0, all = 0;
    for (std::size_t k = 0; k < found.eigenvalues.size(); ++k) {
        const double m = found.eigenvalues[k] / (pi * pi);
        all += found.powers[0][k];
        if (std::abs(m - 256) < 8) most += found.powers[0][k];
    }
    // The normalised sqrt(2) cos(16 pi x) has the same absolute value at each point, so that its power is 2 N, and
    // there are two such functions. Linear functions are lower between vertices, by (k h)^2 / 6 of the integral of
    // their squares, and therefore higher at vertices.
    const double kh = 16 * pi / 64;
    EXPECT_NEAR(most, 4 * 64 * (1 + kh * kh / 6), 0.02 * 256);
    EXPECT_LT(all - most, 0.02 * 256);
}

TEST(EigenfunctionPowers, OfTooFewVerticesAreRefusedOrFew)
{
    // There are as many eigenfunctions as vertices, without the constant one.
    EXPECT_EQ(eigenvalues_on(square_mesh(), 1e9).size(), 3U);
    EXPECT_EQ(eigenvalues_on({.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}}, 1e9).size(),
              2U);
}

}
}
