#include "reports/grey_image.hpp"

#include "errors/errors.hpp"
#include "io/whole_file.hpp"

#include <png.h>

#include <string>

namespace poissonlab {

void write_png(const std::filesystem::path& path, const GreyImage& image)
{
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_GRAY;
    header.flags = PNG_IMAGE_FLAG_FAST; // spectra are noise: trying harder takes time and gains nothing

    std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(header), '\0');
    png_alloc_size_t size = bytes.size();
    if (!png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr))
        throw StorageError(path.string() + ": cannot write the picture: " + header.message);
    write_whole_file(path, std::string_view(bytes).substr(0, size));
}

}
