#include "support/picture.hpp"

#include <png.h>

#include <stdexcept>

namespace poissonlab::test {

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

Picture decode_png(const std::string& bytes)
{
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()))
        throw std::runtime_error(header.message);
    header.format = PNG_FORMAT_GRAY;
    Picture picture{static_cast<int>(header.width), static_cast<int>(header.height), {}};
    picture.grey.resize(PNG_IMAGE_SIZE(header));
    const png_color white{255, 255, 255};
    if (!png_image_finish_read(&header, &white, picture.grey.data(), 0, nullptr))
        throw std::runtime_error(header.message);
    return picture;
}

}
