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
    const std::vector<SkyLight> lights = sky_lights(map, places, SeenFrom::outside);
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
    const std::vector<SkyLight> lights = sky_lights(map, places_of(map, 30, points), SeenFrom::inside);
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

using Direction = std::array<double, 3>;

double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// A sky with a broad light from the east, a narrower one above, and twilight.
double known_sky(const Direction& from)
{
    const Direction east{std::sqrt(0.5), std::sqrt(0.5), 0}, above{0, -0.6, 0.8};
    return 0.1 + std::exp(6 * (dot(from, east) - 1)) + 2 * std::exp(20 * (dot(from, above) - 1));
}

/// Polar angle, and longitude counterclockwise from +x.
Direction direction_at(double polar, double longitude)
{
    return {std::sin(polar) * std::cos(longitude), std::sin(polar) * std::sin(longitude), std::cos(polar)};
}

/// The irradiance of a surface under the sky, by a sum over the sphere without any map.
double irradiance(const Direction& normal)
{
    constexpr int rows = 400;
    double sum = 0;
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < 2 * rows; ++k) {
            const double polar = std::numbers::pi * (i + 0.5) / rows;
            const Direction from = direction_at(polar, std::numbers::pi * (k + 0.5) / rows);
            sum += known_sky(from) * std::max(0.0, dot(from, normal)) * std::sin(polar);
        }
    return sum * std::numbers::pi * std::numbers::pi / rows / rows;
}

/// The map of the sky by the rule of Blender (u from the left is 1/2 - atan2(y, x) / (2 pi)), or the other way round.
LinearPicture map_of_known_sky(SeenFrom seen_from)
{
    constexpr int height = 128;
    std::vector<float> values;
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < 2 * height; ++column) {
            const double u = (column + 0.5) / (2 * height);
            const double longitude = 2 * std::numbers::pi * (seen_from == SeenFrom::inside ? 0.5 - u : u);
            const double light = known_sky(direction_at(std::numbers::pi * (row + 0.5) / height, longitude));
            values.insert(values.end(), 3, static_cast<float>(light));
        }
    return map_of(2 * height, height, values);
}

/// Lights give surfaces the irradiance of the sky. Each stands for a cell of 1/100 of the light's columns and rows, in
/// parts of the sphere at most some 0.1 wide where the sky is darkest: a cosine's mean over it differs from that in its
/// middle by at most 0.1^2 / 2. Taken the other way round, the map gives something else.
TEST(SkyLights, GiveSurfacesTheirIrradiance)
{
    constexpr std::uint32_t side = 100;
    SquarePoints points;
    for (std::uint32_t i = 0; i < side * side; ++i)
        for (const std::uint32_t k : {i % side, i / side})
            points.push_back(static_cast<std::uint32_t>((k + 0.5) / side * 0x1p32));
    for (const SeenFrom seen_from : {SeenFrom::inside, SeenFrom::outside}) {
        const LinearPicture map = map_of_known_sky(seen_from);
        const PixelPlaces places = reference::warp_points(WarpTable(sky_density(map, "map")), points);
        const auto given = [&](const Direction& normal, SeenFrom taken_as) {
            double sum = 0;
            for (const SkyLight& light : sky_lights(map, places, taken_as))
                sum += light.power[0] * std::max(0.0, dot(light.direction, normal));
            return sum;
        };
        const SeenFrom other = seen_from == SeenFrom::inside ? SeenFrom::outside : SeenFrom::inside;
        for (const Direction& normal : {Direction{1, 0, 0}, Direction{0, 1, 0}, Direction{0, 0, 1}, Direction{-1, 0, 0},
                                        Direction{0, -1, 0}, Direction{0.48, 0.6, -0.64}}) {
            const double right = irradiance(normal);
            EXPECT_NEAR(given(normal, seen_from), right, 0.005 * right);
        }
        EXPECT_GT(std::abs(given({1, 0, 0}, other) / irradiance({1, 0, 0}) - 1), 0.2);
    }
}

/// A value that compression leaves below 0 gives no light; each light's colours are at least 0, and its luminance is
/// that of the others.
TEST(SkyLights, HaveNoPowerBelowNothing)
{
    LinearPicture map = random_map(16);
    map.values[0] = -0.5f;                                                        // one colour of a bright pixel
    for (int i = 3; i < 9; ++i) map.values[static_cast<std::size_t>(i)] = -0.01f; // two pixels
    const Density density = sky_density(map, "map.exr");
    EXPECT_THAT(density.note, HasSubstr("map.exr: 2 pixels below 0, by up to"));
    SquarePoints points;
    const PixelPlaces places = places_of(map, 30, points);
    double sum = 0;
    for (const SkyLight& light : sky_lights(map, places, SeenFrom::inside)) {
        for (const double power : light.power) EXPECT_GE(power, 0);
        double each = 0;
        for (std::size_t c = 0; c < 3; ++c) each += rec_709[c] * light.power[c];
        EXPECT_NEAR(each, sky_luminance(map) / 900, 1e-12 * sky_luminance(map));
        sum += each;
    }
    EXPECT_NEAR(sum, sky_luminance(map), 1e-9 * sum);
}

TEST(SkyLights, ComeFromMapsTwiceAsWideAsHigh)
{
    const LinearPicture square = map_of(4, 4, std::vector<float>(48, 1));
    EXPECT_THAT(message_of([&] { sky_density(square, "probe.hdr"); }),
                HasSubstr("probe.hdr: 4 x 4 pixels: an environment map must be twice as wide as high"));
}

}
}
