// Directions of lines in pictures whose lines are known.
#include "host/distribution/ink/line_directions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// Waves whose crests lie along `angle`.
PixelValues waves(double angle)
{
    PixelValues picture{64, 48, {}};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            picture.values.push_back(0.5 + 0.5 * std::sin(0.4 * (y * std::cos(angle) - x * std::sin(angle))));
    return picture;
}

TEST(LineDirections, AreThoseOfWaves)
{
    for (const double angle : {0.0, 0.3, 1.0, 1.5, 2.0, 2.8}) {
        const LineDirections lines(waves(angle), 0);
        // Differences of pixels are sines: exact in direction to their third order, (0.4)^2 / 6.
        EXPECT_NEAR(std::sin(lines.at(32.5, 24.5) - angle), 0, 0.03) << angle;
    }
}

TEST(LineDirections, AreTheGivenOneWhereThereAreNoLines)
{
    const PixelValues even{20, 20, std::vector<double>(400, 0.3)};
    EXPECT_EQ(LineDirections(even, 0.7).at(3, 4), 0.7);
}

}
}
