#include "analysis/zone_plate/false_rings.hpp"

#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace poissonlab {
namespace {

FalseRings rings_of(const SquareImage& picture)
{
    return strongest_false_rings(picture, zone_plate_reference(picture.size));
}

/// The reference with white noise, and a plate of this amplitude around a place.
SquareImage picture_with_rings(int size, double amplitude, double x0, double y0)
{
    SquareImage picture = zone_plate_reference(size);
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(0, 0.1);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const double x = (column + 0.5) * plate_side / size - x0;
            const double y = (row + 0.5) * plate_side / size - y0;
            picture.pixels[static_cast<std::size_t>(row * size + column)] +=
                noise(random) + amplitude * std::sin(x * x + y * y + 1);
        }
    return picture;
}

TEST(FalseRings, NoiseHasNone)
{
    const auto rings = rings_of(picture_with_rings(256, 0, 0, 0));
    EXPECT_LT(rings.strength, false_rings_bound(256 * 256));
    // The largest of n exponential powers is ln n + 0.58 on average, with a standard deviation of 1.28.
    EXPECT_NEAR(rings.strength, std::log(256.0 * 256) + 0.58, 5 * 1.28);
}

// A wave exp(-2 i c.x) of amplitude a / 2 over n^2 pixels has power (a n^2 / 2)^2 where noise of variance s^2 has n^2
// s^2: (a n / 2 s)^2, here (0.05 * 256 / 0.2)^2 = 64^2, where c is on the grid of pi / 48.
TEST(FalseRings, AreFoundWhereTheyAre)
{
    const double step = std::numbers::pi / plate_side;
    const auto rings = rings_of(picture_with_rings(256, 0.05, 100 * step, 37 * step));
    EXPECT_NEAR(rings.x, 100 * step, 1e-9);
    EXPECT_NEAR(rings.y, 37 * step, 1e-9);
    // Four standard errors of a mean of some thousand powers, and of the wave's own amplitude.
    EXPECT_NEAR(rings.strength, 64.0 * 64, 64 * 64 * (4.0 / std::sqrt(1064.0) + 4.0 / 64));
}

TEST(FalseRings, TellALatticeFromNoise)
{
    constexpr int side = 512; // the dissertation's
    auto centres = test::square_lattice(side, 2);
    for (double& x : centres.coordinates) x += 0.5 / side;
    const auto lattice = rings_of(zone_plate_image(centres));
    // One sample in the middle of each pixel: what is false folds onto the plate itself, all of it with the same sign.
    EXPECT_GT(lattice.at_the_plate, 100 * false_rings_bound(side * side));

    auto jittered = test::square_lattice(side, 2);
    std::mt19937_64 random(1);
    for (double& x : jittered.coordinates) x += (test::uniform(random) - 0.5) / side;
    for (double& x : jittered.coordinates) x -= std::floor(x);
    const auto noise = rings_of(zone_plate_image(jittered));
    EXPECT_LT(noise.strength, false_rings_bound(side * side));
    EXPECT_LT(noise.at_the_plate, 0.01 * lattice.at_the_plate);
}

TEST(FalseRings, RefusesSmallPictures) { EXPECT_THROW(rings_of(zone_plate_reference(63)), std::invalid_argument); }

}
}
