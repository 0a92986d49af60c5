// Spectra against sums of Legendre polynomials over all pairs, which is the addition theorem, and discrepancies against
// the integral over caps.
#include "analysis/sphere/sphere_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using Vectors = std::vector<std::array<double, 3>>;

Vectors random_vectors(std::size_t count, unsigned seed)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Vectors all;
    while (all.size() < count) {
        std::array<double, 3> v{normal(random), normal(random), normal(random)};
        const double length = std::hypot(v[0], v[1], v[2]);
        for (double& c : v) c /= length;
        all.push_back(v);
    }
    return all;
}

double dot(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

TEST(SphereMeasures, MeanPowerOfADegreeIsTheSumOfLegendrePolynomialsOfPairs)
{
    for (const std::size_t count : {1U, 2U, 3U, 8U, 100U}) {
        Vectors points = random_vectors(count, 3);
        points.front() = {0, 0, 1}; // a pole, where all orders but 0 vanish
        const std::uint32_t highest = 300;
        const std::vector<double> powers = harmonic_powers(points, highest);
        ASSERT_EQ(powers.size(), 301U * 301 - 1);
        for (const std::uint32_t degree : {1U, 2U, 3U, 10U, 99U, 300U}) {
            double of_pairs = 0, mean = 0;
            for (const auto& a : points)
                for (const auto& b : points)
                    of_pairs += std::legendre(degree, std::clamp(dot(a, b), -1.0, 1.0)) / static_cast<double>(count);
            for (std::uint32_t i = 0; i < 2 * degree + 1; ++i)
                mean += powers[degree * degree - 1 + i] / (2 * degree + 1);
            EXPECT_NEAR(mean, of_pairs, 1e-9 * static_cast<double>(count)) << count << " points, degree " << degree;
        }
    }
}

/// Single harmonics, by their closed forms: Y_1 = sqrt(3 / 4 pi) (z, x, y), Y_2,2 = sqrt(15 / 16 pi) (x^2 - y^2), ...
TEST(SphereMeasures, HarmonicsAreThoseOfClosedForms)
{
    const Vectors points = random_vectors(20, 4);
    const std::vector<double> powers = harmonic_powers(points, 2);
    const auto power = [&](double factor, auto of) {
        double sum = 0;
        for (const auto& v : points) sum += std::sqrt(factor / std::numbers::pi) * of(v[0], v[1], v[2]);
        return sum * sum * 4 * std::numbers::pi / 20;
    };
    const std::vector<double> expected{power(0.75, [](double, double, double z) { return z; }),
                                       power(0.75, [](double x, double, double) { return x; }),
                                       power(0.75, [](double, double y, double) { return y; }),
                                       power(5 / 16.0, [](double, double, double z) { return 3 * z * z - 1; }),
                                       power(15 / 4.0, [](double x, double, double z) { return x * z; }),
                                       power(15 / 4.0, [](double, double y, double z) { return y * z; }),
                                       power(15 / 16.0, [](double x, double y, double) { return x * x - y * y; }),
                                       power(15 / 4.0, [](double x, double y, double) { return x * y; })};
    ASSERT_EQ(powers.size(), expected.size());
    for (std::size_t i = 0; i < powers.size(); ++i) EXPECT_NEAR(powers[i], expected[i], 1e-12) << i;
    EXPECT_EQ(harmonic_eigenvalues(2), (std::vector<double>{2, 2, 2, 6, 6, 6, 6, 6}));
}

TEST(SphereMeasures, DistancesAreThoseOfPolyhedra)
{
    const Vectors octahedron{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const SpherePairs pairs = sphere_pairs(octahedron);
    EXPECT_NEAR(pairs.least, std::numbers::pi / 2, 1e-15);
    EXPECT_NEAR(pairs.mean_nearest, std::numbers::pi / 2, 1e-14);
    EXPECT_NEAR(pairs.cap_discrepancy, 18 * (4 / 3.0 - (4 * std::sqrt(2) + 2) / 6) / 4, 1e-12);
    const SpherePairs poles = sphere_pairs(Vectors{{0, 0, 1}, {0, 0, -1}});
    EXPECT_NEAR(poles.least, std::numbers::pi, 1e-15);
    EXPECT_NEAR(poles.cap_discrepancy, 6 * (4 / 3.0 - 1) / 4, 1e-15);
}

/// Caps around random places, at random heights: the square of what they have too much, within four standard errors.
TEST(SphereMeasures, CapDiscrepancyIsTheIntegralOverCaps)
{
    const Vectors points = random_vectors(15, 5);
    const Vectors centres = random_vectors(200'000, 6);
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> height(-1, 1);
    double sum = 0, squares = 0;
    for (const auto& centre : centres) {
        const double t = height(random);
        const auto inside = std::ranges::count_if(points, [&](const auto& v) { return dot(v, centre) >= t; });
        const double square = 2 * std::pow(static_cast<double>(inside) / 15 - (1 - t) / 2, 2);
        sum += square;
        squares += square * square;
    }
    const double mean = sum / 200'000, error = std::sqrt((squares / 200'000 - mean * mean) / 200'000);
    EXPECT_NEAR(sphere_pairs(points).cap_discrepancy / (3 * 15), mean, 4 * error);
}

}
}
