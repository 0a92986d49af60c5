// The module poissonlab_pictures: see png_file.cpp.
#include "base/images/picture_codec.hpp"

#include <OpenImageIO/imageio.h>

#include <algorithm>

namespace poissonlab {
namespace {

class OpenImageIoCodec final : public PictureCodec
{
public:
    std::string write(const std::filesystem::path& path, const PngLayout& layout, const PngRows& rows) const override
    {
        OIIO::ImageSpec spec(layout.width, layout.height, layout.channels, OIIO::TypeDesc::UINT8);
        if (layout.compression >= 0) spec.attribute("png:compressionLevel", layout.compression);
        if (!layout.filters) spec.attribute("png:filter", 8); // PNG_FILTER_NONE: libpng would try all five on each row
        // Grey values of noise have nothing but runs: half the time, and smaller files. Colours have runs of three
        // bytes.
        if (!layout.filters && layout.channels == 1) spec.attribute("compression", "rle");
        const auto output = OIIO::ImageOutput::create("png");
        if (!output) return OIIO::geterror();
        const bool is_written =
            output->open(path.string(), spec) && write_rows(*output, layout, rows) && output->close();
        return is_written ? "" : reason(output->geterror());
    }

    std::string read(const std::filesystem::path& path, PngPixels& pixels) const override
    {
        const auto input = OIIO::ImageInput::open(path.string());
        if (!input) return reason(OIIO::geterror());
        const OIIO::ImageSpec& spec = input->spec();
        pixels = {spec.width, spec.height, spec.nchannels, {}};
        pixels.values.resize(pixels.at(0, pixels.height, 0));
        const bool is_read = input->read_image(0, 0, 0, pixels.channels, OIIO::TypeDesc::UINT8, pixels.values.data());
        return is_read ? "" : reason(input->geterror());
    }

private:
    static bool write_rows(OIIO::ImageOutput& output, const PngLayout& layout, const PngRows& rows)
    {
        const int step = layout.rows_at_once > 0 ? layout.rows_at_once : layout.height;
        for (int first = 0; first < layout.height; first += step) {
            const int last = std::min(first + step, layout.height);
            const std::uint8_t* const pixels = rows(first, last - first);
            if (!output.write_scanlines(first, last, 0, OIIO::TypeDesc::UINT8, pixels)) return false;
        }
        return true;
    }

    static std::string reason(const std::string& said) { return said.empty() ? "for an unknown reason" : said; }
};

}
}

extern "C" __attribute__((visibility("default"))) const poissonlab::PictureCodec* poissonlab_picture_codec()
{
    static const poissonlab::OpenImageIoCodec codec;
    return &codec;
}
