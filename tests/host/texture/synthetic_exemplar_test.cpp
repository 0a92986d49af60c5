// Exemplars that are made: what is known of each.
#include "host/texture/synthetic_exemplar.hpp"

#include "host/texture/exemplar.hpp"
#include "tests/support/places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>

namespace poissonlab {
namespace {

/// Coordinates on a lattice, which are as good as any here.
std::vector<std::uint32_t> lattice_places()
{
    std::vector<std::uint32_t> places;
    for (std::uint32_t i = 0; i < 16; ++i) {
        places.push_back(i % 4 << 30);
        places.push_back(i / 4 << 30);
    }
    return places;
}

TEST(SyntheticExemplar, FollowsFromItsSeed)
{
    const auto places = lattice_places();
    for (const std::string& pattern : exemplar_patterns()) {
        const PngPixels one = synthetic_exemplar(pattern, 48, 1, places);
        EXPECT_EQ(one.width, 48);
        EXPECT_EQ(one.values.size(), 48u * 48);
        EXPECT_EQ(synthetic_exemplar(pattern, 48, 1, places).values, one.values);
        const bool is_random = pattern != "ramp" && pattern != "checkerboard";
        EXPECT_EQ(synthetic_exemplar(pattern, 48, 2, places).values != one.values, is_random) << pattern;
    }
}

/// Independent bytes, even from 0 to 255: two of them differ by (256^2 - 1) / (3 * 256) on average.
TEST(SyntheticExemplar, NoiseHasTheStepOfIndependentBytes)
{
    const PngPixels noise = synthetic_exemplar("noise", 256, 3, {});
    double sum = 0;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 255; x += 2)
            sum += std::abs(noise.values[noise.at(x, y, 0)] - noise.values[noise.at(x + 1, y, 0)]);
    // 32,768 independent differences, each with a standard deviation of 60.3.
    EXPECT_NEAR(sum / 32768, 85.33, 4 * 60.3 / std::sqrt(32768.0));
}

/// configs/exemplars/README.md says so.
TEST(SyntheticExemplar, IsWhatShipsAsFabricAndClouds)
{
    for (const std::string name : {"fabric", "clouds"})
        EXPECT_EQ(read_exemplar(source_folder() + "/configs/exemplars/" + name + ".png").values,
                  synthetic_exemplar(name, 256, 1, {}).values)
            << name;
}

/// Threads of 8 pixels change place after as many: light is the other way round there, and the same after 16.
TEST(SyntheticExemplar, FabricIsAPlainWeave)
{
    const PngPixels fabric = synthetic_exemplar("fabric", 256, 1, {});
    const auto correlation = [&](int lag) {
        double sum = 0, squares = 0, mean = 0;
        for (const std::uint8_t value : fabric.values) mean += value;
        mean /= 256.0 * 256;
        for (int y = 0; y < 256 - lag; ++y)
            for (int x = 0; x < 256; ++x) {
                const double here = fabric.values[fabric.at(x, y, 0)] - mean;
                sum += here * (fabric.values[fabric.at(x, y + lag, 0)] - mean);
                squares += here * here;
            }
        return sum / squares;
    };
    EXPECT_GT(correlation(16), correlation(8) + 0.1);
}

/// Steps over 32 pixels are larger than those over 1 by far, as of noise whose octaves have 5/8 of the amplitude each.
TEST(SyntheticExemplar, CloudsHaveNothingSmall)
{
    const PngPixels clouds = synthetic_exemplar("clouds", 256, 1, {});
    const auto step = [&](int lag) {
        double sum = 0;
        for (int y = 0; y < 256; ++y)
            for (int x = 0; x < 256 - lag; ++x)
                sum += std::abs(clouds.values[clouds.at(x, y, 0)] - clouds.values[clouds.at(x + lag, y, 0)]);
        return sum / (256.0 * (256 - lag));
    };
    EXPECT_GT(step(32), 6 * step(1));
}

TEST(SyntheticExemplar, CheckerboardRepeatsAfterSixteenPixels)
{
    const PngPixels board = synthetic_exemplar("checkerboard", 64, 1, {});
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 48; ++x) {
            EXPECT_EQ(board.values[board.at(x, y, 0)], board.values[board.at(x + 16, y + 16, 0)]);
            EXPECT_NE(board.values[board.at(x, y, 0)], board.values[board.at(x + 8, y, 0)]);
        }
}

TEST(SyntheticExemplar, RampGrowsFromBlackToWhite)
{
    const PngPixels ramp = synthetic_exemplar("ramp", 52, 1, {});
    for (int x = 0; x < 52; ++x) EXPECT_EQ(ramp.values[ramp.at(x, 20, 0)], 5 * x);
}

/// A pebble a point: the middle of each is lighter than its rim half-way to the next one.
TEST(SyntheticExemplar, PebblesAreDarkBetweenPoints)
{
    const PngPixels pebbles = synthetic_exemplar("pebbles", 64, 1, lattice_places());
    for (int y = 0; y < 64; y += 16)
        for (int x = 0; x < 64; x += 16)
            EXPECT_GT(pebbles.values[pebbles.at(x, y, 0)], pebbles.values[pebbles.at(x + 7, y, 0)] + 30);
}

}
}
