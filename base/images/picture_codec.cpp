// The module poissonlab_pictures: see loaded_codec.cpp.
#include "base/images/picture_codec.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>

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
        return read_channels(path, pixels, OIIO::TypeDesc::UINT8);
    }

    std::string write_deep(const std::filesystem::path& path, const DeepPixels& pixels) const override
    {
        const OIIO::ImageSpec spec(pixels.width, pixels.height, pixels.channels, OIIO::TypeDesc::UINT16);
        const auto output = OIIO::ImageOutput::create("png");
        if (!output) return OIIO::geterror();
        const bool is_written = output->open(path.string(), spec) &&
                                output->write_image(OIIO::TypeDesc::UINT16, pixels.values.data()) && output->close();
        return is_written ? "" : reason(output->geterror());
    }

    std::string read_deep(const std::filesystem::path& path, DeepPixels& pixels) const override
    {
        return read_channels(path, pixels, OIIO::TypeDesc::UINT16);
    }

    std::string read_linear(const std::filesystem::path& path, LinearPicture& picture) const override
    {
        OIIO::ImageSpec settings;
        settings.attribute("oiio:UnassociatedAlpha", 1);
        const auto input = OIIO::ImageInput::open(path.string(), &settings);
        if (!input) return reason(OIIO::geterror());
        const OIIO::ImageSpec spec = input->spec();
        if (spec.nchannels < 1 || spec.nchannels > most_channels || spec.width < 1 || spec.height < 1)
            return "it has no pixels, or hundreds of channels";
        if (spec.depth > 1) return "it has layers";
        const auto pixels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
        if (pixels > most_pixels)
            return std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels: must be at most " +
                   std::to_string(most_pixels);
        std::vector<float> values(pixels * static_cast<std::uint64_t>(spec.nchannels));
        if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
            return reason(input->geterror());
        if (!spec.format.is_floating_point()) make_linear(values, spec);
        return upright(spec, values, picture);
    }

private:
    static constexpr int most_channels = 256;

    template <class Pixels>
    static std::string read_channels(const std::filesystem::path& path, Pixels& pixels, OIIO::TypeDesc type)
    {
        const auto input = OIIO::ImageInput::open(path.string());
        if (!input) return reason(OIIO::geterror());
        const OIIO::ImageSpec& spec = input->spec();
        const auto values = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height) *
                            static_cast<std::uint64_t>(spec.nchannels);
        if (values > most_png_values) return "it has too many pixels";
        pixels = {spec.width, spec.height, spec.nchannels, {}};
        pixels.values.resize(values);
        const bool is_read = input->read_image(0, 0, 0, pixels.channels, type, pixels.values.data());
        return is_read ? "" : reason(input->geterror());
    }

    /// Values become linear from sRGB, but for alpha: IEC 61966-2-1.
    static void make_linear(std::vector<float>& values, const OIIO::ImageSpec& spec)
    {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (static_cast<int>(i % static_cast<std::size_t>(spec.nchannels)) == spec.alpha_channel) continue;
            const double v = values[i];
            values[i] = static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
        }
    }

    /// Turns the picture as the camera says that it was held.
    static std::string upright(const OIIO::ImageSpec& spec, std::vector<float>& values, LinearPicture& picture)
    {
        OIIO::ImageSpec layout(spec.width, spec.height, spec.nchannels, OIIO::TypeDesc::FLOAT);
        layout.attribute("Orientation", spec.get_int_attribute("Orientation", 1));
        const OIIO::ImageBuf turned = OIIO::ImageBufAlgo::reorient(OIIO::ImageBuf(layout, values.data()));
        if (turned.has_error()) return reason(turned.geterror());
        picture.width = turned.spec().width;
        picture.height = turned.spec().height;
        picture.channels = spec.channelnames;
        picture.alpha.reset();
        if (spec.alpha_channel >= 0) picture.alpha = static_cast<std::size_t>(spec.alpha_channel);
        picture.values.resize(values.size());
        return turned.get_pixels(turned.roi(), OIIO::TypeDesc::FLOAT, picture.values.data())
                   ? ""
                   : reason(turned.geterror());
    }

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

    /// The first line says what failed; those that follow say it again.
    static std::string reason(const std::string& said)
    {
        return said.empty() ? "for an unknown reason" : said.substr(0, said.find('\n'));
    }
};

}
}

extern "C" __attribute__((visibility("default"))) const poissonlab::PictureCodec* poissonlab_picture_codec()
{
    static const poissonlab::OpenImageIoCodec codec;
    return &codec;
}
