// Seams of sets whose joints are known: in noise they cannot be told, and ramps have them where they must be.
#include "tiles/texture/seam_measures.hpp"

#include "tests/tiles/texture/quartered_set.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

PngPixels white_noise(int width, int height, int channels)
{
    PngPixels noise{width, height, channels, {}};
    std::mt19937 random(17);
    for (int i = 0; i < width * height * channels; ++i) noise.values.push_back(static_cast<std::uint8_t>(random()));
    return noise;
}

/// Uncut joints of noise are steps like all others. A share of n = 2 x 32 x 625 pairs, of which each joint is that of
/// 25 others, has an error of sqrt(0.05 x 0.95 / 1600) = 0.0054; a mean difference of bytes, 85, one of 0.71 /
/// sqrt(1600).
TEST(SeamMeasures, CannotTellJointsOfNoise)
{
    for (const int channels : {1, 3}) {
        const TextureSet set = test::quartered_set(white_noise(200, 200, channels), 32,
                                                   {{10, 10}, {100, 20}, {30, 140}, {150, 120}, {80, 80}});
        const SeamMeasures seams = seam_measures(set);
        EXPECT_EQ(seams.pairs_a_tile, 4 * 16);
        // The line in the middle, of 31.
        EXPECT_DOUBLE_EQ(seams.largest_line, 1);
        EXPECT_DOUBLE_EQ(seams.mean_line, 1.0 / 31);
        EXPECT_EQ(seams.longest_line, 32);
        EXPECT_NEAR(seams.mismatch, 1, 4 * 0.71 / 40);
        EXPECT_NEAR(seams.conspicuous, seams.natural, 4 * 0.0054);
        EXPECT_LE(seams.natural, 0.05);
        EXPECT_GT(seams.natural, 0.04);
    }
}

/// On a ramp of one level a column, windows that are 30 columns apart differ by 30 steps of the ramp everywhere. Rows
/// do not differ, and joints between them have no natural step that they could be compared with.
TEST(SeamMeasures, KnowRamps)
{
    PngPixels ramp{100, 60, 1, {}};
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 100; ++x) ramp.values.push_back(static_cast<std::uint8_t>(x));
    TextureSet set = test::quartered_set(ramp, 16, {{20, 20}, {50, 20}});
    // The only tile with colour 0 in the west and 1 in the east.
    const std::size_t tile = corner_index({1, 1, 0, 0}, 2);
    const auto sources = set.sources_of(tile);
    set.sources = {sources.begin(), sources.end()};
    set.tiles = {set.tiles[tile]};
    const SeamMeasures seams = seam_measures(set);
    EXPECT_EQ(seams.pairs_a_tile, 2 * 16);
    // The border goes from column 20 + 15 to 50 + 0: where one goes on to 36, the other shows 50.
    EXPECT_DOUBLE_EQ(seams.mismatch, 14);
    EXPECT_DOUBLE_EQ(seams.excess, 14);
    // Vertical joints are conspicuous, horizontal ones are no steps at all; the line is as long as the tile.
    EXPECT_DOUBLE_EQ(seams.conspicuous, 0.5);
    EXPECT_EQ(seams.longest_run, 16);
    EXPECT_EQ(seams.longest_line, 16);
    EXPECT_DOUBLE_EQ(seams.largest_line, 1);
    EXPECT_DOUBLE_EQ(seams.coverage, 16.0 * 16 / 6000);
}

/// A window is no seam anywhere.
TEST(SeamMeasures, AreNoneInsideOfAWindow)
{
    TextureSet set;
    set.size = 8;
    set.exemplar = white_noise(30, 30, 1);
    set.tiles = {{0, 0}};
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            set.sources.push_back({static_cast<std::uint16_t>(x + 5), static_cast<std::uint16_t>(y + 9)});
    const SeamMeasures seams = seam_measures(set);
    EXPECT_EQ(seams.pairs_a_tile, 0);
    EXPECT_EQ(seams.mismatch, 0);
    EXPECT_EQ(seams.longest_run, 0);
    EXPECT_EQ(seams.longest_line, 0);
    EXPECT_EQ(seams.largest_line, 0);
}

}
}
