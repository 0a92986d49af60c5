// Pictures as their files have them, against files that libpng and OpenEXR write and read.
#include "base/images/raw_picture.hpp"

#include "base/images/linear_picture.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/program.hpp"
#include "tests/support/raw_png.hpp"
#include "tests/support/temporary_folder.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include <gmock/gmock.h>

#include <cstring>
#include <random>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(RawPicture, KeepsTheSamplesOfPngFiles)
{
    const TemporaryFolder folder;
    const auto given = folder.path() / "given.png", written = folder.path() / "written.png";
    std::mt19937 random(1);
    for (const int bits : {8, 16})
        for (const int channels : {1, 2, 3, 4}) {
            test::RawPng png{31, 17, channels, bits, {}};
            for (int i = 0; i < 31 * 17 * channels; ++i)
                png.samples.push_back(static_cast<std::uint16_t>(random() >> (32 - bits)));
            test::write_raw_png(given, png);
            const RawPicture picture = read_raw_picture(given);
            EXPECT_EQ(picture.type, bits == 8 ? SampleType::byte : SampleType::word);
            EXPECT_EQ(picture.channels.size(), static_cast<std::size_t>(channels));
            write_raw_picture(written, picture);
            const test::RawPng again = test::read_raw_png(written);
            EXPECT_EQ(again.bits, bits);
            EXPECT_EQ(again.channels, channels);
            EXPECT_EQ(again.samples, png.samples) << bits << " bits, " << channels << " channels";
        }
}

/// A damaged file is refused when its header is read, so that the key that names it can be told.
TEST(RawPicture, TellsOfDamageWhereItReads)
{
    const TemporaryFolder folder;
    const auto whole = folder.path() / "whole.png", cut = folder.path() / "cut.png";
    test::write_raw_png(whole, {31, 17, 1, 8, std::vector<std::uint16_t>(31 * 17, 7)});
    const std::string bytes = content_of(whole);
    const auto of_cut = [&](std::size_t count) { folder.write("cut.png", bytes.substr(0, count)); };
    of_cut(bytes.find("IDAT") + 6);
    EXPECT_THAT(message_of([&] { read_picture_header(cut); }), HasSubstr("the file is cut off"));
    EXPECT_THAT(message_of([&] { read_raw_picture(cut); }),
                HasSubstr("cut.png: cannot read the picture: the file is cut off"));
    of_cut(30); // within the first chunk
    EXPECT_THAT(message_of([&] { read_picture_header(cut); }), HasSubstr("the file is cut off"));
    std::string damaged = bytes;
    damaged[17] = '\x7f'; // of the width
    folder.write("cut.png", damaged);
    EXPECT_THAT(message_of([&] { read_picture_header(cut); }), HasSubstr("its chunk IHDR has another check sum"));
}

/// Grey numbers of 16 bits as a TIFF file, and how they were held (TIFF 6.0, tag 274).
std::string tiff_of(int width, int height, int orientation, const std::vector<std::uint16_t>& numbers)
{
    std::string bytes("II*\0\x08\0\0\0", 8);
    const auto append = [&](unsigned value, int count) {
        for (int i = 0; i < count; ++i) bytes.push_back(static_cast<char>(value >> (8 * i) & 255));
    };
    const unsigned size = static_cast<unsigned>(2 * numbers.size());
    const std::vector<std::pair<unsigned, unsigned>> tags{{256, static_cast<unsigned>(width)},
                                                          {257, static_cast<unsigned>(height)},
                                                          {258, 16},
                                                          {259, 1},
                                                          {262, 1},
                                                          {273, 8 + 2 + 10 * 12 + 4},
                                                          {274, static_cast<unsigned>(orientation)},
                                                          {277, 1},
                                                          {278, static_cast<unsigned>(height)},
                                                          {279, size}};
    append(static_cast<unsigned>(tags.size()), 2);
    for (const auto& [tag, value] : tags) {
        append(tag, 2);
        append(4, 2); // of 32 bits
        append(1, 4);
        append(value, 4);
    }
    append(0, 4);
    for (const std::uint16_t number : numbers) append(number, 2);
    return bytes;
}

