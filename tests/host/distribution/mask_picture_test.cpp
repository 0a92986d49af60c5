// Measures of masks are held against sums over all pixels and closed forms of histograms and waves; wrong ones are
// refused.
#include "host/distribution/masks/mask_picture.hpp"

#include "base/images/png_file.hpp"
#include "base/images/raw_picture.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace poissonlab {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

/// Computes powers by their definition.
std::vector<double> summed_power(const std::vector<double>& values, std::uint32_t width, std::uint32_t height)
{
    double squares = 0;
    for (const double value : values) squares += value * value;
    std::vector<double> power;
    for (std::uint32_t v = 0; v < height; ++v)
        for (std::uint32_t u = 0; u < width; ++u) {
            std::complex<double> sum;
            for (std::uint32_t y = 0; y < height; ++y)
                for (std::uint32_t x = 0; x < width; ++x)
                    sum +=
                        values[std::size_t{y} * width + x] *
                        std::polar(1.0, -2 * std::numbers::pi *
                                            (static_cast<double>(u * x) / width + static_cast<double>(v * y) / height));
            power.push_back(std::norm(sum) / squares);
        }
    return power;
}

TEST(MaskPictures, HaveThePowerOfTheSumOverTheirPixels)
{
    std::mt19937 random(3);
    for (const auto& [width, height] : {std::pair{7u, 10u}, {12u, 5u}, {8u, 8u}, {1u, 9u}, {6u, 1u}, {2u, 3u}}) {
        std::vector<double> values(std::size_t{width} * height);
        for (double& value : values) value = static_cast<double>(random() % 256) - 128;
        const std::vector<double> fast = field_power(values, width, height), sums = summed_power(values, width, height);
        for (std::size_t i = 0; i < sums.size(); ++i) ASSERT_NEAR(fast[i], sums[i], 1e-9) << width << " x " << height;
    }
}

/// All frequencies but 0 up to half a cycle a pixel are in one ring each; of (u, v) and (-u, -v) one is.
TEST(MaskPictures, HaveRingsOfTrueLength)
{
    for (const auto& [width, height] : {std::pair{16u, 16u}, {40u, 16u}, {9u, 24u}}) {
        std::vector<double> power(std::size_t{width} * height);
        double sum = 0, count = 0;
        const std::size_t rings = std::min(width, height) / 2;
        for (int v = 0; v < static_cast<int>(height); ++v)
            for (int u = 0; u < static_cast<int>(width); ++u) {
                const double x = 2 * u <= static_cast<int>(width) ? u : u - static_cast<int>(width);
                const double y = 2 * v <= static_cast<int>(height) ? v : v - static_cast<int>(height);
                const double length = std::hypot(x / width, y / height);
                power[static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u)] = length;
                if (std::llround(length * 2 * static_cast<double>(rings)) != 3 || length > 0.5) continue;
                sum += length;
                ++count;
            }
        const RingPower means = ring_power(power, width, height);
        const auto third = std::ranges::find(means.frequency, 3 / (2 * static_cast<double>(rings)));
        ASSERT_NE(third, means.frequency.end());
        // Frequencies that are their own opposites count as often as others here, and half as often there.
        EXPECT_NEAR(means.power[static_cast<std::size_t>(third - means.frequency.begin())], sum / count, 0.02);
        for (std::size_t k = 0; k < means.power.size(); ++k)
            EXPECT_NEAR(means.power[k], means.frequency[k], 0.5 / static_cast<double>(rings));
    }
}

MaskPicture made_mask(std::uint32_t width, std::uint32_t height, const std::function<double(std::size_t)>& value)
{
    MaskPicture mask{width, height, {}, 0, 255, 256};
    for (std::size_t i = 0; i < std::size_t{width} * height; ++i) mask.values.push_back(value(i));
    return mask;
}

TEST(MaskPictures, KnowHowEvenTheirHistogramIs)
{
    EXPECT_NEAR(histogram_error(made_mask(32, 16, [](std::size_t i) { return i % 256; })), 0, 1e-12);
    // Half of the values come twice as often: up to 127 there are all pixels instead of half of them.
    EXPECT_NEAR(histogram_error(made_mask(32, 16, [](std::size_t i) { return i % 128; })), 0.5, 1e-12);
    EXPECT_NEAR(histogram_error(made_mask(32, 16, [](std::size_t i) { return i % 2 == 0 ? 0 : 255; })), 0.5 - 1.0 / 256,
                1e-12);
}

