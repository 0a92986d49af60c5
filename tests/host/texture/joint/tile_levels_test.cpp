// Levelled tiles: means over squares of tilings that chance lays.
#include "host/texture/tile_levels.hpp"

#include "host/texture/seam_blending.hpp"
#include "host/texture/texture_build.hpp"
#include "tests/support/errors.hpp"
#include "tiles/texture/texture_certificate.hpp"
#include "tiles/texture/texture_tiling.hpp"
#include "tiles/tilings/tile_index.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

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

/// Means over the four quarters of 16 tiles of two colours, by the colours of their corners: a digit of base 2 for NW,
/// NE, SW and SE. Sums over channels count.
using QuarterMeans = std::array<std::array<double, 4>, 16>;

QuarterMeans plain_quarters(const TextureSet& set)
{
    QuarterMeans quarters{};
    const auto size = static_cast<std::size_t>(set.size), channels = static_cast<std::size_t>(set.exemplar.channels);
    for (std::size_t i = 0; i < set.values.size(); ++i) {
        const std::size_t pixel = i / channels, x = pixel % size, y = pixel / size % size;
        const CornerTile tile = corner_tile(set.tiles[pixel / size / size].index, 2);
        quarters[tile.north_west + 2 * tile.north_east + 4 * tile.south_west + 8 * tile.south_east]
                [(2 * y < size ? 0u : 2u) + (2 * x < size ? 0u : 1u)] +=
            4.0 * set.values[i] / static_cast<double>(size * size);
    }
    return quarters;
}

/// The sum of the quarters that a square over a corner shows. Its four tiles have the first bit there, and three other
/// corners each, as if none of them were shared.
double apart_over_corner(const QuarterMeans& quarters, unsigned bits)
{
    double sum = 0;
    for (unsigned k = 0; k < 4; ++k) {
        const unsigned others = bits >> (1 + 3 * k) & 7, place = 3 - k; // the corner and the quarter that it shows
        const unsigned tile = (others & ((1u << place) - 1)) | (bits & 1) << place | others >> place << (place + 1);
        sum += quarters[tile][place];
    }
    return sum;
}

/// The variance of means over squares without chance: from all 512 ways in which 3 x 3 corners have two colours. Four
/// tiles lie between them, with a square in a tile, one over an edge of each direction, and one over the corner. Tiles
/// around a corner are taken apart if nothing but its own colour joins them.
double enumerated_share(const TextureSet& set, bool are_apart)
{
    const QuarterMeans quarters = plain_quarters(set);
    double sum = 0, squares = 0;
    const auto add = [&](double quarter_sum, double ways) {
        sum += quarter_sum / 4 / (4 * ways);
        squares += quarter_sum * quarter_sum / 16 / (4 * ways);
    };
    for (unsigned bits = 0; bits < 512; ++bits) {
        const auto tile = [&](unsigned x, unsigned y) -> const std::array<double, 4>& {
            const unsigned north = bits >> (3 * y + x) & 3, south = bits >> (3 * y + 3 + x) & 3;
            return quarters[north + 4 * south];
        };
        const auto &a = tile(0, 0), &b = tile(1, 0), &c = tile(0, 1), &d = tile(1, 1);
        add(a[0] + a[1] + a[2] + a[3], 512);
        add(a[1] + a[3] + b[0] + b[2], 512);
        add(a[2] + a[3] + c[0] + c[1], 512);
        if (!are_apart) add(a[3] + b[2] + c[1] + d[0], 512);
    }
    for (unsigned bits = 0; are_apart && bits < 8192; ++bits) add(apart_over_corner(quarters, bits), 8192);
    const auto channels = static_cast<std::size_t>(set.exemplar.channels), pixels = set.values.size() / channels;
    double values = 0, value_squares = 0;
    for (std::size_t i = 0; i < set.values.size(); i += channels) {
        const double value = std::accumulate(&set.values[i], &set.values[i] + channels, 0.0);
        values += value / static_cast<double>(pixels);
        value_squares += value * value / static_cast<double>(pixels);
    }
    return (squares - sum * sum) / (value_squares - values * values);
}

/// The form is what an enumeration of tiles apart gives, to rounding. Tilings are those of an enumeration of all
/// corners: 1,600 tiles are that many independent squares, and more over edges, so that the variance of normal variates
/// errs by sqrt(2 / 1600) = 3.5 %, and 4 times that here. Between the two enumerations lies what the form leaves out:
/// of the tiles around a corner, those beside each other share an edge, too.
TEST(TileLevels, AreWhatTilingsShow)
{
    for (const bool is_joint : {false, true})
        for (const int channels : {1, 3}) {
            const TextureRequest request = level_request(TextureKind::corner, 2, is_joint);
            TextureSet set = build_texture(request, balanced_spots(150, channels), tell_nobody).set;
            const SquareVariances before = square_variances(set);
            const double shown = tiling_share(set, 1);
            EXPECT_NEAR(before.exemplar, square_share(set.exemplar, 32, 1), 1e-9);
            EXPECT_NEAR(before.tiling, enumerated_share(set, true), 1e-9);
            EXPECT_NEAR(shown, enumerated_share(set, false), 0.14 * shown);
            level_tiles(set);
            EXPECT_TRUE(set.is_levelled);
            EXPECT_EQ(certify_texture(set).exceptions, 0u);
            certify_changes(set);
            const SquareVariances after = square_variances(set);
            EXPECT_EQ(after.exemplar, before.exemplar);
            EXPECT_NEAR(after.tiling, enumerated_share(set, true), 1e-9);
            const double left = tiling_share(set, 1);
            EXPECT_NEAR(left, enumerated_share(set, false), 0.14 * left);
            if (before.is_uneven()) {
                EXPECT_LT(after.tiling, 0.9 * before.tiling);
                EXPECT_LT(left, 0.9 * shown);
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
