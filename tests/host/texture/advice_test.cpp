// Advice from pictures: scales are held against closed forms, and advice does not change with what should not matter.
#include "host/texture/advice/advice_words.hpp"
#include "host/texture/advice/picture_scales.hpp"
#include "host/texture/exemplar.hpp"
#include "tests/host/texture/random_picture.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

PngPixels grey_picture(int width, int height, const std::function<double(int, int)>& value)
{
    PngPixels picture{width, height, 1, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.values.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(value(x, y), 0.0, 255.0))));
    return picture;
}

PngPixels shipped(const std::string& name)
{
    return read_exemplar(source_folder() + "/configs/exemplars/" + name + ".png");
}

/// Noise whose correlation is exp(-d^2 / (4 s^2)).
LightMap blurred_noise(int side, double s, unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const int reach = static_cast<int>(std::ceil(4 * s));
    std::vector<double> taps;
    for (int i = -reach; i <= reach; ++i) taps.push_back(std::exp(-i * i / (2 * s * s)));
    LightMap map{side, side, {}};
    for (int i = 0; i < side * side; ++i) map.values.push_back(normal(random));
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
        const LightMap before = map;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                double sum = 0;
                for (int i = -reach; i <= reach; ++i)
                    sum += taps[static_cast<std::size_t>(i + reach)] *
                           before.at((x + i * dx + side) % side, (y + i * dy + side) % side);
                map.values[map.index(x, y)] = sum;
            }
    }
    return map;
}

/// The variance of means over n x n values, in parts of that of values, by the sum over all pairs; the correlation is
/// the product of one along each axis.
double share_by_pairs(int n, const std::function<double(int)>& correlation)
{
    double sum = 0;
    for (int d = -n + 1; d < n; ++d) sum += (n - std::abs(d)) * correlation(d);
    return std::pow(sum / n / n, 2);
}

/// The side at which the closed form has the share, between whole numbers.
double side_by_pairs(double share, const std::function<double(int)>& correlation)
{
    int n = 1;
    while (share_by_pairs(n, correlation) > share) ++n;
    const double above = share_by_pairs(n - 1, correlation), below = share_by_pairs(n, correlation);
    return n - 1 + (above - share) / (above - below);
}

/// 512^2 values with a correlation area of 4 pi s^2 have N = 20,861 / s^2 independent parts. Variances of pixels and of
/// means over squares have relative errors of about sqrt(2 / N) each, and the share falls about as side^-1.5 there.
/// Sides between which values are linear err by less than 2 %.
TEST(PictureScale, IsThatOfBlurredNoise)
{
    for (const double s : {1.5, 3.0, 6.0})
        for (const double share : {0.5, 0.25}) {
            const auto found = side_at_share(blurred_noise(512, s, 7), share);
            const double side = side_by_pairs(share, [s](int d) { return std::exp(-d * d / (4 * s * s)); });
            ASSERT_TRUE(found);
            EXPECT_NEAR(*found, side, side * (0.02 + 3 * std::sqrt(2 * s * s / 20861))) << s << " " << share;
        }
}

/// White noise has 1/side^2, exactly up to chance: the share 1/4 is at two pixels.
TEST(PictureScale, IsTwoPixelsOfWhiteNoise)
{
    const auto found = side_at_share(lightness_map(test::random_picture(400, 300, 1, 3)), 0.25);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, 2, 0.03);
}

/// Means over a whole number of periods are all the same; the correlation of stripes of width w is a triangle of period
/// 2 w along x, of checks the product of two.
TEST(PictureScale, IsThatOfStripesAndChecks)
{
    for (const int w : {8, 16, 24}) {
        const auto triangle = [w](int d) {
            return std::abs(1 - std::abs(d) % (2 * w) / static_cast<double>(w)) * 2 - 1;
        };
        const auto stripes = [&](int x, int /*y*/) { return x / w % 2 == 0 ? 40.0 : 200.0; };
        const auto checks = [&](int x, int y) { return (x / w + y / w) % 2 == 0 ? 40.0 : 200.0; };
        const auto of_stripes = side_at_share(lightness_map(grey_picture(960, 480, stripes)), 0.25);
        const auto of_checks = side_at_share(lightness_map(grey_picture(960, 960, checks)), 0.25);
        ASSERT_TRUE(of_stripes && of_checks);
        // Stripes: the square root, as means along y change nothing.
        const double across = side_by_pairs(0.0625, triangle), both = side_by_pairs(0.25, triangle);
        EXPECT_NEAR(*of_stripes, across, 0.03 * across) << w;
        EXPECT_NEAR(*of_checks, both, 0.03 * both) << w;
    }
}