/// A row of pixels is below each eighth of the values: distances are known, and the torus is a rectangle.
TEST(MaskPictures, HaveThresholdsWhosePixelsArePoints)
{
    const MaskPicture mask = made_mask(32, 8, [](std::size_t i) { return i % 4 == 0 && i / 32 % 4 == 0 ? 3 : 200; });
    const std::vector<MaskLevel> levels = mask_levels(mask);
    ASSERT_EQ(levels.size(), 1U); // of two values
    EXPECT_EQ(levels[0].below, 16U);
    EXPECT_EQ(levels[0].threshold, 200);
    EXPECT_NEAR(levels[0].least_distance, 4, 1e-6);
    EXPECT_NEAR(levels[0].mean_nearest, std::sqrt(std::sqrt(3.0) / 2), 1e-9); // a square lattice
    EXPECT_NEAR(levels[0].low_power, 0, 1e-12);
    // Levels are sixteenths of all pixels, where values tell these apart.
    const std::vector<MaskLevel> all = mask_levels(made_mask(16, 16, [](std::size_t i) { return i * 37 % 256; }));
    ASSERT_EQ(all.size(), 15U);
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].below, 16 * (i + 1));
}

class MaskPictureFiles : public testing::Test
{
protected:
    std::filesystem::path png(const std::string& name, int channels, const std::function<int(std::size_t)>& value)
    {
        PngPixels pixels{12, 5, channels, {}};
        for (std::size_t i = 0; i < 60U * static_cast<std::size_t>(channels); ++i)
            pixels.values.push_back(static_cast<std::uint8_t>(value(i)));
        write_png(folder_.path() / name, pixels);
        return folder_.path() / name;
    }

    TemporaryFolder folder_;
};

TEST_F(MaskPictureFiles, AreReadAsTheirNumbersAre)
{
    const auto ramp = [](std::size_t i) { return static_cast<int>(i * 4 % 256); };
    const MaskPicture grey = read_mask_picture({png("a.png", 1, ramp), ""});
    EXPECT_EQ(grey.width, 12U);
    EXPECT_EQ(grey.height, 5U);
    EXPECT_EQ(grey.codes, 256U);
    for (std::size_t i = 0; i < 60; ++i) EXPECT_EQ(grey.values[i], ramp(i)); // no light, no alpha
    RawPicture clear{12, 5, SampleType::byte, {"Y", "A"}, {}};
    for (std::size_t i = 0; i < 60; ++i) {
        clear.bytes.push_back(static_cast<std::uint8_t>(ramp(i)));
        clear.bytes.push_back(9);
    }
    write_raw_picture(folder_.path() / "b.png", clear);
    const MaskPicture with_alpha = read_mask_picture({folder_.path() / "b.png", ""});
    EXPECT_EQ(with_alpha.values, grey.values);
    EXPECT_THAT(with_alpha.note, HasSubstr("alpha is left out"));
    const auto colors =
        png("c.png", 3, [&](std::size_t i) { return i % 3 == 1 ? ramp(i / 3) : 7 + static_cast<int>(i % 3); });
    EXPECT_EQ(read_mask_picture({colors, "G"}).values, grey.values);
    EXPECT_THAT(message_of([&] {
                    read_mask_picture({colors, ""});
                }),
                EndsWith("c.png: its channels R, G, B differ: one must be chosen, as by channel R"));
    EXPECT_THAT(message_of([&] {
                    read_mask_picture({colors, "A"});
                }),
                HasSubstr("has no channel A: its channels are R, G, B"));
    EXPECT_THAT(message_of([&] {
                    read_mask_picture({colors, "R"});
                }),
                EndsWith("c.png: is 7 everywhere: no threshold divides its pixels"));
    DeepPixels deep{12, 5, 1, {}};
    for (std::size_t i = 0; i < 60; ++i) deep.values.push_back(static_cast<std::uint16_t>(1000 * i));
    write_deep_png(folder_.path() / "d.png", deep);
    const MaskPicture words = read_mask_picture({folder_.path() / "d.png", ""});
    EXPECT_EQ(words.codes, 65'536U);
    EXPECT_EQ(words.values[59], 59'000);
    RawPicture real{12, 5, SampleType::real, {"Y"}, std::vector<std::uint8_t>(240)};
    for (std::size_t i = 0; i < 60; ++i) {
        const float value = static_cast<float>(i) / 64;
        std::copy_n(reinterpret_cast<const std::uint8_t*>(&value), 4,
                    real.bytes.begin() + static_cast<std::ptrdiff_t>(4 * i));
    }
    write_raw_picture(folder_.path() / "e.exr", real);
    const MaskPicture exr = read_mask_picture({folder_.path() / "e.exr", ""});
    EXPECT_EQ(exr.values[59], 59.0 / 64);
    EXPECT_EQ(exr.codes, 0U);
    EXPECT_EQ(exr.high, 1);
}

}
}
