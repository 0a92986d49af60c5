#include "analysis/zone_plate/reconstruction.hpp"

#include "tests/support/point_patterns.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace poissonlab {
namespace {

using namespace test;

TEST(MitchellFilter, IsThatOfThePaper)
{
    // Equation 8 of Mitchell and Netravali, with B and C as they stand there.
    const double b = 1.0 / 3, c = 1.0 / 3;
    for (double t = 0; t < 3; t += 1.0 / 64) {
        double weight = 0;
        if (t < 1)
            weight = ((12 - 9 * b - 6 * c) * t * t * t + (-18 + 12 * b + 6 * c) * t * t + (6 - 2 * b)) / 6;
        else if (t < 2)
            weight =
                ((-b - 6 * c) * t * t * t + (6 * b + 30 * c) * t * t + (-12 * b - 48 * c) * t + (8 * b + 24 * c)) / 6;
        EXPECT_NEAR(mitchell_weight(t), weight, 1e-14) << t;
    }
}

TEST(MitchellFilter, ShiftsSumToOneAndKeepStraightLines)
{
    for (double t = 0; t < 1; t += 1.0 / 64) {
        const double sum =
            mitchell_weight(1 + t) + mitchell_weight(t) + mitchell_weight(1 - t) + mitchell_weight(2 - t);
        const double mean = (-1 - t) * mitchell_weight(1 + t) - t * mitchell_weight(t) +
                            (1 - t) * mitchell_weight(1 - t) + (2 - t) * mitchell_weight(2 - t);
        EXPECT_NEAR(sum, 1, 1e-15);
        EXPECT_NEAR(mean, 0, 1e-15);
    }
}

/// The definition, pixel by pixel over all samples.
SquareImage direct_sum(const PointSet& points, const std::vector<double>& values, int size)
{
    SquareImage image{size, {}};
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            double weights = 0, sum = 0;
            double nearest = std::numeric_limits<double>::infinity(), value = 0.5;
            for (std::size_t k = 0; k < points.size(); ++k) {
                const double x = points[k][0] * size, y = points[k][1] * size;
                const double dx = std::abs(x - column - 0.5), dy = std::abs(y - row - 0.5);
                const double weight = mitchell_weight(dx) * mitchell_weight(dy);
                weights += weight;
                sum += weight * values[k];
                if (std::abs(std::floor(x) - column) > 2 || std::abs(std::floor(y) - row) > 2) continue;
                if (std::hypot(dx, dy) >= nearest) continue;
                nearest = std::hypot(dx, dy);
                value = values[k];
            }
            image.pixels.push_back(weights >= 0.25 ? sum / weights : value);
        }
    return image;
}

std::vector<double> random_values(std::size_t count, std::mt19937_64& random)
{
    std::vector<double> values(count);
    for (double& value : values) value = uniform(random);
    return values;
}

TEST(Reconstruction, AgreesWithTheDirectSum)
{
    std::mt19937_64 random(1);
    const int size = 70; // three bands, the last one shorter
    const std::vector<PointSet> sets = {random_points(size * size, 2, random),
                                        random_points(size * size / 7, 2, random),
                                        clustered_points(size * size, 2, 5, 0.1, random), random_points(1, 2, random)};
    for (const auto& points : sets) {
        const auto values = random_values(points.size(), random);
        const auto image = reconstruct(points, values, size);
        const auto expected = direct_sum(points, values, size);
        ASSERT_EQ(image.pixels.size(), expected.pixels.size());
        // Up to 1,000 samples count in a pixel of the clusters; each weight has a rounding error of some
        // 2^-53 x 70 through its distance, and the sum of weights is at least 1/4.
        for (std::size_t p = 0; p < image.pixels.size(); ++p)
            ASSERT_NEAR(image.pixels[p], expected.pixels[p], 4 * 1000 * 70 * 0x1p-53) << p;
    }
}

TEST(Reconstruction, ConstantsStayConstant)
{
    std::mt19937_64 random(2);
    const auto points = random_points(64 * 64, 2, random);
    for (const double constant : {0.0, 0.5, 1.0})
        for (const double pixel : reconstruct(points, std::vector<double>(points.size(), constant), 64).pixels)
            ASSERT_EQ(pixel, constant);
    for (const double pixel : reconstruct(points, std::vector<double>(points.size(), 0.3), 64).pixels)
        ASSERT_NEAR(pixel, 0.3, 64 * 0x1p-53 / least_weight);
}