/// Disks at random places, as dark as there are disks over each other: the correlation is the overlap of two disks.
TEST(PictureScale, IsThatOfDisks)
{
    constexpr int side = 600;
    for (const double r : {4.0, 8.0}) {
        std::mt19937 random(11);
        LightMap map{side, side, std::vector<double>(side * side)};
        const int disks = static_cast<int>(side * side / (r * r * 4));
        for (int i = 0; i < disks; ++i) {
            const double x = static_cast<double>(random() % 60000) / 100,
                         y = static_cast<double>(random() % 60000) / 100;
            for (int dy = -9; dy <= 9; ++dy)
                for (int dx = -9; dx <= 9; ++dx) {
                    const int px = static_cast<int>(x) + dx, py = static_cast<int>(y) + dy;
                    if (std::hypot(px - x, py - y) < r) map.values[map.index((px + side) % side, (py + side) % side)]++;
                }
        }
        const auto overlap = [r](double d) {
            return d >= 2 * r ? 0
                              : (std::acos(d / (2 * r)) - d / (2 * r) * std::sqrt(1 - d * d / (4 * r * r))) * 2 /
                                    std::numbers::pi;
        };
        const auto share = [&](int n) {
            double sum = 0;
            for (int dy = -n + 1; dy < n; ++dy)
                for (int dx = -n + 1; dx < n; ++dx)
                    sum += (n - std::abs(dx)) * (n - std::abs(dy)) * overlap(std::hypot(dx, dy));
            return sum / std::pow(n, 4);
        };
        int n = 1;
        while (share(n) > 0.25) ++n;
        const auto found = side_at_share(map, 0.25);
        ASSERT_TRUE(found);
        EXPECT_NEAR(*found, n - 0.5, 0.5 + n * (0.02 + 3 * std::sqrt(2.0 / disks)));
    }
}

TEST(PictureScale, IsNothingOfOneColor)
{
    EXPECT_FALSE(side_at_share(lightness_map(grey_picture(32, 32, [](int, int) { return 7; })), 0.25));
}

PngPixels transposed(const PngPixels& picture)
{
    return grey_picture(picture.height, picture.width,
                        [&](int x, int y) { return picture.values[picture.at(y, x, 0)]; });
}

TEST(TextureAdvice, DoesNotDependOnWhatDoesNotMatter)
{
    const PngPixels gravel = shipped("gravel");
    const TextureAdvice advice = advise_texture(gravel), turned = advise_texture(transposed(gravel));
    EXPECT_NEAR(*turned.scale, *advice.scale, 1e-9);
    EXPECT_NEAR(turned.contrast_spread, advice.contrast_spread, 1e-9);
    EXPECT_EQ(turned.size, advice.size);
    // Half of the contrast, and lighter: values are rounded to whole ones, 1/sqrt(12) in some twenty.
    const TextureAdvice pale = advise_texture(
        grey_picture(512, 512, [&](int x, int y) { return 90 + gravel.values[gravel.at(x, y, 0)] / 2.0; }));
    EXPECT_NEAR(*pale.scale, *advice.scale, 0.01 * *advice.scale);
    EXPECT_NEAR(pale.contrast_spread, advice.contrast_spread, 0.01);
    EXPECT_EQ(pale.size, advice.size);
}

/// Pictures of 512^2 pixels are measured as they are; larger ones are reduced to that exactly.
TEST(TextureAdvice, GrowsWithThePicture)
{
    const PngPixels gravel = shipped("gravel");
    const TextureAdvice advice = advise_texture(gravel);
    for (const int times : {2, 4}) {
        const TextureAdvice large = advise_texture(grey_picture(
            512 * times, 512 * times, [&](int x, int y) { return gravel.values[gravel.at(x / times, y / times, 0)]; }));
        EXPECT_EQ(large.size, std::min(256, 64 * times));
        EXPECT_NEAR(*large.scale, times * *advice.scale, 0.03 * times * *advice.scale);
    }
}

struct KnownAdvice
{
    std::string picture;
    int size;
    bool is_straightened, is_flattened;
};

