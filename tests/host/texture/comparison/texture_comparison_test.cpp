// Comparisons of textures with their exemplar: pictures are spoiled on purpose, each in one way, and each measure moves
// where it must; a texture that cannot be told from its exemplar has the exemplar's own spread.
#include "host/texture/comparison/texture_comparison.hpp"

#include "host/texture/comparison/steerable_pyramid.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

constexpr int exemplar_side = 192, texture_side = 384;

/// Disks with soft rims on grey, at random: edges in all directions, and no end.
PngPixels disk_picture(int side, unsigned seed)
{
    std::mt19937 random(seed);
    PngPixels picture{side, side, 1, std::vector<std::uint8_t>(static_cast<std::size_t>(side * side), 90)};
    for (int i = 0; i < side * side / 60; ++i) {
        const int x = static_cast<int>(random() % static_cast<unsigned>(side)),
                  y = static_cast<int>(random() % static_cast<unsigned>(side)),
                  radius = 3 + static_cast<int>(random() % 5), grey = 40 + static_cast<int>(random() % 160);
        for (int dy = -radius; dy <= radius; ++dy)
            for (int dx = -radius; dx <= radius; ++dx)
                if (dx * dx + dy * dy <= radius * radius)
                    picture.values[picture.at((x + dx + side) % side, (y + dy + side) % side, 0)] =
                        static_cast<std::uint8_t>(grey);
    }
    return picture;
}

template <class Value>
PngPixels changed(const PngPixels& picture, const Value& value)
{
    PngPixels result = picture;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            result.values[result.at(x, y, 0)] = static_cast<std::uint8_t>(std::clamp(value(x, y), 0.0, 255.0));
    return result;
}

/// Values at (x, y), around which the picture goes on as its own other side.
double value_at(const PngPixels& picture, int x, int y)
{
    return picture.values[picture.at((x + picture.width) % picture.width, (y + picture.height) % picture.height, 0)];
}

PngPixels blurred(const PngPixels& picture)
{
    return changed(picture, [&](int x, int y) {
        double sum = 0;
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) sum += value_at(picture, x + i, y + j);
        return sum / 9;
    });
}

TextureComparison compared(const PngPixels& texture)
{
    return compare_texture(
        disk_picture(exemplar_side, 1), [&](int side) { return picture_part(texture, 0, 0, side, side); },
        texture_side);
}

const PngPixels& natural_texture()
{
    static const PngPixels picture = disk_picture(texture_side, 2);
    return picture;
}

double times(double WindowDistances::*distance, const TextureComparison& comparison)
{
    return comparison.distances.*distance / (comparison.own.*distance);
}

const TextureComparison& natural_comparison()
{
    static const TextureComparison comparison = compared(natural_texture());
    return comparison;
}

/// By how many times more than the natural texture's.
double times_natural(double WindowDistances::*distance, const TextureComparison& comparison)
{
    return times(distance, comparison) / times(distance, natural_comparison());
}

/// Another picture by the same law: distances are those of the exemplar's windows from each other, and repetition is
/// what chance gives. Of sixteen windows and four, a ratio of 1.5 is far out.
TEST(TextureComparison, FindsNothingInWhatIsNatural)
{
    const TextureComparison& natural = natural_comparison();
    for (const auto distance : {&WindowDistances::colors, &WindowDistances::contrast, &WindowDistances::gradients}) {
        EXPECT_LT(times(distance, natural), 1.5);
        EXPECT_GT(times(distance, natural), 0.5);
    }
    EXPECT_LT(structure_times(natural), 1.3);
    EXPECT_GT(structure_times(natural), 0.7);
    EXPECT_NEAR(natural.contrast, 1, 0.05);
    EXPECT_LT(natural.peak, 1.4 * natural.chance_peak);
    EXPECT_GT(natural.peak, 0.5 * natural.chance_peak);
    EXPECT_LT(natural.contrast_peak, 1.6 * natural.chance_contrast_peak);
}

TEST(TextureComparison, FindsBlur)
{
    const TextureComparison blur = compared(blurred(natural_texture()));
    EXPECT_LT(blur.contrast, 0.9);
    EXPECT_GT(times(&WindowDistances::gradients, blur), 5);
    EXPECT_GT(times(&WindowDistances::contrast, blur), 2);
    EXPECT_GT(structure_times(blur), 1.25 * structure_times(natural_comparison()));
}

TEST(TextureComparison, FindsLostContrast)
{
    const PngPixels& natural = natural_texture();
    const TextureComparison lost =
        compared(changed(natural, [&](int x, int y) { return 110 + 0.7 * (value_at(natural, x, y) - 110); }));
    EXPECT_NEAR(lost.contrast, 0.7, 0.05);
    EXPECT_GT(times(&WindowDistances::colors, lost), 2);
    EXPECT_GT(times_natural(&WindowDistances::contrast, lost), 2);
    EXPECT_NEAR(structure_times(lost), structure_times(natural_comparison()), 0.02)
        << "correlations know of no contrast";
    EXPECT_LT(lost.peak, 1.4 * lost.chance_peak);
}

