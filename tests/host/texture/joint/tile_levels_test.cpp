// Levelled tiles: means over squares of tilings that chance lays.
#include "host/texture/tile_levels.hpp"

#include "host/texture/seam_blending.hpp"
#include "host/texture/texture_build.hpp"
#include "tests/support/errors.hpp"
#include "tiles/texture/texture_certificate.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace poissonlab {
namespace {

void tell_nobody(const std::string&, std::size_t, std::size_t) {}

/// Spots of 12 pixels, as many bright as dark ones in each square of 24 pixels: means over tiles of 32 pixels hardly
/// differ in the picture, and do in tilings.
PngPixels balanced_spots(int side, int channels)
{
    std::mt19937 random(3);
    PngPixels picture{side, side, channels, {}};
    std::vector<int> swaps;
    for (int i = 0; i < side * side; ++i) swaps.push_back(static_cast<int>(random() % 2));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const int square = y / 24 * side + x / 24,
                      is_bright = (x / 12 + y / 12 + swaps[static_cast<std::size_t>(square)]) % 2;
            for (int c = 0; c < channels; ++c)
                picture.values.push_back(static_cast<std::uint8_t>(90 + 60 * is_bright + random() % 20));
        }
    return picture;
}

TextureRequest level_request(TextureKind kind, Color colors, bool is_joint)
{
    TextureRequest request;
    request.kind = kind;
    request.colors = {colors, colors};
    request.size = 32;
    request.candidates = 2;
    request.attempts = 5;
    request.rounds = 2;
    request.joint = is_joint;
    request.level = false;
    return request;
}

/// The variance of means over squares of so many pixels, one for each step, over the variance of pixels. Sums over
/// channels count.
double square_share(const PngPixels& picture, int size, int step)
{
    const auto variance = [](const std::vector<double>& numbers) {
        double mean = 0, sum = 0;
        for (const double number : numbers) mean += number / static_cast<double>(numbers.size());
        for (const double number : numbers) sum += (number - mean) * (number - mean);
        return sum / static_cast<double>(numbers.size());
    };
    const auto pixel = [&](int x, int y) {
        double sum = 0;
        for (int c = 0; c < picture.channels; ++c) sum += picture.values[picture.at(x, y, c)];
        return sum;
    };
    std::vector<double> pixels, squares;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) pixels.push_back(pixel(x, y));
    for (int top = 0; top + size <= picture.height; top += step)
        for (int left = 0; left + size <= picture.width; left += step) {
            double sum = 0;
            for (int i = 0; i < size * size; ++i) sum += pixel(left + i % size, top + i / size);
            squares.push_back(sum / (size * size));
        }
    return variance(squares) / variance(pixels);
}

double tiling_share(const TextureSet& set, unsigned seed)
{
    const TextureWindow window = texture_window(set, {0, 0, 40, 40}, seed);
    return square_share(texture_window_pixels(set, window, set.values, set.exemplar.channels), set.size, set.size / 2);
}

/// 1,600 tiles are that many independent squares, and more over edges: the variance of normal variates errs by
/// sqrt(2 / 1600) = 3.5 %, and 4 times that here. Once tiles are levelled, little is left but what the form leaves out:
/// of the tiles around a corner, those beside each other share an edge, too. With two colours this is a fifth.
TEST(TileLevels, AreWhatTilingsShow)
{
    for (const bool is_joint : {false, true})
        for (const int channels : {1, 3}) {
            const TextureRequest request = level_request(TextureKind::corner, 2, is_joint);
            TextureSet set = build_texture(request, balanced_spots(150, channels), tell_nobody).set;
            const SquareVariances before = square_variances(set);
            const double shown = tiling_share(set, 1);
            EXPECT_NEAR(before.exemplar, square_share(set.exemplar, 32, 1), 1e-9);
            EXPECT_NEAR(before.tiling, shown, 0.14 * before.tiling);
            level_tiles(set);
            EXPECT_TRUE(set.is_levelled);
            EXPECT_EQ(certify_texture(set).exceptions, 0u);
            certify_changes(set);
            const SquareVariances after = square_variances(set);
            EXPECT_EQ(after.exemplar, before.exemplar);
            EXPECT_NEAR(after.tiling, tiling_share(set, 1), 0.3 * after.tiling);
            if (before.is_uneven()) {
                EXPECT_LT(after.tiling, 0.9 * before.tiling);
                EXPECT_LT(tiling_share(set, 1), 0.9 * shown);
            } else {
                EXPECT_NEAR(after.tiling, before.tiling, 0.01 * before.tiling);
            }
            set.values[9 * 32 + 7] ^= 1;
            EXPECT_THAT(message_of([&] { certify_changes(set); }), testing::HasSubstr("is not its source's, levelled"));
            set.exemplar = balanced_spots(31, channels);
            EXPECT_THAT(message_of([&] { certify_changes(set); }),
                        testing::HasSubstr("levelled sets have an exemplar at least as large as a tile, 32 x 32"));
        }
}

/// Sets are levelled by themselves where tilings differ more than a picture that is four tiles wide.
TEST(TileLevels, ComeWhereTilesDiffer)
{
    TextureRequest request = level_request(TextureKind::corner, 2, true);
    request.level.reset();
    const BuiltTexture built = build_texture(request, balanced_spots(150, 1), tell_nobody);
    EXPECT_TRUE(built.set.is_levelled);
    EXPECT_EQ(built.set.parameters.at("level"), "true");
    EXPECT_THAT(built.notes, testing::Contains(testing::HasSubstr("the light of tiles is levelled")));
    EXPECT_FALSE(build_texture(request, balanced_spots(120, 1), tell_nobody).set.is_levelled);
    request.level = true;
    request.ring = 0;
    request.joint = false;
    request.stages = 1;
    EXPECT_THAT(message_of([&] { check(request); }), testing::HasSubstr("level = true: is for corner and omega tiles"));
}

}
}
