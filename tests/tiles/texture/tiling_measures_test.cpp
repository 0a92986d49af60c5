// Measures of tilings as pictures, against sums that are written down as their definitions say.
#include "tiles/texture/tiling_measures.hpp"

#include "tests/host/texture/random_picture.hpp"
#include "tests/tiles/texture/dead_leaves.hpp"
#include "tests/tiles/texture/recurrence_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace poissonlab {
namespace {

/// A picture again and again.
PngPixels repeated_picture(const PngPixels& tile, int columns, int rows)
{
    PngPixels picture{columns * tile.width, rows * tile.height, tile.channels, {}};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < tile.channels; ++c)
                picture.values.push_back(tile.values[tile.at(x % tile.width, y % tile.height, c)]);
    return picture;
}

/// The power at a frequency in whole cycles over the picture.
double power_at(const PngPixels& picture, int u, int v)
{
    std::complex<double> sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            sum += static_cast<double>(picture.values[picture.at(x, y, 0)]) *
                   std::polar(1.0, -2 * std::numbers::pi *
                                       (static_cast<double>(u * x) / picture.width +
                                        static_cast<double>(v * y) / picture.height));
    return std::norm(sum);
}

/// Returns the share of the power, without the mean, at frequencies (u, v) for which `counts` is true.
double share_of_power(const PngPixels& picture, const auto& counts)
{
    double counted = 0, all = 0;
    for (int v = 0; v < picture.height; ++v)
        for (int u = 0; u < picture.width; ++u) {
            if (u == 0 && v == 0) continue;
            const double power = power_at(picture, u, v);
            all += power;
            if (counts(u, v)) counted += power;
        }
    return counted / all;
}

TEST(TilingMeasures, LatticePowerIsThatOfTheTransform)
{
    const PngPixels picture = test::random_picture(20, 16, 1, 5);
    const auto is_on_lattice = [](int u, int v) { return u % 5 == 0 && v % 4 == 0; }; // 5 x 4 tiles of 4 pixels
    EXPECT_NEAR(lattice_power(picture, 4, 4), share_of_power(picture, is_on_lattice), 1e-12);
    const auto is_on_other = [](int u, int v) { return u % 4 == 0 && v % 2 == 0; }; // 4 x 2 rectangles of 5 x 8 pixels
    EXPECT_NEAR(lattice_power(picture, 5, 8), share_of_power(picture, is_on_other), 1e-12);
}

TEST(TilingMeasures, LatticePowerIsOneOfOneTileAndSmallOfNoise)
{
    const PngPixels tile = test::random_picture(8, 8, 3, 6);
    EXPECT_NEAR(lattice_power(repeated_picture(tile, 5, 4), 8, 8), 1, 1e-12);
    // 256 independent tiles: 1/256, with 64 squares of Gaussian sums, so a standard error of sqrt(2/64)/256.
    EXPECT_NEAR(lattice_power(test::random_picture(128, 128, 1, 7), 8, 8), 1.0 / 256, 5 * std::sqrt(2.0 / 64) / 256);
    EXPECT_EQ(lattice_power({16, 16, 1, std::vector<std::uint8_t>(256, 9)}, 8, 8), 0);
}

/// Below 1/7: of 20 columns at most 2 cycles, of 16 rows as many.
TEST(TilingMeasures, SlowPowerIsThatOfTheTransform)
{
    const PngPixels picture = test::random_picture(20, 16, 1, 5);
    const auto is_slow = [](int u, int v) {
        return std::hypot(std::min(u, 20 - u) / 20.0, std::min(v, 16 - v) / 16.0) < 1.0 / 7;
    };
    EXPECT_NEAR(slow_power(picture, 7), share_of_power(picture, is_slow), 1e-12);
    EXPECT_EQ(slow_power({16, 16, 1, std::vector<std::uint8_t>(256, 9)}, 4), 0);
    // A tile again and again has no power below its own frequency; a picture of at most two tiles has none to compare.
    EXPECT_NEAR(slow_power(repeated_picture(test::random_picture(8, 8, 3, 6), 5, 4), 16), 0, 1e-12);
    EXPECT_FALSE(slow_powers(picture, picture, 10));
    EXPECT_DOUBLE_EQ(slow_powers(picture, picture, 5)->tiling, slow_power(picture, 10));
}

