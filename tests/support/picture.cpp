#include "tests/support/picture.hpp"

#include <png.h>

#include <cstdio>
#include <stdexcept>

namespace poissonlab::test {
namespace {

/// Reads a PNG's header and asks for pixels in a format of libpng's. Not for a copy of `header`: libpng keeps
/// its address.
void begin_reading(png_image& header, const std::string& bytes, png_uint_32 format)
{
    header.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()))
        throw std::runtime_error(header.message);
    header.format = format;
}

/// Reads the pixels, those that let through over white.
void finish_reading(png_image& header, void* pixels)
{
    const png_color white{255, 255, 255};
    if (!png_image_finish_read(&header, &white, pixels, 0, nullptr)) throw std::runtime_error(header.message);
}

}

double Picture::variance() const
{
    double sum = 0;
    double squares = 0;
    for (const double g : grey) {
        sum += g;
        squares += g * g;
    }
    const auto n = static_cast<double>(grey.size());
    return squares / n - sum / n * (sum / n);
}

std::string ColorPicture::at(int column, int row) const
{
    if (column < 0 || column >= width || row < 0) throw std::out_of_range("no such pixel");
    const auto& [red, green, blue] =
        pixels.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column));
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02x%02x%02x", unsigned{red}, unsigned{green}, unsigned{blue});
    return text.data();
}

Picture decode_png(const std::string& bytes)
{
    png_image header{};
    begin_reading(header, bytes, PNG_FORMAT_GRAY);
    Picture picture{static_cast<int>(header.width), static_cast<int>(header.height), {}};
    picture.grey.resize(PNG_IMAGE_SIZE(header));
    finish_reading(header, picture.grey.data());
    return picture;
}

ColorPicture decode_color_png(const std::string& bytes)
{
    png_image header{};
    begin_reading(header, bytes, PNG_FORMAT_RGB);
    ColorPicture picture{static_cast<int>(header.width), static_cast<int>(header.height), {}};
    picture.pixels.resize(PNG_IMAGE_SIZE(header) / 3);
    finish_reading(header, picture.pixels.data());
    return picture;
}

}
