#include "base/images/grey_image.hpp"

#include "base/images/png_file.hpp"

namespace poissonlab {

void write_png(const std::filesystem::path& path, const GreyImage& image)
{
    PngLayout layout{image.width, image.height};
    // Spectra are noise: trying harder takes time and gains nothing.
    layout.compression = 1;
    layout.filters = false;
    write_png(path, layout, [&](int, int) { return image.pixels.data(); });
}

}