TEST(RawPicture, IsUpright)
{
    const TemporaryFolder folder;
    const std::vector<std::uint16_t> stored{1, 20, 300, 4000, 50000, 65535}; // two rows of three
    const std::vector<std::pair<int, std::vector<std::uint16_t>>> upright{
        {1, stored},
        {3, {65535, 50000, 4000, 300, 20, 1}},
        {6, {4000, 1, 50000, 20, 65535, 300}},  // its first column is the top, its first row at the right
        {8, {300, 65535, 20, 50000, 1, 4000}}}; // its first row is at the left, its first column at the bottom
    for (const auto& [orientation, numbers] : upright) {
        const auto file = folder.write("held.tif", tiff_of(3, 2, orientation, stored));
        const RawPicture picture = read_raw_picture(file);
        const PictureHeader header = read_picture_header(file);
        EXPECT_EQ(picture.width, orientation < 5 ? 3 : 2);
        EXPECT_EQ(picture.width, header.width);
        EXPECT_EQ(picture.height, header.height);
        std::vector<std::uint16_t> found(6);
        ASSERT_EQ(picture.bytes.size(), 12u);
        std::memcpy(found.data(), picture.bytes.data(), 12);
        EXPECT_EQ(found, numbers) << orientation;
    }
}

/// Writes an EXR file of one row and a channel Y.
template <class Number>
void write_row(const std::filesystem::path& file, Imf::PixelType type, std::vector<Number> numbers)
{
    Imf::Header header(static_cast<int>(numbers.size()), 1);
    header.channels().insert("Y", Imf::Channel(type));
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(type, reinterpret_cast<char*>(numbers.data()), sizeof(Number), 0));
    Imf::OutputFile output(file.c_str(), header);
    output.setFrameBuffer(frame);
    output.writePixels(1);
}

/// Each float16 is a float32: all that are not negative, as wide as pictures may be; NaNs stay NaN.
TEST(RawPicture, KeepsTheNumbersOfHalves)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "half.exr", written = folder.path() / "float.exr";
    std::vector<half> halves(32768);
    for (unsigned bits = 0; bits < 32768; ++bits) halves[bits].setBits(static_cast<std::uint16_t>(bits));
    write_row(file, Imf::HALF, halves);
    write_raw_picture(written, read_raw_picture(file));
    const RawPicture picture = read_raw_picture(written);
    EXPECT_EQ(picture.type, SampleType::real);
    EXPECT_THAT(picture.channels, ElementsAre("Y"));
    for (std::size_t i = 0; i < 32768; ++i) {
        float value = 0;
        std::memcpy(&value, &picture.bytes[4 * i], 4);
        if (halves[i].isNan())
            ASSERT_TRUE(std::isnan(value));
        else
            ASSERT_EQ(value, static_cast<float>(halves[i])) << i;
    }
}

/// Atlases have more pixels than pictures that become weights may have.
TEST(RawPicture, MayBeAsLargeAsAnAtlas)
{
    const TemporaryFolder folder;
    const RawPicture large{8193, 1024, SampleType::byte, {"Y"}, std::vector<std::uint8_t>(8193 * 1024, 7)};
    write_raw_picture(folder.path() / "large.png", large);
    EXPECT_EQ(read_raw_picture(folder.path() / "large.png").bytes, large.bytes);
    EXPECT_THAT(message_of([&] { read_linear_picture(folder.path() / "large.png"); }),
                HasSubstr("8193 x 1024 pixels: must be at most 8388608"));
}

TEST(RawPicture, RefusesNumbersThatFilesDoNotHold)
{
    const TemporaryFolder folder;
    write_row(folder.path() / "whole.exr", Imf::UINT, std::vector<unsigned>{1, 2, 3});
    EXPECT_FALSE(is_kept_raw(read_picture_header(folder.path() / "whole.exr")));
    EXPECT_THAT(
        message_of([&] { read_raw_picture(folder.path() / "whole.exr"); }),
        HasSubstr("whole.exr: must have numbers of 8 or 16 bits in at most 4 channels, or of float16 or float32"));
}

}
}
