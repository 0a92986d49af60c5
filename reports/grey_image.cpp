#include "reports/grey_image.hpp"

#include "errors/errors.hpp"
#include "io/whole_file.hpp"

#include <OpenImageIO/imageio.h>

namespace poissonlab {

void write_png(const std::filesystem::path& path, const GreyImage& image)
{
    write_whole_file(path, [&](const std::filesystem::path& temporary) {
        OIIO::ImageSpec spec(image.width, image.height, 1, OIIO::TypeDesc::UINT8);
        // Spectra are noise: trying harder takes time and gains nothing.
        spec.attribute("png:compressionLevel", 1);
        spec.attribute("png:filter", 8); // PNG_FILTER_NONE: libpng would try all five on each row
        const auto output = OIIO::ImageOutput::create("png");
        const bool written = output && output->open(temporary.string(), spec) &&
                             output->write_image(OIIO::TypeDesc::UINT8, image.pixels.data()) &&
                             output->close();
        if (written) return;
        throw StorageError(path.string() +
                           ": cannot write the picture: " + (output ? output->geterror() : OIIO::geterror()));
    });
}

}