/// Noise that is `kept` from pixel to pixel along rows and columns: light that changes slowly, with power at all
/// frequencies.
PngPixels slow_picture(int side, double kept, unsigned seed)
{
    PngPixels picture = test::random_picture(side, side, 1, seed);
    const auto wide = static_cast<std::size_t>(side);
    const double scale = 0.5 * (1 - kept * kept);
    std::vector<double> above(wide);
    for (std::size_t y = 0; y < wide; ++y) {
        double west = 0;
        for (std::size_t x = 0; x < wide; ++x) {
            west = kept * west + picture.values[y * wide + x] - 127.5;
            above[x] = kept * above[x] + west;
            picture.values[y * wide + x] = static_cast<std::uint8_t>(std::clamp(127.5 + scale * above[x], 0.0, 255.0));
        }
    }
    return picture;
}

/// Pictures of one law have the same share whatever their sizes are: differences of independent pairs have the mean 0,
/// within four of its standard errors. Means are compared because the ratio of a pair has a mean above 1.
TEST(TilingMeasures, SlowPowersOfOneLawAreTheSame)
{
    constexpr int pairs = 48;
    struct Case
    {
        int size, side;
    };
    for (const double kept : {0.0, 0.9})
        for (const auto& [size, side] : {Case{32, 256}, {64, 256}, {64, 512}, {128, 512}}) {
            double own = 0, sum = 0, squares = 0;
            for (unsigned pair = 0; pair < pairs; ++pair) {
                const auto found = slow_powers(slow_picture(2 * side, kept, 2 * pair + 1),
                                               slow_picture(side, kept, 2 * pair + 2), size);
                ASSERT_TRUE(found);
                own += found->exemplar / pairs;
                const double difference = found->tiling - found->exemplar;
                sum += difference;
                squares += difference * difference;
            }
            const double mean = sum / pairs, error = std::sqrt((squares / pairs - mean * mean) / (pairs - 1));
            EXPECT_LT(std::abs(mean), 4 * error) << kept << " " << size << " " << side;
            EXPECT_LT(error, 0.1 * own) << "differences of 40 % would be seen";
        }
}

/// The larger picture is measured by parts that are as large as the smaller one and cover it.
TEST(TilingMeasures, SlowPowersAreThoseOfParts)
{
    const PngPixels large = slow_picture(50, 0.9, 1), small = slow_picture(20, 0.9, 2);
    double sum = 0;
    for (const int top : {0, 15, 30})
        for (const int left : {0, 15, 30}) {
            PngPixels part{20, 20, 1, {}};
            for (int y = 0; y < 20; ++y)
                for (int x = 0; x < 20; ++x) part.values.push_back(large.values[large.at(left + x, top + y, 0)]);
            sum += slow_power(part, 8);
        }
    const auto of_large = slow_powers(large, small, 4), of_small = slow_powers(small, large, 4);
    ASSERT_TRUE(of_large && of_small);
    EXPECT_DOUBLE_EQ(of_large->tiling, sum / 9);
    EXPECT_DOUBLE_EQ(of_large->exemplar, slow_power(small, 8));
    EXPECT_DOUBLE_EQ(of_small->exemplar, sum / 9);
    EXPECT_DOUBLE_EQ(of_small->tiling, slow_power(small, 8));
    EXPECT_FALSE(slow_powers(small, large, 10));
}

/// Three tiles in any order, as recurrence.py lays them.
PngPixels three_tiles(int channels)
{
    test::PlainRandom random(static_cast<std::uint32_t>(channels));
    std::vector<PngPixels> tiles(3, PngPixels{7, 5, channels, {}});
    for (PngPixels& tile : tiles)
        for (int i = 0; i < 35 * channels; ++i) tile.values.push_back(static_cast<std::uint8_t>(random.next() % 256));
    PngPixels picture{9 * 7, 6 * 5, channels, std::vector<std::uint8_t>(static_cast<std::size_t>(54 * 35 * channels))};
    for (int place = 0; place < 54; ++place) {
        const PngPixels& tile = tiles[static_cast<std::size_t>(random.next() % 3)];
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 7; ++x)
                for (int c = 0; c < channels; ++c)
                    picture.values[picture.at(place % 9 * 7 + x, place / 9 * 5 + y, c)] = tile.values[tile.at(x, y, c)];
    }
    return picture;
}

