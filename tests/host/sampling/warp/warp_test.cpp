// kernels/warp.cl against its plain twin, bit for bit, and the twin against densities whose warp is known.
#include "host/sampling/warp/warp.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

constexpr std::uint64_t pixel = std::uint64_t{1} << 32;

SquarePoints random_square_points(std::size_t count)
{
    std::mt19937 random(7);
    SquarePoints points{0, 0, 0xffffffff, 0xffffffff, 0, 0xffffffff, 0x80000000, 0x7fffffff};
    while (points.size() < 2 * count) points.push_back(static_cast<std::uint32_t>(random()));
    return points;
}

Density density_of(int width, int height, const std::vector<double>& values)
{
    return density_of_values(width, height, values, "test");
}

/// Weights over many powers of two, of which a third are 0.
Density rough_density(int width, int height)
{
    std::mt19937 random(static_cast<unsigned>(width * 10'000 + height));
    std::vector<double> values;
    for (int i = 0; i < width * height; ++i)
        values.push_back(
            random() % 3 == 0 ? 0 : std::ldexp(static_cast<double>(random()), -static_cast<int>(random() % 40)));
    values[values.size() / 2] = 1;
    return density_of(width, height, values);
}

struct Shape
{
    int width, height;
    std::size_t work_group_size = 0;
};

class WarpedDensities : public testing::TestWithParam<Shape>
{
protected:
    Density density_ = rough_density(GetParam().width, GetParam().height);
};

TEST_P(WarpedDensities, AreTheSameByKernelAndTwin)
{
    const WarpTable table(density_);
    const SquarePoints points = random_square_points(2000);
    PointWarper warper(Device::open(), table, GetParam().work_group_size);
    EXPECT_EQ(warper.warp(points), reference::warp_points(table, points));
}

TEST_P(WarpedDensities, HaveNoPointsWhereTheyAreZero)
{
    const PixelPlaces places = reference::warp_points(WarpTable(density_), random_square_points(2000));
    for (std::size_t i = 0; i < places.size(); i += 2)
        EXPECT_GT(
            density_.weights[(places[i + 1] >> 32) * static_cast<std::size_t>(density_.width) + (places[i] >> 32)], 0);
}

/// The cumulative distribution takes a place back to where its point was: as exactly as both can be said.
TEST_P(WarpedDensities, AreUndoneByTheirCumulativeDistribution)
{
    const WarpTable table(density_);
    const SquarePoints points = random_square_points(2000);
    const PixelPlaces places = reference::warp_points(table, points);
    const auto back = [](std::span<const std::uint64_t> sums, std::uint64_t place) {
        const std::size_t cell = place >> 32;
        const long double part = static_cast<long double>(place % pixel) / pixel;
        const auto weight = static_cast<long double>(sums[cell + 1] - sums[cell]);
        return (static_cast<long double>(sums[cell]) + part * weight) / static_cast<long double>(sums.back());
    };
    const std::size_t stride = std::size_t{table.width} + 1;
    for (std::size_t i = 0; i < places.size(); i += 2) {
        const auto row = std::span(table.sums).subspan((places[i + 1] >> 32) * stride, stride);
        // One step of the place and one of the sum, which has at least 2^40 of them only in the whole picture.
        const auto allowed = [](std::uint64_t total) { return 1.0L / pixel + 1.0L / static_cast<long double>(total); };
        EXPECT_LE(std::abs(back(row, places[i]) - points[i] / 0x1p32L), allowed(row.back())) << i;
        EXPECT_LE(std::abs(back(table.row_sums, places[i + 1]) - points[i + 1] / 0x1p32L), 0x1p-31L) << i;
    }
}

// Oclgrind interprets these as well: see tests/CMakeLists.txt.
INSTANTIATE_TEST_SUITE_P(Small, WarpedDensities,
                         testing::Values(Shape{1, 1}, Shape{7, 5, 1}, Shape{1, 300, 3}, Shape{400, 1},
                                         Shape{64, 33, 128}));
INSTANTIATE_TEST_SUITE_P(Large, WarpedDensities, testing::Values(Shape{16384, 3}, Shape{3, 16384}, Shape{1000, 700}));

TEST(Warp, LeavesConstantDensitiesAsTheyAre)
{
    for (const Shape& shape : {Shape{1, 1}, Shape{64, 32}, Shape{1000, 3}}) {
        const auto pixels = static_cast<std::size_t>(shape.width * shape.height);
        const WarpTable table(density_of(shape.width, shape.height, std::vector<double>(pixels, 0.3)));
        const SquarePoints points = random_square_points(500);
        const PixelPlaces places = reference::warp_points(table, points);
        for (std::size_t i = 0; i < places.size(); ++i)
            EXPECT_EQ(places[i],
                      std::uint64_t{points[i]} * static_cast<std::uint64_t>(i % 2 == 0 ? shape.width : shape.height));
    }
}

TEST(Warp, MovesAllPointsIntoTheOnlyBrightPixel)
{
    std::vector<double> values(30);
    values[2 * 6 + 4] = 5;
    const PixelPlaces places = reference::warp_points(WarpTable(density_of(6, 5, values)), random_square_points(300));
    for (std::size_t i = 0; i < places.size(); i += 2) {
        EXPECT_EQ(places[i] >> 32, 4);
        EXPECT_EQ(places[i + 1] >> 32, 2);
    }
}

/// The left half is four times as dense: four fifths of all points are there, spread by a factor of 5/8.
TEST(Warp, IsLinearInEachHalfOfTwo)
{
    const SquarePoints points = random_square_points(500);
    const PixelPlaces places = reference::warp_points(WarpTable(density_of(2, 1, {4, 1})), points);
    for (std::size_t i = 0; i < points.size(); i += 2) {
        const double u = points[i] / 0x1p32;
        EXPECT_NEAR(static_cast<double>(places[i]) / 0x1p32, u < 0.8 ? u * 5 / 4 : 1 + (u - 0.8) * 5, 0x1p-31);
        EXPECT_EQ(places[i + 1], points[i + 1]);
    }
}

/// The sum of (count - expected)^2 / expected over the pixels.
double spread_of(const Density& density, const SquarePoints& points)
{
    const WarpTable table(density);
    const PixelPlaces places = reference::warp_points(table, points);
    std::vector<double> counts(density.weights.size());
    for (std::size_t i = 0; i < places.size(); i += 2)
        ++counts[(places[i + 1] >> 32) * table.width + (places[i] >> 32)];
    double sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double expected = static_cast<double>(density.weights[i]) / static_cast<double>(table.total()) *
                                static_cast<double>(points.size() / 2);
        sum += (counts[i] - expected) * (counts[i] - expected) / expected;
    }
    return sum;
}

/// The numbers of random points in pixels have the chi-square distribution, those of even points much less.
TEST(Warp, GivesEachPixelItsShare)
{
    std::vector<double> values;
    for (int i = 0; i < 64; ++i) values.push_back(1 + (i * 37) % 64);
    const Density density = density_of(8, 8, values);
    EXPECT_NEAR(spread_of(density, random_square_points(20'000)), 63, 4 * std::sqrt(2 * 63));
    SquarePoints even; // Hammersley's: y is x with its bits reversed
    for (std::uint32_t i = 0; i < 1u << 14; ++i) {
        std::uint32_t reversed = 0;
        for (int bit = 0; bit < 14; ++bit) reversed |= (i >> bit & 1) << (31 - bit);
        even.insert(even.end(), {i << 18, reversed});
    }
    EXPECT_LT(spread_of(density, even), 63.0 / 10);
}

TEST(Warp, GivesCoordinatesInUnitsOfTheLongestSide)
{
    EXPECT_EQ(place_coordinate(3 * pixel + pixel / 2, 4), 0.875);
    // The last place of a picture with one row of the most pixels that there may be.
    const std::uint32_t longest = 1u << 23;
    EXPECT_LT(place_coordinate(longest * pixel - 1, longest), 1);
    EXPECT_EQ(place_coordinate((longest - 1) * pixel, longest), 1 - 0x1p-23);
}

}
}
