// Environment maps as densities over the sphere, sets to compare with, and counts.
#include "host/distribution/sphere/sphere_set.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// The mean of the light over the sphere is 1, and evened places are even: both by 200,000 random places.
TEST(SphereSet, LightHasTheMeanOneAndEvenedPlacesAreEven)
{
    const SphereLight light("0.1 + (x > 0)*(y > 0.25)", SeenFrom::outside);
    double mean = 0, most = 0, across = 0, up = 0;
    for (const SpherePlace& place : random_sphere_points(200'000, 1)) {
        const double here = light.at(place);
        mean += here / 200'000;
        most = std::max(most, here);
        // x > 0 is the eastern half of the map, whose left border is longitude 0; y > 1/4 is above 45 degrees.
        const bool is_light = place.turns > 0.5 && place.z > std::sqrt(0.5);
        EXPECT_EQ(here > 1, is_light) << place.turns << " " << place.z;
        const auto [u, v] = light.evened(place);
        EXPECT_TRUE(u >= 0 && u <= 1 && v >= 0 && v <= 1);
        across += here * u / 200'000;
        up += here * v / 200'000;
    }
    // The light of the bright part is 1.1 of 0.1 + (1 - sqrt(1/2)) / 4; steps of pixels fall on both borders.
    const double bright = 1.1 / (0.1 + (1 - std::sqrt(0.5)) / 4);
    EXPECT_NEAR(most, bright, 1e-6 * bright);
    EXPECT_NEAR(light.most(), bright, 1e-6 * bright);
    const double error = bright * std::sqrt((1 - std::sqrt(0.5)) / 4 / 200'000);
    EXPECT_NEAR(mean, 1, 4 * error);
    EXPECT_NEAR(across, 0.5, 4 * error); // weighted by the light, evened places have the mean 1/2 along both axes
    EXPECT_NEAR(up, 0.5, 4 * error);
}

/// From inside, the middle column is +x, and columns to the right turn clockwise: a quarter to the right of it is -y.
TEST(SphereSet, SidesAreThoseOfSkyLights)
{
    const SphereLight inside("0.001 + (abs(x - 0.5) < 0.1)", SeenFrom::inside),
        outside("0.001 + (abs(x - 0.5) < 0.1)", SeenFrom::outside);
    const SpherePlace minus_y{0, 1, 0.75};
    EXPECT_GT(inside.at(minus_y), 1);
    EXPECT_GT(outside.at(minus_y), 1); // three quarters of the map: the longitude 270 degrees
    const SphereLight left("0.001 + (x < -0.9)", SeenFrom::outside),
        left_inside("0.001 + (x < -0.9)", SeenFrom::inside);
    EXPECT_GT(left.at({0, 1, 0.01}), 1);
    EXPECT_LT(left_inside.at({0, 1, 0.01}), 1);
    EXPECT_GT(left_inside.at({0, 1, 0.49}), 1);
    EXPECT_GT(left.at({1, 0, 0}), 0); // the poles
    EXPECT_GT(left.at({-1, 0, 0}), 0);
}

/// Counts of a grid are all the same, those of one place are not, and of few points there are none.
TEST(SphereSet, CountsAreThoseOfCells)
{
    EXPECT_EQ(counts_in_square({}).parts, 0U);
    EXPECT_EQ(counts_in_square({19, {0.5, 0.5}}).parts, 0U);
    std::vector<std::array<double, 2>> grid;
    for (int i = 0; i < 5120; ++i) grid.push_back({(i % 64 + 0.5) / 64, (static_cast<double>(i / 64) + 0.5) / 80});
    EXPECT_EQ(counts_in_square(grid).parts, 512U);
    EXPECT_EQ(counts_in_square(grid).chi_square, 0);
    EXPECT_EQ(counts_in_square(grid).p_value, 1);
    const CountsOverParts one = counts_in_square(std::vector<std::array<double, 2>>(20, {1.0, 1.0}));
    EXPECT_EQ(one.parts, 2U);
    EXPECT_EQ(one.chi_square, 20);
}

/// Heights are the middles of equal parts, and of whatever number of points.
TEST(SphereSet, FibonacciLatticeIsOnTheSphere)
{
    EXPECT_TRUE(fibonacci_sphere_points(0).empty());
    EXPECT_EQ(fibonacci_sphere_points(1).front().z, 0);
    for (const std::size_t points : {2U, 3U, 1000U}) {
        double sum = 0;
        for (const SpherePlace& place : fibonacci_sphere_points(points)) {
            EXPECT_TRUE(place.turns >= 0 && place.turns < 1);
            EXPECT_NEAR(place.z * place.z + place.away * place.away, 1, 1e-15);
            sum += place.z;
        }
        EXPECT_NEAR(sum, 0, 1e-12);
    }
}

}
}
