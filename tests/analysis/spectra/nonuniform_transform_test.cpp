// The transform of points and its adjoint, against sums term by term.
#include "analysis/spectra/nonuniform_transform.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>
#include <random>
#include <span>

namespace poissonlab {
namespace {

TEST(NonuniformTransform, IsTheSumOfWaves)
{
    std::mt19937_64 random(1);
    for (const int reach : {1, 5, 60}) {
        const PointSet points = test::random_points_with_borders(60, 2, random);
        const HalfPlane transform = NonuniformTransform(reach).forward(points);
        for (int v = -reach; v <= reach; ++v)
            for (int u = 0; u <= reach; ++u) {
                const std::complex<double> expected(test::brute_force_transform(points, {u, v, 0}));
                EXPECT_LT(std::abs(transform.at(u, v) - expected), 60 * 2e-7) << u << ", " << v;
            }
    }
}

/// Hermitian coefficients at random.
HalfPlane random_coefficients(int reach, std::mt19937_64& random)
{
    HalfPlane coefficients(reach);
    for (int v = -reach; v <= reach; ++v)
        for (int u = 0; u <= reach; ++u)
            coefficients.at(u, v) = {test::uniform(random) - 0.5, test::uniform(random) - 0.5};
    for (int v = 0; v <= reach; ++v) coefficients.at(0, -v) = std::conj(coefficients.at(0, v));
    coefficients.at(0, 0) = 0.25;
    return coefficients;
}

/// The sum over all frequencies of the real part of what(u, v, wave) times the coefficient, at a point.
template <class What>
double sum_at(std::span<const double> point, const HalfPlane& coefficients, const What& what)
{
    double sum = 0;
    for (int v = -coefficients.reach; v <= coefficients.reach; ++v)
        for (int u = 0; u <= coefficients.reach; ++u) {
            const double turn = 2 * std::numbers::pi * (u * point[0] + v * point[1]);
            sum += (u > 0 ? 2 : 1) * (coefficients.at(u, v) * std::polar(1.0, turn) * what(u, v)).real();
        }
    return sum;
}

TEST(NonuniformTransform, HasAnAdjointThatIsTheSumOverFrequencies)
{
    std::mt19937_64 random(2);
    for (const int reach : {1, 9, 60}) {
        const PointSet points = test::random_points_with_borders(40, 2, random);
        const HalfPlane coefficients = random_coefficients(reach, random);
        const auto values = NonuniformTransform(reach).adjoint(coefficients, points);
        for (std::size_t j = 0; j < points.size(); ++j) {
            const double sum = sum_at(points[j], coefficients, [](int, int) { return std::complex(1.0); });
            EXPECT_NEAR(values[j], sum, 2e-7 * (2 * reach + 1) * (2 * reach + 1));
        }
    }
}

TEST(NonuniformTransform, HasTheDerivativesOfThatSum)
{
    std::mt19937_64 random(3);
    const std::complex<double> turn(0, 2 * std::numbers::pi);
    for (const int reach : {1, 9, 60}) {
        const PointSet points = test::random_points_with_borders(40, 2, random);
        const HalfPlane coefficients = random_coefficients(reach, random);
        const auto slopes = NonuniformTransform(reach).adjoint_gradient(coefficients, points);
        // Magnitudes are at most 0.71; derivatives at the largest frequency have 2 pi reach of them.
        const double error = 1e-6 * 2 * std::numbers::pi * reach * (2 * reach + 1) * (2 * reach + 1);
        for (std::size_t j = 0; j < points.size(); ++j) {
            const double along_x = sum_at(points[j], coefficients, [&](int u, int) { return turn * double(u); });
            const double along_y = sum_at(points[j], coefficients, [&](int, int v) { return turn * double(v); });
            EXPECT_NEAR(slopes[2 * j], along_x, error);
            EXPECT_NEAR(slopes[2 * j + 1], along_y, error);
        }
    }
}

TEST(NonuniformTransform, IsTheSameForAnyNumberOfThreads)
{
    std::mt19937_64 random(4);
    constexpr int reach = 300; // 12 strips
    const PointSet points = test::random_points_with_borders(3000, 2, random);
    const auto transformed = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        NonuniformTransform transform(reach);
        const HalfPlane plane = transform.forward(points);
        return std::pair(plane.values, transform.adjoint_gradient(plane, points));
    };
    const auto one = transformed(1);
    EXPECT_EQ(transformed(2), one);
    EXPECT_EQ(transformed(5), one);
    for (const int v : {-300, 7, 299})
        for (const int u : {0, 150, 300}) {
            const std::complex<double> expected(test::brute_force_transform(points, {u, v, 0}));
            EXPECT_LT(std::abs(one.first[static_cast<std::size_t>((v + reach) * (reach + 1) + u)] - expected),
                      3000 * 2e-7);
        }
}

}
}
