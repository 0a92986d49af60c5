// Measures of points that follow a density, against counts by hand and lattices.
#include "host/distribution/density_measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

Density constant_density(int width, int height)
{
    return {width, height, std::vector<std::uint64_t>(static_cast<std::size_t>(width * height), full_weight)};
}

std::uint64_t place(double pixels) { return static_cast<std::uint64_t>(pixels * 0x1p32); }

/// Counts of random points have the Poisson distribution, whose variance is its mean: over 256 windows the mean of the
/// squared deviations has a standard deviation of sqrt(2 / 256).
TEST(DensityError, IsOneForRandomPoints)
{
    std::mt19937 random(5);
    PixelPlaces places;
    for (int i = 0; i < 20'000; ++i) {
        places.push_back(place(10 * (static_cast<double>(random()) / 0x1p32)));
        places.push_back(place(7 * (static_cast<double>(random()) / 0x1p32)));
    }
    EXPECT_NEAR(density_error(constant_density(10, 7), places), 1, 4 * std::sqrt(2.0 / 256));
}

/// One point in the middle of each window but the first, which has three: 257 expected in 256 windows, 1.0039 each.
TEST(DensityError, IsThatOfCountsByHand)
{
    PixelPlaces places;
    for (int i = 0; i < 256; ++i)
        for (int copy = i == 0 ? 0 : 2; copy < 3; ++copy) {
            places.push_back(place(i % 16 * 2 + 1));
            places.push_back(place(i / 16 * 2 + 1));
        }
    const double expected = 258.0 / 256;
    const double sum = (255 * (1 - expected) * (1 - expected) + (3 - expected) * (3 - expected)) / expected;
    EXPECT_NEAR(density_error(constant_density(32, 32), places), sum / 256, 1e-12);
}

/// The spacing of a square lattice is sqrt(sqrt 3 / 2) = 0.93 of that of the hexagonal lattice, at any density.
TEST(LocalSpacing, OfSquareLatticesIsKnown)
{
    PixelPlaces places;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 20; ++x) {
            places.push_back(place(x * 0.5 + 0.25));
            places.push_back(place(y * 0.5 + 0.25));
        }
    const LocalSpacing spacing = local_spacing(constant_density(10, 10), places);
    EXPECT_NEAR(spacing.mean, std::sqrt(std::numbers::sqrt3 / 2), 1e-9);
    EXPECT_NEAR(spacing.least, spacing.mean, 1e-9);
}

/// Distances count for what the density asks for there: a lattice of half the distance where it is four times as dense.
TEST(LocalSpacing, IsRelativeToTheDensity)
{
    Density density = constant_density(2, 1);
    density.weights = {full_weight, full_weight / 4};
    PixelPlaces places;
    const auto lattice = [&](double x, int side) {
        for (int i = 0; i < side * side; ++i) {
            places.push_back(place(x + (i % side + 0.5) / side));
            places.push_back(place((i / side + 0.5) / side));
        }
    };
    lattice(0, 32);
    lattice(1, 16);
    // Beside the border between both, distances are (1/32 + 1/16) / 2: nowhere less than in the dense half.
    const LocalSpacing spacing = local_spacing(density, places);
    EXPECT_NEAR(spacing.mean, std::sqrt(std::numbers::sqrt3 / 2), 0.005);
    EXPECT_LT(spacing.least, spacing.mean + 1e-9);
}

}
}
