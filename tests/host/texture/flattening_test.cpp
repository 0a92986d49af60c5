// Flattened pictures against the Gaussian's double sum, and ramps of light that have to go.
#include "host/texture/flattening.hpp"

#include "host/texture/exemplar_pictures.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tiles/texture/tiling_judge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

PngPixels picture_of(int width, int height, const auto& value)
{
    PngPixels picture{width, height, 1, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.values.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(value(x, y)), 0L, 255L)));
    return picture;
}

double mean_of(const PngPixels& picture)
{
    return std::accumulate(picture.values.begin(), picture.values.end(), 0.0) /
           static_cast<double>(picture.values.size());
}

/// The mean around a pixel by weights of a Gaussian, by its definition.
double blurred(const PngPixels& picture, int x, int y, double sigma)
{
    double sum = 0, weights = 0;
    for (int j = 0; j < picture.height; ++j)
        for (int i = 0; i < picture.width; ++i) {
            const double weight = std::exp(-((i - x) * (i - x) + (j - y) * (j - y)) / (2 * sigma * sigma));
            sum += weight * picture.values[picture.at(i, j, 0)];
            weights += weight;
        }
    return sum / weights;
}

/// 6 sigma = 48 pixels from the rim the line that fits best has the Gaussian's mean. Errors: half a level of rounding,
/// and sigma^2 / 8 of 255 / sigma^2 / 64 between places.
TEST(Flattening, SubtractsAGaussiansMean)
{
    const PngPixels picture = picture_of(140, 120, [](int x, int y) { return x * x / 80 % 200 + (y > 70 ? 50 : 0); });
    std::size_t clipped = 0;
    const PngPixels flat = flattened(picture, 16, clipped);
    for (const auto& [x, y] : {std::pair(50, 50), std::pair(61, 71), std::pair(90, 57), std::pair(77, 64)}) {
        const double expected = picture.values[picture.at(x, y, 0)] - blurred(picture, x, y, 8) + mean_of(picture);
        ASSERT_TRUE(expected > 0 && expected < 255);
        EXPECT_NEAR(flat.values[flat.at(x, y, 0)], expected, 0.75) << x << " " << y;
    }
}

/// Linear: a picture with a ramp becomes what it becomes without, up to its rim; both are rounded twice.
TEST(Flattening, RemovesARampOfLight)
{
    const PngPixels noise = test::random_picture(90, 70, 1, 5, 80);
    const PngPixels even = picture_of(90, 70, [&](int x, int y) { return 60 + noise.values[noise.at(x, y, 0)]; });
    const auto light = [](int x, int y) { return 0.9 * x + 0.3 * y; };
    const PngPixels ramped =
        picture_of(90, 70, [&](int x, int y) { return light(x, y) + even.values[even.at(x, y, 0)]; });
    std::size_t clipped = 0;
    const PngPixels from_even = flattened(even, 16, clipped), from_ramped = flattened(ramped, 16, clipped);
    const double more = mean_of(ramped) - mean_of(even);
    EXPECT_EQ(clipped, 0u);
    for (std::size_t i = 0; i < even.values.size(); ++i)
        ASSERT_NEAR(from_ramped.values[i] - from_even.values[i], more, 1.5);
}

TEST(Flattening, CountsWhatItClips)
{
    // White beside black: in the middle both sides are moved by a half of the step towards each other's mean, and far
    // away to the mean; single pixels of the other colour go beyond.
    const PngPixels picture =
        picture_of(128, 64, [](int x, int y) { return (x < 64) != (x % 40 == 20 && y % 8 == 4) ? 0 : 255; });
    std::size_t clipped = 0;
    const PngPixels flat = flattened(picture, 16, clipped);
    EXPECT_GT(clipped, 0u);
    EXPECT_LE(clipped, static_cast<std::size_t>(std::ranges::count_if(
                           flat.values, [](std::uint8_t value) { return value == 0 || value == 255; })));
}

template <class Sample>
RawPicture raw_ramp(SampleType type, int width, int height, double scale)
{
    RawPicture picture{width, height, type, {"Y", "A"}, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const double value : {scale * (100 + x + 2 * y), scale * x}) {
                const auto sample = static_cast<Sample>(value);
                const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&sample);
                picture.bytes.insert(picture.bytes.end(), bytes, bytes + sizeof(Sample));
            }
    return picture;
}