/// The answers of docs/texture-tiles.md.
TEST(TextureAdvice, IsThatOfTheDocumentation)
{
    const std::vector<KnownAdvice> known{
        {"gravel", 64, false, false},   {"cork", 64, false, false},     {"sand", 64, false, false},
        {"grass", 64, false, false},    {"turf", 64, false, false},     {"leaves", 64, false, false},
        {"granite", 128, false, false}, {"pebbles", 128, false, false}, {"stones", 128, false, false},
        {"brick", 128, true, false},    {"fabric", 64, false, false},   {"clouds", 128, false, false}};
    for (const KnownAdvice& one : known) {
        const TextureAdvice advice = advise_texture(shipped(one.picture));
        EXPECT_TRUE(advice.is_texture()) << one.picture;
        EXPECT_EQ(advice.size, one.size) << one.picture;
        EXPECT_EQ(advice.colors, 3) << one.picture;
        EXPECT_EQ(advice.is_straightened, one.is_straightened) << one.picture;
        EXPECT_EQ(advice.is_flattened, one.is_flattened) << one.picture;
        EXPECT_TRUE(advice.is_joint) << one.picture;
    }
    EXPECT_EQ(advise_texture(shipped("fabric")).periods.size(), 2u);
    EXPECT_TRUE(advise_texture(shipped("clouds")).is_wide);
    EXPECT_EQ(advise_texture(shipped("cat")).obstacle, TextureObstacle::one_object);
}

/// As texture build does, with tiles of which the picture has more than two along a side.
TEST(TextureAdvice, FindsUnevenLight)
{
    const PngPixels noise = test::random_picture(300, 300, 1, 5);
    const TextureAdvice advice = advise_texture(
        grey_picture(300, 300, [&](int x, int y) { return (noise.values[noise.at(x, y, 0)] + x / 2) * 0.6; }));
    EXPECT_EQ(advice.size, 64);
    EXPECT_TRUE(advice.is_flattened);
    EXPECT_FALSE(advise_texture(noise).is_flattened);
}

TEST(TextureAdvice, RefusesWhatIsNoTexture)
{
    const PngPixels noise = test::random_picture(256, 256, 1, 5);
    const auto of = [](const PngPixels& picture) { return advise_texture(picture).obstacle; };
    EXPECT_EQ(of(noise), TextureObstacle::none);
    EXPECT_EQ(of(grey_picture(64, 64, [](int, int) { return 30; })), TextureObstacle::one_color);
    EXPECT_FALSE(advise_texture(grey_picture(900, 900, [](int, int) { return 30; })).scale);
    EXPECT_EQ(of(grey_picture(256, 200, [](int x, int) { return x; })), TextureObstacle::other_colors);
    EXPECT_EQ(of(grey_picture(256, 256,
                              [&](int x, int y) {
                                  return std::hypot(x - 128, y - 128) < 60 ? noise.values[noise.at(x, y, 0)] : 100;
                              })),
              TextureObstacle::one_object);
    EXPECT_EQ(of(grey_picture(256, 256, [&](int x, int y) { return x < 128 ? noise.values[noise.at(x, y, 0)] : 100; })),
              TextureObstacle::not_alike);
    EXPECT_EQ(of(test::random_picture(16, 2000, 1, 5)), TextureObstacle::too_small);
    EXPECT_THAT(message_of<InputError>([] { advise_texture(test::random_picture(8, 8, 1, 5)); }),
                HasSubstr("8 x 8 pixels: must have at least 16 x 16"));
}

TEST(TextureAdvice, SaysWhatIsAgainstIt)
{
    const TextureAdvice pebbles = advise_texture(shipped("pebbles"));
    TextureRequest request;
    request.is_joint_open = true;
    EXPECT_THAT(advice_note(pebbles, request), HasSubstr("--size 128 is advised, 64 was given"));
    take_advice(request, pebbles, true, true);
    EXPECT_EQ(advice_note(pebbles, request), "");
    EXPECT_TRUE(request.joint);
    EXPECT_EQ(large_set_note(request), "");
    TextureRequest omega;
    omega.kind = TextureKind::omega;
    omega.colors = {4, 4};
    take_advice(omega, pebbles, true, true);
    EXPECT_EQ(omega.colors.horizontal, 4);
    EXPECT_EQ(omega.size, 128);
    TextureRequest large; // colours are those of the size that is used
    large.size = 256;
    take_advice(large, pebbles, false, true);
    EXPECT_EQ(large.colors.horizontal, 2);
    EXPECT_THAT(advice_note(pebbles, large), Not(HasSubstr("--colors")));
    large.colors = {3, 3};
    large.is_joint_open = true;
    EXPECT_THAT(large_set_note(large), HasSubstr("81 tiles of 256 x 256 pixels are too many"));
}

/// Advice leaves out choices that the caller has made.
TEST(TextureAdvice, IsOfWhatIsOpen)
{
    const TextureAdvice brick = advise_texture(shipped("brick"));
    EXPECT_THAT(advice_lines(brick),
                ElementsAre(HasSubstr("of 3 colours, made both ways, the better set being kept: its scale"),
                            HasSubstr("--straighten")));
    EXPECT_THAT(advice_lines(brick, {false, false, false, false}),
                ElementsAre(AllOf(HasSubstr("128 x 128 pixels: its scale"), Not(HasSubstr("colours")))));
}

}
}
