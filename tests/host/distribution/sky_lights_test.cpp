// Environment maps as lights: solid angles, even skies, and sums of powers.
#include "host/distribution/sky_lights.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;

constexpr std::array<double, 3> rec_709{0.2126, 0.7152, 0.0722};

LinearPicture map_of(int width, int height, const std::vector<float>& values)
{
    return {width, height, {"R", "G", "B"}, {}, values};
}

LinearPicture random_map(int height)
{
    std::mt19937 random(3);
    std::vector<float> values;
    for (int i = 0; i < 2 * height * height * 3; ++i) values.push_back(static_cast<float>(random() % 1000) + 1);
    return map_of(2 * height, height, values);
}

/// Places of a sky's lights for points of a lattice.
PixelPlaces places_of(const LinearPicture& map, std::uint32_t side, SquarePoints& points)
{
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x)
            points.insert(points.end(), {0xffffffff / side * x + 1000, 0xffffffff / side * y + 1000});
    return reference::warp_points(WarpTable(sky_density(map, "map")), points);
}

TEST(SkyLights, KnowTheSolidAnglesOfPixels)
{
    double sum = 0;
    for (int row = 0; row < 100; ++row) {
        const double above = std::numbers::pi * row / 100, below = std::numbers::pi * (row + 1) / 100;
        EXPECT_NEAR(solid_angle(row, 200, 100), std::numbers::pi / 100 * (std::cos(above) - std::cos(below)), 1e-16);
        sum += 200 * solid_angle(row, 200, 100);
    }
    EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-13);
}

/// Heights on a sphere are even: that of a point of the square goes from -1 to 1 as y goes from 0 to 1. Weights of the
/// rows at the poles are exact to 2^-40 of the largest, which is some 10 times as large.
TEST(SkyLights, OfAnEvenSkyAreEven)
{
    const LinearPicture map = map_of(32, 16, std::vector<float>(32 * 16 * 3, 0.25f));
    SquarePoints points;
    const PixelPlaces places = places_of(map, 40, points);
    const std::vector<SkyLight> lights = sky_lights(map, places);
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const auto [x, y, z] = lights[i].direction;
        EXPECT_NEAR(z, 2 * (points[2 * i + 1] / 0x1p32) - 1, 1e-9);
        EXPECT_NEAR(x * x + y * y + z * z, 1, 1e-14);
        const double longitude = 2 * std::numbers::pi * (points[2 * i] / 0x1p32);
        EXPECT_NEAR(x, std::sqrt(1 - z * z) * std::cos(longitude), 1e-9);
        EXPECT_NEAR(y, std::sqrt(1 - z * z) * std::sin(longitude), 1e-9);
    }
}

/// All lights have one luminance, and their sum is that of the map, here added by itself with the library's cosines.
TEST(SkyLights, HaveTheLuminanceOfTheMapTogether)
{
    const LinearPicture map = random_map(24);
    SquarePoints points;
    const std::vector<SkyLight> lights = sky_lights(map, places_of(map, 30, points));
    double expected = 0;
    for (int row = 0; row < 24; ++row)
        for (int column = 0; column < 48; ++column)
            for (std::size_t c = 0; c < 3; ++c)
                expected += rec_709[c] * map.at(column, row, c) * (2 * std::numbers::pi / 48) *
                            (std::cos(std::numbers::pi * row / 24) - std::cos(std::numbers::pi * (row + 1) / 24));
    double sum = 0;
    for (const SkyLight& light : lights) {
        double each = 0;
        for (std::size_t c = 0; c < 3; ++c) each += rec_709[c] * light.power[c];
        EXPECT_NEAR(each, expected / 900, 1e-12 * expected);
        sum += each;
    }
    EXPECT_NEAR(sum, expected, 1e-12 * expected);
}

TEST(SkyLights, ComeFromMapsTwiceAsWideAsHigh)
{
    const LinearPicture square = map_of(4, 4, std::vector<float>(48, 1));
    EXPECT_THAT(message_of([&] { sky_density(square, "probe.hdr"); }),
                HasSubstr("probe.hdr: 4 x 4 pixels: an environment map must be twice as wide as high"));
}

}
}