TEST(TextureComparison, FindsRepetition)
{
    const PngPixels& natural = natural_texture();
    const TextureComparison tiled =
        compared(changed(natural, [&](int x, int y) { return value_at(natural, x % 64, y % 64); }));
    EXPECT_NEAR(tiled.peak, 1, 0.02);
    // Half of each pixel is the same in all tiles: a correlation of a half, or so.
    const TextureComparison half = compared(changed(natural, [&](int x, int y) {
        return 110 + (value_at(natural, x % 64, y % 64) + value_at(natural, x, y) - 220) / std::numbers::sqrt2;
    }));
    EXPECT_NEAR(half.peak, 0.5, 0.1);
    EXPECT_GT(half.peak, 3 * half.chance_peak);
}

/// Contrast that comes and goes on a lattice: blending does that.
TEST(TextureComparison, FindsALatticeOfContrast)
{
    const PngPixels& natural = natural_texture();
    const TextureComparison lattice = compared(changed(natural, [&](int x, int y) {
        const double wave = std::cos(2 * std::numbers::pi * x / 64) + std::cos(2 * std::numbers::pi * y / 64);
        return 110 + (1 + 0.4 * wave) * (value_at(natural, x, y) - 110);
    }));
    EXPECT_GT(lattice.contrast_peak, 1.5 * natural_comparison().contrast_peak);
    EXPECT_GT(lattice.contrast_peak, 2 * lattice.chance_contrast_peak);
    EXPECT_GT(times_natural(&WindowDistances::contrast, lattice), 1.25) << "also where the mean is right";
}

/// Phases at random: the same power spectrum, the histogram nearly, and no disks.
TEST(TextureComparison, FindsLostStructure)
{
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    // Noise that is blurred and sharpened to steps like those of disks: no edges.
    PngPixels noise{texture_side, texture_side, 1, {}};
    for (int i = 0; i < texture_side * texture_side; ++i)
        noise.values.push_back(static_cast<std::uint8_t>(std::clamp(110 + 60 * normal(random), 0.0, 255.0)));
    const PngPixels smooth = blurred(blurred(noise));
    const TextureComparison lost =
        compared(changed(smooth, [&](int x, int y) { return 110 + 4 * (value_at(smooth, x, y) - 110); }));
    EXPECT_GT(structure_times(lost), 2);
}

/// A wave along x has all its magnitude in the first orientation, at the scale of its octave.
TEST(SteerablePyramid, TellsOrientationsAndScalesApart)
{
    LightMap wave{64, 64, {}};
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) wave.values.push_back(std::cos(2 * std::numbers::pi * x / 8));
    const std::vector<LightMap> magnitudes = pyramid_magnitudes(wave);
    // Half of the amplitude, for cosines are two waves; the filter lets its middle pass whole.
    EXPECT_NEAR(magnitudes[1 * pyramid_orientations + 0].at(20, 30), 0.5, 1e-12);
    EXPECT_NEAR(magnitudes[1 * pyramid_orientations + 1].at(20, 30), 0.5 * std::pow(std::numbers::sqrt2 / 2, 3), 1e-12);
    EXPECT_NEAR(magnitudes[1 * pyramid_orientations + 2].at(20, 30), 0, 1e-12);
    EXPECT_NEAR(magnitudes[0].at(20, 30), 0, 1e-12) << "an octave away nothing passes";
    EXPECT_NEAR(magnitudes[2 * pyramid_orientations].at(20, 30), 0, 1e-12);
}

/// Against sums over all pairs.
TEST(SelfCorrelation, IsTheSumOverPairs)
{
    LightMap map{24, 20, {}};
    std::mt19937 random(9);
    for (int i = 0; i < 24 * 20; ++i) map.values.push_back(static_cast<double>(random() % 100));
    double mean = 0, variance = 0;
    for (const double value : map.values) mean += value / (24 * 20);
    for (const double value : map.values) variance += (value - mean) * (value - mean) / (24 * 20);
    const SelfCorrelation correlations(map);
    for (const auto& [dx, dy] : {std::pair{0, 0}, {5, 0}, {-6, 3}, {2, 5}}) {
        double sum = 0;
        for (int y = 0; y + dy < 20; ++y)
            for (int x = std::max(0, -dx); x < std::min(24, 24 - dx); ++x)
                sum += (map.at(x, y) - mean) * (map.at(x + dx, y + dy) - mean);
        EXPECT_NEAR(correlations.at(dx, dy), sum / ((24 - std::abs(dx)) * (20 - dy)) / variance, 1e-12);
    }
}

/// White noise: the largest of many correlations is what Bartlett's formula has.
TEST(CorrelationPeak, OfNoiseIsChance)
{
    LightMap map{200, 200, {}};
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 200 * 200; ++i) map.values.push_back(normal(random));
    const SelfCorrelation correlations(map);
    const double chance = chance_of_peak(correlations, 8, 200, 200);
    EXPECT_NEAR(chance, std::sqrt(2 * std::log(200.0 * 200 / 8)) / 200, 0.002);
    // The largest of 5,000 such is within a tenth of it; places near a quarter have fewer pairs, 1 / (0.75 x 0.75).
    EXPECT_GT(correlation_peak(correlations, 8).correlation, 0.85 * chance);
    EXPECT_LT(correlation_peak(correlations, 8).correlation, 1.1 / 0.5625 * chance);
}

}
}