TEST(Reconstruction, SlopesOnALatticeStaySlopes)
{
    const int n = 32;
    for (const double shift : {0.0, 0.3, 0.5}) { // of the lattice, in pixels
        PointSet points = square_lattice(n, 2);
        for (double& x : points.coordinates) x += shift / n;
        std::vector<double> values;
        for (std::size_t k = 0; k < points.size(); ++k) values.push_back(0.2 + 0.5 * points[k][0] - 0.3 * points[k][1]);
        const auto image = reconstruct(points, values, n);
        for (int row = 2; row < n - 2; ++row) // beyond that, one side has no samples
            for (int column = 2; column < n - 2; ++column)
                ASSERT_NEAR(image.at(column, row), 0.2 + (0.5 * (column + 0.5) - 0.3 * (row + 0.5)) / n, 1e-14);
    }
}

TEST(Reconstruction, DoesNotWrapAround)
{
    // One sample in each pixel; those of the last column and the last row are 1, all others 0.
    const int n = 16;
    PointSet points = square_lattice(n, 2);
    for (double& x : points.coordinates) x += 0.5 / n;
    std::vector<double> values;
    for (std::size_t k = 0; k < points.size(); ++k)
        values.push_back(points[k][0] > 15.0 / n || points[k][1] > 15.0 / n ? 1 : 0);
    const auto image = reconstruct(points, values, n);
    for (int i = 0; i < n - 2; ++i) {
        EXPECT_EQ(image.at(0, i), 0);
        EXPECT_EQ(image.at(i, 0), 0);
    }
    // In the last column, weights 16/18 and 1/18 remain of 1/18, 16/18, 1/18.
    EXPECT_NEAR(image.at(n - 1, 5), 16.0 / 17, 1e-15);
}

TEST(Reconstruction, GapsShowTheNearestSampleOrGrey)
{
    const PointSet points{2, {0.05, 0.05, 0.12, 0.05}}; // of 10 x 10 pixels: (0.5, 0.5) and (1.2, 0.5)
    const auto image = reconstruct(points, std::vector<double>{0.0, 1.0}, 10);
    EXPECT_EQ(image.at(2, 0), 1) << "weights of 1.3 and 2.0 pixels, times 8/9, are below 1/4";
    EXPECT_EQ(image.at(0, 2), 0);
    EXPECT_EQ(image.at(3, 2), 1);
    EXPECT_EQ(image.at(4, 0), 0.5);
    EXPECT_EQ(image.at(9, 9), 0.5);
}

TEST(Reconstruction, TakesCoordinatesJustBelowOne)
{
    const double last = std::nextafter(1.0, 0.0);
    for (const int size : {1, 3, 512}) {
        const auto image = reconstruct({2, {last, last}}, std::vector<double>{1.0}, size);
        EXPECT_EQ(image.at(size - 1, size - 1), 1);
    }
}

TEST(Reconstruction, IsTheSameOnAnyNumberOfThreads)
{
    std::mt19937_64 random(3);
    const auto points = random_points(100 * 100, 2, random);
    const auto values = random_values(points.size(), random);
    const auto expected = reconstruct(points, values, 100);
    for (const std::size_t threads : {1, 2, 5}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        EXPECT_EQ(reconstruct(points, values, 100).pixels, expected.pixels);
    }
}

TEST(Reconstruction, RefusesWhatItCannotUse)
{
    const std::vector<double> one = {1.0};
    EXPECT_THROW(reconstruct({2, {}}, {}, 4), std::invalid_argument);
    EXPECT_THROW(reconstruct({3, {0.5, 0.5, 0.5}}, one, 4), std::invalid_argument);
    EXPECT_THROW(reconstruct({2, {0.5, 0.5, 0.1, 0.1}}, one, 4), std::invalid_argument);
    EXPECT_THROW(reconstruct({2, {0.5, 0.5}}, one, 0), std::invalid_argument);
}

TEST(Reconstruction, HasOneSampleAPixel)
{
    EXPECT_EQ(one_sample_a_pixel(262'144), 512);
    EXPECT_EQ(one_sample_a_pixel(1), 1);
    EXPECT_EQ(one_sample_a_pixel(16'383), 128);
    EXPECT_EQ(one_sample_a_pixel(16'384 + 128), 128);
    EXPECT_EQ(one_sample_a_pixel(16'384 + 129), 129);
}

}
}
