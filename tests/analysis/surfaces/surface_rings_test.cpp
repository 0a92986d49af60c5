// Tests rings of eigenfunctions, and counts over parts of a surface.
#include "analysis/surfaces/surface_rings.hpp"

#include "analysis/measures/peak_anisotropy.hpp"
#include "analysis/surfaces/mesh_eigenfunctions.hpp"
#include "tests/support/meshes.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace poissonlab {
namespace {

TEST(EigenfunctionRings, HoldEigenfunctionsByTheirFrequencies)
{
    const double area = 4; // f sqrt A = 2 f
    std::vector<double> eigenvalues;
    for (const double f : {0.1, 0.7, 0.74, 0.76, 1.2, 1.3}) eigenvalues.push_back(eigenvalue_of(f));
    const auto rings = eigenfunction_rings(eigenvalues, {1, 2, 3, 5, 7, 100}, area, eigenvalue_of(1.26));
    ASSERT_EQ(rings.size(), 2U); // up to 1.5 and 2.5; that up to 3.5 reaches beyond the end
    EXPECT_EQ(rings[0].samples, 3U);
    EXPECT_EQ(rings[0].frequency, 1);
    EXPECT_DOUBLE_EQ(rings[0].power, 2);
    EXPECT_EQ(rings[1].samples, 2U);
    EXPECT_DOUBLE_EQ(rings[1].power, 6);
}

TEST(EigenfunctionRings, OfRandomPowersHaveTheAnisotropyOfChance)
{
    // Powers are squares of normal deviates, of 10,000 rings with 200 eigenfunctions each. Their anisotropy is about 0
    // dB, with the error of the plane's rings, and fewer than one ring in a thousand stands out.
    std::mt19937 engine(5);
    std::normal_distribution<double> normal;
    std::vector<double> eigenvalues;
    for (int k = 0; k < 2000; ++k) eigenvalues.push_back(4 * std::numbers::pi * (k + 0.5));
    int above = 0;
    double sum = 0, squares = 0, rings = 0;
    for (int set = 0; set < 1000; ++set) {
        std::vector<double> powers;
        for (std::size_t k = 0; k < eigenvalues.size(); ++k) powers.push_back(std::pow(normal(engine), 2));
        const auto curve = eigenfunction_rings(eigenvalues, powers, 1, eigenvalues.back());
        above += anisotropy_above_chance_db(curve, 1).value() > 0 ? 1 : 0;
        for (const RadialBin& ring : curve)
            if (ring.samples >= least_peak_samples) {
                const double z = ring.anisotropy_db / anisotropy_standard_error_db(ring.samples, 1);
                sum += z, squares += z * z, ++rings;
            }
    }
    EXPECT_LE(above, 6); // one expected; as many by chance in one of 10,000 runs
    EXPECT_NEAR(sum / rings, 0, 0.25) << "of an error: decibels of ratios lie below their mean";
    EXPECT_NEAR(squares / rings, 1, 0.3);
}

TEST(CountsOverParts, HaveTheChiSquareOfTheirAreas)
{
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> share(0, 1);
    const TriangleMesh mesh = square_mesh(64);
    const TriangleTree tree(mesh);
    double sum = 0, squares = 0;
    const int sets = 200;
    std::size_t parts = 0;
    for (int set = 0; set < sets; ++set) {
        std::vector<MeshPosition> points;
        for (int i = 0; i < 400; ++i) points.push_back(tree.nearest({share(engine), share(engine), 0}));
        const CountsOverParts counts = counts_over_parts(mesh, points);
        parts = counts.parts;
        sum += counts.p_value;
        squares += counts.p_value * counts.p_value;
    }
    EXPECT_EQ(parts, 32U);
    // uniform from 0 to 1: the mean is 1/2, with the deviation root of 1/12 over 200 sets; within four errors
    EXPECT_NEAR(sum / sets, 0.5, 4 / std::sqrt(12.0 * sets));
    EXPECT_NEAR(squares / sets, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / sets));
    std::vector<MeshPosition> half;
    for (int i = 0; i < 400; ++i) half.push_back(tree.nearest({share(engine) / 2, share(engine), 0}));
    // All points in one half of the parts: sum of (2E - E)^2 / E and E^2 / E over 32 parts of 12.5.
    const CountsOverParts counts = counts_over_parts(mesh, half);
    EXPECT_LT(counts.p_value, 1e-60);
    EXPECT_GT(counts.chi_square, 399);
    half.resize(19);
    EXPECT_EQ(counts_over_parts(mesh, half).parts, 0U);
}

/// Two triangles of half of the area each beside a square of 2^-20 of it, whose 8,192 triangles share no area worth a
/// part.
TEST(CountsOverParts, LetLargeTrianglesBePartsOfTheirOwn)
{
    TriangleMesh mesh = square_mesh(64);
    for (MeshPoint& p : mesh.vertices) p = {p[0] / 1024, p[1] / 1024, 0};
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {{2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0}});
    mesh.triangles.insert(mesh.triangles.end(), {{first, first + 1, first + 2}, {first, first + 2, first + 3}});
    const auto last = static_cast<std::uint32_t>(mesh.triangles.size() - 1);
    std::vector<MeshPosition> points(300, MeshPosition{last, {0.5, 0.25, 0.25}});
    points.resize(600, MeshPosition{last - 1, {0.5, 0.25, 0.25}});
    const CountsOverParts counts = counts_over_parts(mesh, points);
    EXPECT_GE(counts.parts, 2U);
    EXPECT_LE(counts.parts, 64U);
    EXPECT_TRUE(std::isfinite(counts.chi_square));
    EXPECT_GT(counts.p_value, 0.9) << "as many points on each as their areas ask for";
}

}
}