template <class Sample>
Sample sample_at(const RawPicture& picture, std::size_t i)
{
    Sample sample{};
    std::memcpy(&sample, &picture.bytes[i * sizeof(Sample)], sizeof(Sample));
    return sample;
}

/// The mean of a ramp is that of its ends; alpha stays.
TEST(Flattening, IsOfAllNumbersButAlpha)
{
    const RawPicture words = raw_ramp<std::uint16_t>(SampleType::word, 33, 40, 50),
                     reals = raw_ramp<float>(SampleType::real, 33, 40, 0.01);
    std::size_t clipped = 0;
    const RawPicture flat_words = flattened(words, 16, clipped), flat_reals = flattened(reals, 16, clipped);
    for (std::size_t i = 0; i < 2 * 33 * 40; i += 2) {
        ASSERT_NEAR(sample_at<std::uint16_t>(flat_words, i), 50 * (100 + 16 + 39), 0.51);
        ASSERT_NEAR(sample_at<float>(flat_reals, i), 1.55, 1e-5);
        ASSERT_EQ(sample_at<std::uint16_t>(flat_words, i + 1), sample_at<std::uint16_t>(words, i + 1));
        ASSERT_EQ(sample_at<float>(flat_reals, i + 1), sample_at<float>(reals, i + 1));
    }
}

/// Depths, which are no colours, stay bit for bit, even where they are not finite; no light becomes negative, and what
/// was negative may remain so.
TEST(Flattening, IsOfShownLightAlone)
{
    RawPicture picture{32, 32, SampleType::real, {"R", "G", "B", "x.A", "Z"}, {}};
    for (int i = 0; i < 32 * 32; ++i) {
        const float light = i % 32 < 16 ? 2.0f : i % 7 != 0 ? 20.0f : 0.0f;
        const float depth = i % 5 == 0 ? std::numeric_limits<float>::infinity() : static_cast<float>(i);
        for (const float value : {light, light - 30, light, static_cast<float>(i), depth}) {
            const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&value);
            picture.bytes.insert(picture.bytes.end(), bytes, bytes + sizeof(float));
        }
    }
    std::size_t clipped = 0, zeros = 0, negative = 0;
    const RawPicture flat = flattened(picture, 16, clipped);
    for (std::size_t i = 0; i < 5 * 32 * 32; ++i) {
        const float value = sample_at<float>(flat, i);
        if (i % 5 >= 3) {
            ASSERT_EQ(value, sample_at<float>(picture, i)) << i;
        } else if (i % 5 != 1) {
            ASSERT_GE(value, 0) << i;
        }
        zeros += i % 5 != 1 && i % 5 < 3 && value == 0;
        negative += i % 5 == 1 && value < 0;
    }
    EXPECT_GT(clipped, 0u);
    EXPECT_EQ(clipped, zeros);
    EXPECT_GT(negative, 0u);
}

/// Noise through a Gaussian of standard deviation s / sqrt(2), by its definition: its correlation is exp(-d^2 / 2 s^2).
PngPixels gaussian_texture(int side, double s, unsigned seed)
{
    const PngPixels noise = test::random_picture(side, side, 1, seed);
    const double sigma = s / std::numbers::sqrt2;
    const int reach = static_cast<int>(std::ceil(4 * sigma));
    std::vector<double> rows(noise.values.begin(), noise.values.end()), both(rows.size());
    const auto wrapped = [&](int i) { return (i + side) % side; };
    const auto pass = [&](const std::vector<double>& from, std::vector<double>& to) { // and turned
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                double sum = 0;
                for (int d = -reach; d <= reach; ++d)
                    sum += std::exp(-d * d / (2 * sigma * sigma)) *
                           (from[static_cast<std::size_t>(y * side + wrapped(x + d))] - 127.5);
                to[static_cast<std::size_t>(x * side + y)] = sum;
            }
    };
    pass(rows, both);
    for (double& value : both) value += 127.5;
    pass(both, rows);
    // The variance of uniform bytes is 65535 / 12; that of the sum is by the sum of squares of the weights.
    const double gain = 40 / (std::sqrt(65535 / 12.0) * std::numbers::pi * sigma * sigma);
    return picture_of(side, side,
                      [&](int x, int y) { return 127.5 + gain * rows[static_cast<std::size_t>(y * side + x)] / 2; });
}

