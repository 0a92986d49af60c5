// Transparent pictures: files that libpng and OpenEXR write, and TIFF written by hand, whose light, ink and regions are
// known. IEC 61966-2-1: the byte 188 is 0.502886 of white's light.
#include "base/images/linear_picture.hpp"

#include "base/densities/density_values.hpp"
#include "base/images/float_image.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/raw_png.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <png.h>

#include <array>
#include <utility>
#include <vector>

namespace poissonlab {
namespace {

using testing::DoubleNear;
using testing::EndsWith;
using testing::Pointwise;

constexpr double grey_light = 0.502886, rounding_of_light = 1e-6;

class TransparentPictures : public testing::Test
{
protected:
    std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

    /// The numbers of a picture, rows from the bottom.
    std::vector<double> numbers(const std::string& name, const std::string& from) const
    {
        return picture_values(read_linear_picture(file(name)), from, name).values;
    }

    void expect_numbers(const std::string& name, const std::string& from, const std::vector<double>& expected) const
    {
        EXPECT_THAT(numbers(name, from), Pointwise(DoubleNear(rounding_of_light), expected)) << name << ", " << from;
    }

    TemporaryFolder folder_;
};

/// Black, white and grey of half alpha in the upper and middle rows; what is transparent below has any colour.
TEST_F(TransparentPictures, AreNoLightAndNoInkWhereTheyAreClear)
{
    for (const int bits : {8, 16}) {
        const int full = bits == 8 ? 255 : 65535, half = bits == 8 ? 51 : 13107, grey = bits == 8 ? 188 : 188 * 257;
        const auto sample = [](int value) { return static_cast<std::uint16_t>(value); };
        test::RawPng colors{2, 2, 4, bits, {}}, greys{2, 2, 2, bits, {}};
        for (const auto& [value, alpha] : {std::pair{0, full}, {full, full}, {grey, half}, {grey, 0}}) {
            for (int c = 0; c < 3; ++c) colors.samples.push_back(sample(value));
            greys.samples.push_back(sample(value));
            colors.samples.push_back(sample(alpha));
            greys.samples.push_back(sample(alpha));
        }
        test::write_raw_png(file("colors.png"), colors);
        test::write_raw_png(file("greys.png"), greys);
        for (const std::string name : {"colors.png", "greys.png"}) { // alpha is 0.2 at the lower left
            expect_numbers(name, "light", {0.2 * grey_light, 0, 0, 1});
            expect_numbers(name, "ink", {0.2 * (1 - grey_light), 0, 1, 0});
            expect_numbers(name, "A", {0.2, 0, 1, 1});
        }
        expect_numbers("colors.png", "G", {0.2 * grey_light, 0, 0, 1});
        const LinearPicture beneath = read_linear_picture(file("colors.png"), AlphaUse::left_out);
        EXPECT_NEAR(static_cast<double>(beneath.at(1, 1, 2)), grey_light, rounding_of_light);
        EXPECT_NEAR(static_cast<double>(beneath.at(0, 1, 2)), grey_light, rounding_of_light);
    }
}

/// A palette with a transparent colour, which drawing programs write for few colours.
TEST_F(TransparentPictures, MayHaveAPalette)
{
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = 3;
    header.height = 1;
    header.format = PNG_FORMAT_RGBA_COLORMAP;
    header.colormap_entries = 3;
    const std::array<png_byte, 12> palette{0, 0, 0, 255, 10, 20, 30, 0, 255, 255, 255, 255};
    const std::array<png_byte, 3> pixels{0, 1, 2};
    ASSERT_TRUE(png_image_write_to_file(&header, file("palette.png").c_str(), 0, pixels.data(), 0, palette.data()));
    expect_numbers("palette.png", "ink", {1, 0, 0});
    expect_numbers("palette.png", "light", {0, 0, 1});
}

/// Colours of OpenEXR files are multiplied by alpha already: light without alpha shines.
TEST_F(TransparentPictures, OfFloatsAreMultipliedAlready)
{
    const FloatImage image{2, 1, {{"R", {0.25F, 0}}, {"G", {0.25F, 0}}, {"B", {0.25F, 0}}, {"A", {0.5F, 0}}}, {}};
    write_float_image(file("a.exr"), image);
    expect_numbers("a.exr", "light", {0.25, 0});
    expect_numbers("a.exr", "ink", {0.25, 0});
}

/// Red, green, blue, alpha of 8 bits as a TIFF file (TIFF 6.0), whose colours are multiplied by alpha (tag 338: 1) or
/// not (2).
std::string tiff_with_alpha(unsigned extra_sample, const std::array<std::uint8_t, 8>& samples)
{
    std::string bytes("II*\0\x08\0\0\0", 8);
    const auto append = [&](unsigned value, int count) {
        for (int i = 0; i < count; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 255));
    };
    constexpr unsigned tags = 10, after = 8 + 2 + tags * 12 + 4;
    append(tags, 2);
    for (const auto& [tag, type, count, value] : {std::array<unsigned, 4>{256, 4, 1, 2},
                                                  {257, 4, 1, 1},
                                                  {258, 3, 4, after},
                                                  {259, 3, 1, 1},
                                                  {262, 3, 1, 2},
                                                  {273, 4, 1, after + 8},
                                                  {277, 3, 1, 4},
                                                  {278, 4, 1, 1},
                                                  {279, 4, 1, 8},
                                                  {338, 3, 1, extra_sample}}) {
        append(tag, 2);
        append(type, 2);
        append(count, 4);
        append(value, 4);
    }
    append(0, 4);
    for (int i = 0; i < 4; ++i) append(8, 2);
    for (const std::uint8_t sample : samples) append(sample, 1);
    return bytes;
}

/// Bytes that are multiplied by alpha in sRGB give their colour by a division.
TEST_F(TransparentPictures, OfTiffSayWhatTheirColoursAre)
{
    folder_.write("straight.tif", tiff_with_alpha(2, {188, 188, 188, 127, 188, 188, 188, 255}));
    folder_.write("multiplied.tif", tiff_with_alpha(1, {94, 94, 94, 127, 188, 188, 188, 255}));
    const double half = 127.0 / 255;
    expect_numbers("straight.tif", "light", {half * grey_light, grey_light});
    // 94 / 127 is 188.74 / 255, whose light is 0.507320.
    expect_numbers("multiplied.tif", "light", {half * 0.507320, grey_light});
    expect_numbers("multiplied.tif", "ink", {half * (1 - 0.507320), 1 - grey_light});
}

/// GIF89a of 2 x 1 pixels: black, and a colour of the palette that is transparent.
TEST_F(TransparentPictures, MayBeGif)
{
    const std::string hex = "47494638396102000100f10000000000c86432ffffff00000021f90401000001"
                            "002c0000000002000100000202440a003b";
    std::string bytes;
    for (std::size_t i = 0; i < hex.size(); i += 2)
        bytes += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    folder_.write("a.gif", bytes);
    expect_numbers("a.gif", "ink", {1, 0});
    expect_numbers("a.gif", "light", {0, 0});
}

/// BMP with 32 bits a pixel, BI_RGB: the fourth byte is not used, and 0 in most files.
TEST_F(TransparentPictures, AreNoneOfBmp)
{
    std::string bytes("BM\x3e\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x02\0\0\0\x01\0\0\0\x01\0\x20\0", 30);
    bytes += std::string(24, '\0') + std::string("\xff\xff\xff\0\0\0\0\0", 8);
    folder_.write("a.bmp", bytes);
    expect_numbers("a.bmp", "light", {1, 0});
    expect_numbers("a.bmp", "ink", {0, 1});
}

/// Half of the alpha and half as bright: 127 and 128 of each, all four ways.
TEST_F(TransparentPictures, AreOutsideOfRegions)
{
    test::RawPng picture{4, 1, 2, 8, {128, 128, 128, 127, 127, 255, 255, 0}};
    test::write_raw_png(file("region.png"), picture);
    const PlaneRegion region = read_region(file("region.png"));
    ASSERT_EQ(region.polygons.size(), 1U);
    EXPECT_THAT(region.polygons[0].outline, testing::UnorderedElementsAre(std::array{0.0, 0.0}, std::array{1.0, 0.0},
                                                                          std::array{1.0, 1.0}, std::array{0.0, 1.0}));
    picture.samples = {0, 255, 0, 255, 0, 0, 0, 0};
    test::write_raw_png(file("black.png"), picture);
    EXPECT_THAT(message_of([&] { read_region(file("black.png")); }),
                EndsWith("black.png: no pixel is brighter than half, and transparent ones are outside: nothing is "
                         "inside"));
}

}
}
