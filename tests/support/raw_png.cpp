#include "tests/support/raw_png.hpp"

#include <png.h>

#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace poissonlab::test {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

[[noreturn]] void fail(png_structp, png_const_charp message) { throw std::runtime_error(message); }

File opened(const std::filesystem::path& path, const char* mode)
{
    File file(std::fopen(path.c_str(), mode), std::fclose);
    if (!file) throw std::runtime_error("cannot open " + path.string());
    return file;
}

}

RawPng read_raw_png(const std::filesystem::path& path)
{
    const File file = opened(path, "rb");
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file.get());
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    RawPng picture{static_cast<int>(png_get_image_width(png, info)),
                   static_cast<int>(png_get_image_height(png, info)),
                   png_get_channels(png, info),
                   png_get_bit_depth(png, info),
                   {}};
    const png_bytepp rows = png_get_rows(png, info);
    for (int row = 0; row < picture.height; ++row)
        for (int i = 0; i < picture.width * picture.channels; ++i)
            picture.samples.push_back(static_cast<std::uint16_t>(
                picture.bits == 8 ? rows[row][i] : rows[row][2 * i] << 8 | rows[row][2 * i + 1]));
    png_destroy_read_struct(&png, &info, nullptr);
    return picture;
}

void write_raw_png(const std::filesystem::path& path, const RawPng& picture)
{
    constexpr std::array color_types{PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                     PNG_COLOR_TYPE_RGB_ALPHA};
    const File file = opened(path, "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file.get());
    png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
                 picture.bits, color_types.at(static_cast<std::size_t>(picture.channels - 1)), PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    std::vector<png_byte> bytes;
    for (int row = 0; row < picture.height; ++row) {
        bytes.clear();
        for (int i = 0; i < picture.width * picture.channels; ++i) {
            const std::uint16_t sample = picture.pixel(0, row)[i];
            if (picture.bits == 16) bytes.push_back(static_cast<png_byte>(sample >> 8));
            bytes.push_back(static_cast<png_byte>(sample & 255));
        }
        png_write_row(png, bytes.data());
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
}

}