TEST(TilingMeasures, RecurrenceIsThatOfAnotherProgram)
{
    for (const int channels : {1, 3}) {
        const double* const theirs = recurrence_numbers[channels == 1 ? 0 : 1];
        const PngPixels picture = three_tiles(channels);
        EXPECT_NEAR(*recurrence(picture, 7, 5), theirs[0], 1e-12);
        EXPECT_NEAR(*recurrence(picture, 21, 10), theirs[1], 1e-12);
    }
}

/// White noise does not recur: (P - 1) frequencies of the lattice have the mean power of all, so that their share
/// has a relative standard error of sqrt(2 / (P - 1)), whatever the number of squares is. Plain repetition is 1.
TEST(TilingMeasures, RecurrenceIsZeroOfNoiseAndOneOfACopy)
{
    for (const int squares : {2, 3, 8, 32}) {
        constexpr int pictures = 40;
        double sum = 0;
        for (unsigned seed = 0; seed < pictures; ++seed)
            sum += *recurrence(test::random_picture(8 * squares, 8 * squares, 1, 100 * seed + 1), 8, 8);
        const double chance = 63.0 / (64.0 * squares * squares - 1);
        EXPECT_NEAR(sum / pictures, 0, 4 * chance / (1 - chance) * std::sqrt(2.0 / 63 / pictures)) << squares;
        const PngPixels tile = test::random_picture(8, 8, 3, 11);
        EXPECT_NEAR(*recurrence(repeated_picture(tile, squares, squares), 8, 8), 1, 1e-12);
    }
}

TEST(TilingMeasures, RecurrenceNeedsTwoSquaresAndPower)
{
    const PngPixels noise = test::random_picture(31, 16, 1, 12);
    EXPECT_FALSE(recurrence(noise, 16, 16));
    EXPECT_FALSE(recurrence(noise, 32, 8));
    EXPECT_TRUE(recurrence(noise, 15, 16));
    EXPECT_FALSE(recurrence({16, 16, 1, std::vector<std::uint8_t>(256, 9)}, 8, 8)) << "no power";
}

/// Two pictures with as many pixels: the distance is the mean difference of their sorted values.
TEST(TilingMeasures, ColorDistanceIsThatOfSortedValues)
{
    const PngPixels one = test::random_picture(31, 17, 1, 8, 200), other = test::random_picture(17, 31, 1, 9);
    std::vector<std::uint8_t> a = one.values, b = other.values;
    std::ranges::sort(a);
    std::ranges::sort(b);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    EXPECT_NEAR(color_distance(one, other), sum / static_cast<double>(a.size()), 1e-9);
    EXPECT_EQ(color_distance(one, one), 0);
}

TEST(TilingMeasures, StepsAreOverThoseOfTheExemplar)
{
    // Steps of 2 everywhere but for those from tile to tile, which are 8 to the east and 4 to the south.
    PngPixels tile{4, 4, 1, {}};
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) tile.values.push_back(static_cast<std::uint8_t>(100 + 2 * x + 2 * y));
    PngPixels tiling = repeated_picture(tile, 3, 3);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x)
            tiling.values[tiling.at(x, y, 0)] += static_cast<std::uint8_t>(14 * (x / 4) + 10 * (y / 4));
    const StepMap map = step_map(tiling, tile, 4);
    EXPECT_DOUBLE_EQ(map.border, (8.0 / 2 + 4.0 / 2) / 2);
    EXPECT_DOUBLE_EQ(map.largest, 4);
    EXPECT_DOUBLE_EQ(map.steps[0], 1);
    EXPECT_DOUBLE_EQ(map.steps[3], (4.0 + 1) / 2);
}

}
}
