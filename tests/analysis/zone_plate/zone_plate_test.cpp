#include "analysis/zone_plate/zone_plate_reference.hpp"

#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using namespace test;

TEST(ZonePlate, IsThatOfTheDissertation)
{
    EXPECT_EQ(zone_plate(0, 0), 0.5);
    EXPECT_NEAR(zone_plate(std::sqrt(std::numbers::pi / 2), 0), 1, 1e-15);
    EXPECT_NEAR(zone_plate(1, std::sqrt(1.5 * std::numbers::pi - 1)), 0, 1e-15);
}

TEST(ZonePlate, FrequencyIsThatOfThePhase)
{
    // Cycles between two pixels at distance 10, from the phase r^2 / (2 pi).
    const int size = 512;
    const double pixel = 48.0 / size, r = 10;
    const double cycles =
        ((r + pixel / 2) * (r + pixel / 2) - (r - pixel / 2) * (r - pixel / 2)) / (2 * std::numbers::pi);
    EXPECT_NEAR(plate_frequency(r, size), cycles, 1e-13);
}

TEST(ZonePlate, PictureIsOfTheFunctionAtThePoints)
{
    std::mt19937_64 random(1);
    const auto points = random_points(50 * 50, 2, random);
    std::vector<double> values;
    for (std::size_t k = 0; k < points.size(); ++k) values.push_back(zone_plate(48 * points[k][0], 48 * points[k][1]));
    const auto image = zone_plate_image(points);
    EXPECT_EQ(image.size, 50);
    EXPECT_EQ(image.pixels, reconstruct(points, values, 50).pixels);
}

TEST(ZonePlate, OriginIsThePixelOfRowAndColumnZero)
{
    // The first bright ring, r^2 = pi / 2, lies around the origin and nowhere else.
    const auto image = zone_plate_image([] {
        PointSet points = square_lattice(512, 2);
        for (double& x : points.coordinates) x += 0.5 / 512;
        return points;
    }());
    EXPECT_LT(image.at(0, 0), 0.52);
    EXPECT_GT(image.at(13, 0), 0.95); // sqrt(pi / 2) is 13.4 pixels
    EXPECT_GT(image.at(0, 13), 0.95);
    EXPECT_GT(image.at(9, 9), 0.95);
}

TEST(ZonePlate, RefusesVolumes) { EXPECT_THROW(zone_plate_image({3, {0, 0, 0}}), std::invalid_argument); }

}
}
