// Bounds of densities against all of their pixels.
#include "base/densities/density_bounds.hpp"

#include <gtest/gtest.h>

#include <random>

namespace poissonlab {
namespace {

/// All pixels that a rectangle touches.
std::uint64_t largest_of_all(const Density& density, const DensityPlace& low, const DensityPlace& high)
{
    std::uint64_t largest = 0;
    const auto pixel = [](std::uint32_t c, int count) { return static_cast<int>(c * 0x1p-32 * count); };
    for (int row = pixel(low[1], density.height); row <= pixel(high[1], density.height); ++row)
        for (int column = pixel(low[0], density.width); column <= pixel(high[0], density.width); ++column)
            largest = std::max(largest, density.weights[static_cast<std::size_t>(row * density.width + column)]);
    return largest;
}

TEST(DensityBounds, AreNotBelowAnyPixelAndTightForSmallParts)
{
    std::mt19937 random(3);
    for (const auto& [width, height] : {std::pair(1, 1), {7, 5}, {64, 64}, {33, 100}}) {
        std::vector<double> values;
        for (int i = 0; i < width * height; ++i) values.push_back(static_cast<double>(random() % 1000 + 1));
        const Density density = density_of_values(width, height, values, "test");
        const DensityBounds bounds(density);
        for (int i = 0; i < 2000; ++i) {
            const std::uint32_t reach = i % 2 == 0 ? UINT32_MAX : UINT32_MAX / 50;
            DensityPlace low, high;
            for (std::size_t k = 0; k < 2; ++k) {
                low[k] = static_cast<std::uint32_t>(random());
                high[k] = low[k] + std::min(UINT32_MAX - low[k], static_cast<std::uint32_t>(random()) % reach);
            }
            const std::uint64_t largest = largest_of_all(density, low, high);
            EXPECT_GE(bounds.over(low, high), largest);
            EXPECT_EQ(bounds.over(low, low), bounds.at(low));
            EXPECT_EQ(bounds.at(low), density.at(low[0] * 0x1p-32, low[1] * 0x1p-32));
        }
        EXPECT_EQ(bounds.over({0, 0}, {UINT32_MAX, UINT32_MAX}), full_weight);
    }
}

TEST(DensityBounds, OfNoDensityAreFull)
{
    EXPECT_EQ(DensityBounds().over({0, 5}, {9, UINT32_MAX}), full_weight);
    EXPECT_EQ(DensityBounds().at({1, 2}), full_weight);
}

}
}