/// The closed form of what a texture has by chance. 8 textures with 44 frequencies of one power each: a relative
/// standard error of sqrt(2 / 352).
TEST(Flattening, KnowsWhatTextureHasByChance)
{
    double share = 0, by_chance = 0;
    for (unsigned seed = 0; seed < 8; ++seed) {
        const PngPixels picture = gaussian_texture(256, 3, seed);
        const UnevenLight light = uneven_light(picture, 32);
        EXPECT_FALSE(light.is_uneven()) << seed << " " << light.share << " " << light.by_chance;
        share += light.share / 8;
        by_chance += light.by_chance / 8;
    }
    EXPECT_NEAR(share / by_chance, 1, 5 * std::sqrt(2.0 / 352) + 0.1); // a whole number of pixels as side: 10 %
}

/// Pictures of more than 2^20 pixels are measured by means over boxes of two pixels. All pixels are the oracle; the
/// tolerances are those of flattening.hpp. Stripes of nearly two pixels are the worst case, because they become slow in
/// the means.
TEST(Flattening, MeasuresLargePicturesByMeans)
{
    constexpr int side = 1100;
    const PngPixels texture = gaussian_texture(side, 3, 1);
    const auto with_waves = [&](double periods, double amplitude) {
        return picture_of(side, side, [&](int x, int y) {
            const double phase = 2 * std::numbers::pi * periods * (x + 0.3 * y) / side;
            return texture.values[texture.at(x, y, 0)] + amplitude * std::cos(phase);
        });
    };
    for (const auto& [periods, amplitude] : {std::pair(0.0, 0.0), {14.0, 15.0}, {3.5, 15.0}, {side / 2.0 - 16, 40.0}}) {
        const PngPixels picture = with_waves(periods, amplitude);
        const double share = slow_power(picture, 64);
        EXPECT_EQ(share > 0.1, amplitude == 15) << periods;
        const UnevenLight light = uneven_light(picture, 32);
        EXPECT_NEAR(light.share, share, 0.004 * share + 0.0011) << periods;
        std::size_t clipped = 0;
        EXPECT_NEAR(std::sqrt(light.by_chance / 0.89) * 32, feature_side(flattened(picture, 32, clipped)), 1)
            << periods;
    }
}

TEST(Flattening, SeesARamp)
{
    const PngPixels noise = test::random_picture(200, 180, 1, 5, 150);
    const auto is_uneven = [](const PngPixels& picture) { return uneven_light(picture, 32).is_uneven(); };
    EXPECT_FALSE(is_uneven(noise));
    EXPECT_TRUE(
        is_uneven(picture_of(200, 180, [&](int x, int y) { return x * 0.4 + noise.values[noise.at(x, y, 0)]; })));
    EXPECT_FALSE(is_uneven(PngPixels{100, 100, 1, std::vector<std::uint8_t>(10000, 77)}));
}

/// The program flattens as asked and says so; a picture of one colour stays as it is.
TEST(Flattening, DoesWhatIsAskedFor)
{
    ExemplarPictures pictures;
    pictures.exemplar = picture_of(200, 180, [](int x, int y) { return 0.8 * x + (x * y % 7) * 12; });
    const PngPixels before = pictures.exemplar;
    flatten(pictures, 32, false);
    EXPECT_FALSE(pictures.is_flattened);
    EXPECT_EQ(pictures.exemplar.values, before.values);
    EXPECT_EQ(pictures.notes.size(), 1u); // which says what could be done
    flatten(pictures, 32, {});
    EXPECT_TRUE(pictures.is_flattened);
    EXPECT_NE(pictures.exemplar.values, before.values);
    ExemplarPictures plain;
    plain.exemplar = picture_of(40, 40, [](int, int) { return 9; });
    flatten(plain, 32, {});
    EXPECT_FALSE(plain.is_flattened);
    flatten(plain, 32, true);
    EXPECT_EQ(plain.exemplar.values, std::vector<std::uint8_t>(1600, 9));
    flatten(plain, 64, true); // smaller than a tile: building says so
}

}
}
