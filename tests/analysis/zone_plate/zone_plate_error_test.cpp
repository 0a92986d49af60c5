#include "analysis/zone_plate/zone_plate_error.hpp"

#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

using namespace test;

TEST(ZonePlateError, OfTheReferenceIsZero)
{
    ZonePlateError error;
    EXPECT_EQ(error.add(zone_plate_reference(64)).whole, 0);
    for (const ErrorBin& bin : error.curve()) EXPECT_EQ(bin.rms_error, 0);
}

TEST(ZonePlateError, OfAnOffsetIsTheOffset)
{
    ZonePlateError error;
    for (const double offset : {0.03, 0.04}) {
        SquareImage image = zone_plate_reference(128);
        for (double& pixel : image.pixels) pixel += offset;
        const PlateError of = error.add(image);
        EXPECT_NEAR(of.whole, offset, 1e-14);
        EXPECT_NEAR(of.resolved, offset, 1e-14);
    }
    std::size_t pixels = 0;
    for (const ErrorBin& bin : error.curve()) {
        EXPECT_NEAR(bin.rms_error, std::sqrt((0.03 * 0.03 + 0.04 * 0.04) / 2), 1e-14);
        pixels += bin.pixels;
    }
    EXPECT_EQ(pixels, 2U * 128 * 128);
}

TEST(ZonePlateError, BelongsToTheDistanceOfThePixel)
{
    SquareImage image = zone_plate_reference(512);
    image.pixels[300 * 512 + 40] += 1; // column 40, row 300
    ZonePlateError error;
    const PlateError of = error.add(image);
    EXPECT_NEAR(of.whole, 1.0 / 512, 1e-12);
    EXPECT_EQ(of.resolved, 0) << "0.97 cycles per pixel";
    const double distance = 48.0 / 512 * std::hypot(40.5, 300.5);
    for (const ErrorBin& bin : error.curve()) {
        EXPECT_DOUBLE_EQ(bin.frequency, plate_frequency(bin.distance, 512));
        if (std::abs(bin.distance - distance) < 0.25)
            EXPECT_NEAR(bin.rms_error, 1 / std::sqrt(static_cast<double>(bin.pixels)), 1e-12);
        else
            EXPECT_EQ(bin.rms_error, 0) << bin.distance;
    }
}

TEST(ZonePlateError, SmallPicturesLeaveBinsOut)
{
    ZonePlateError error;
    error.add(zone_plate_reference(2)); // pixels' centres at 12 and 36
    const auto curve = error.curve();
    ASSERT_EQ(curve.size(), 3U);
    EXPECT_EQ(curve[0].distance, 16.75); // 12 sqrt 2 = 16.97
    EXPECT_EQ(curve[1].pixels, 2U);
    EXPECT_EQ(curve[2].distance, 50.75); // 36 sqrt 2 = 50.91
}

TEST(ZonePlateError, PicturesMayDifferInSize)
{
    ZonePlateError error;
    error.add(zone_plate_reference(40));
    EXPECT_EQ(error.add(zone_plate_reference(41)).whole, 0);
    EXPECT_DOUBLE_EQ(error.curve().back().frequency, plate_frequency(error.curve().back().distance, 40));
}

TEST(ZonePlateError, IsResolvedUpToHalfACyclePerPixel)
{
    // Half a cycle per pixel: r = pi / 2 * 512 / 48 units, 178.7 pixels.
    const auto resolved_with_error_at = [](int column) {
        SquareImage image = zone_plate_reference(512);
        image.pixels[static_cast<std::size_t>(column)] += 1;
        return ZonePlateError().add(image).resolved;
    };
    EXPECT_NEAR(resolved_with_error_at(178), 1 / std::sqrt(std::numbers::pi / 4 * 178.7 * 178.7), 1e-4);
    EXPECT_EQ(resolved_with_error_at(179), 0);
}

/// The purpose of the sampling test: regular sets make rings that are not there, jittered ones noise, and both
/// are right where the plate is coarse.
TEST(ZonePlateError, TellsRegularFromJitteredFromRandom)
{
    std::mt19937_64 random(1);
    PointSet regular = square_lattice(512, 2);
    PointSet jittered = regular;
    for (double& x : regular.coordinates) x += 0.5 / 512;
    for (double& x : jittered.coordinates) x += uniform(random) / 512;
    const auto error_of = [](const PointSet& points) { return ZonePlateError().add(zone_plate_image(points)); };
    const PlateError of_regular = error_of(regular);
    const PlateError of_jittered = error_of(jittered);
    const PlateError of_random = error_of(random_points(512 * 512, 2, random));
    EXPECT_LT(of_regular.resolved, 0.5 * of_jittered.resolved);
    EXPECT_LT(of_jittered.resolved, 0.85 * of_random.resolved);
    // Where nothing can be resolved, the variance 1/8 of the plate remains as noise, times the integral of
    // the squared filter, 0.464: 0.24 and a little more, as the sums of weights vary. Regular sets turn it
    // into rings.
    for (const PlateError& error : {of_regular, of_jittered, of_random}) {
        EXPECT_GT(error.whole, 0.2);
        EXPECT_LT(error.whole, 0.3);
    }
}

}
}
