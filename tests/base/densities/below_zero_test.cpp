// Rounding leaves numbers below 0 in pictures, as programs write them: lossy DWA files by OpenEXR.
#include "base/densities/density.hpp"
#include "base/densities/density_values.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

using testing::HasSubstr;

constexpr int map_width = 256, map_height = 128;

/// A night with a lamp: nowhere below 0, black in its lower half, and thousands of times as bright as the mean in a few
/// pixels, as the environment maps of Blender are.
std::vector<float> night()
{
    std::vector<float> values;
    for (int row = 0; row < map_height; ++row)
        for (int column = 0; column < map_width; ++column) {
            const double lamp = 3000 * std::exp(-0.5 * (std::pow(column - 90, 2) + std::pow(row - 40, 2)));
            const double wall = row > 64 && (column / 3 + row / 5) % 7 == 0 ? 0.3 : 0;
            const double sky = row < 64 ? 0.2 * (64 - row) / 64.0 : 0;
            for (const double tint : {1.0, 0.8, 0.5}) values.push_back(static_cast<float>((lamp + wall + sky) * tint));
        }
    return values;
}

/// Writes it as Blender's were: `oiiotool -d float --compression dwab:300`.
void write_dwa(const std::filesystem::path& file, std::vector<float> values)
{
    Imf::Header header(map_width, map_height);
    header.compression() = Imf::DWAB_COMPRESSION;
    header.dwaCompressionLevel() = 300;
    Imf::FrameBuffer pixels;
    const std::array names{"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        header.channels().insert(names.at(c), Imf::Channel(Imf::FLOAT));
        pixels.insert(names.at(c), Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&values[c]), 3 * sizeof(float),
                                              3 * sizeof(float) * map_width));
    }
    Imf::OutputFile output(file.string().c_str(), header);
    output.setFrameBuffer(pixels);
    output.writePixels(map_height);
}

TEST(BelowZero, IsNothingWhereCompressionMadeIt)
{
    const TemporaryFolder folder;
    write_dwa(folder.path() / "night.exr", night());
    const LinearPicture picture = read_linear_picture(folder.path() / "night.exr");
    std::size_t count = 0;
    double least = 0, sum = 0;
    for (int row = 0; row < map_height; ++row)
        for (int column = 0; column < map_width; ++column) {
            const double light = luminance(picture, column, row);
            count += light < 0 ? 1 : 0;
            least = std::min(least, light);
            sum += light;
        }
    ASSERT_GT(count, 10U) << "OpenEXR's compression leaves nothing below 0: this test is of no use";
    const Density density = density_of_picture(picture, "light", "night.exr");
    const double part = -least / (sum / (map_width * map_height));
    EXPECT_EQ(density.note, fmt::format("night.exr: {} pixels below 0, by up to {:.2g} of the mean, are taken as 0: "
                                        "rounding of the file",
                                        count, part));
    for (int row = 0; row < map_height; ++row)
        for (int column = 0; column < map_width; ++column)
            if (luminance(picture, column, row) < 0) {
                EXPECT_EQ(density.at((column + 0.5) / map_width, 1 - (row + 0.5) / map_height), 0U);
            }
}

/// A tenth of the mean each, and a thousandth of the sum together.
TEST(BelowZero, IsRefusedWhereItIsMore)
{
    const auto with = [](std::size_t count, double value) {
        std::vector<double> values(1000, 1.0);
        std::fill_n(values.begin(), count, value);
        return values;
    };
    std::vector<double> values = with(9, -0.09);
    EXPECT_THAT(clamp_rounding(values, "p"), HasSubstr("p: 9 pixels below 0, by up to 0.091 of the mean"));
    EXPECT_EQ(values, with(9, 0));
    values = with(1, -1e-300);
    EXPECT_THAT(clamp_rounding(values, "p"), HasSubstr("p: 1 pixel below 0, by up to 1e-300 of the mean, is taken"));
    for (const auto& [count, value] : {std::pair{1, -0.11}, std::pair{13, -0.09}, std::pair{500, -0.003}}) {
        values = with(static_cast<std::size_t>(count), value);
        EXPECT_EQ(clamp_rounding(values, "p"), "");
        EXPECT_EQ(values, with(static_cast<std::size_t>(count), value));
        EXPECT_EQ(refusal_of([&] { density_of_values(40, 25, values, "p"); }),
                  fmt::format("p: pixel (0, 24): density {}: must be a number that is not negative", value));
    }
    values = with(1, -0.001);
    values.back() = NAN;
    EXPECT_EQ(clamp_rounding(values, "p"), "");
    EXPECT_EQ(density_of_values(2, 1, {1, 2}, "p").note, "");
}

/// Blacks below 0 are black: ink is at most 1.
TEST(BelowZero, IsFullInk)
{
    LinearPicture picture{4, 256, {"Y"}, {}, std::vector<float>(1024, 0.5f)};
    picture.values[5] = -0.01f;
    const PixelValues ink = picture_values(picture, "ink", "p");
    EXPECT_EQ(ink.at(1, 254), 1);
    EXPECT_THAT(ink.note, HasSubstr("p: 1 pixel below 0"));
    EXPECT_EQ(density_of_picture(picture, "ink", "p").note, ink.note);
    // Heights and vectors may be below 0.
    EXPECT_LT(picture_values(picture, "light", "p").at(1, 254), 0);
}

}
}
