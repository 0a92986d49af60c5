// The transform of points and its adjoint, against sums term by term.
#include "analysis/spectra/nonuniform_transform.hpp"
#include "tests/support/brute_force.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

TEST(NonuniformTransform, IsTheSumOfWaves)
{
    std::mt19937_64 random(1);
    for (const int reach : {1, 5, 24}) {
        const PointSet points = test::random_points_with_borders(60, 2, random);
        const HalfPlane transform = NonuniformTransform(reach).forward(points);
        for (int v = -reach; v <= reach; ++v)
            for (int u = 0; u <= reach; ++u) {
                const std::complex<double> expected(test::brute_force_transform(points, {u, v, 0}));
                EXPECT_LT(std::abs(transform.at(u, v) - expected), 60 * 2e-7) << u << ", " << v;
            }
    }
}

TEST(NonuniformTransform, HasAnAdjointThatIsTheSumOverFrequencies)
{
    std::mt19937_64 random(2);
    constexpr int reach = 9;
    const PointSet points = test::random_points_with_borders(40, 2, random);
    HalfPlane coefficients(reach);
    for (int v = -reach; v <= reach; ++v)
        for (int u = 0; u <= reach; ++u)
            coefficients.at(u, v) = {test::uniform(random) - 0.5, test::uniform(random) - 0.5};
    for (int v = 0; v <= reach; ++v) coefficients.at(0, -v) = std::conj(coefficients.at(0, v));
    coefficients.at(0, 0) = 0.25;
    const auto values = NonuniformTransform(reach).adjoint(coefficients, points);
    for (std::size_t j = 0; j < points.size(); ++j) {
        double sum = 0;
        for (int v = -reach; v <= reach; ++v)
            for (int u = 0; u <= reach; ++u) {
                const double turn = 2 * std::numbers::pi * (u * points[j][0] + v * points[j][1]);
                sum += (u > 0 ? 2 : 1) * (coefficients.at(u, v) * std::polar(1.0, turn)).real();
            }
        EXPECT_NEAR(values[j], sum, 2e-7 * (2 * reach + 1) * (2 * reach + 1));
    }
}

}
}
