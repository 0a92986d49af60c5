// The module poissonlab_pictures: see loaded_codec.cpp.
#include "base/images/picture_codec.hpp"

#include "base/images/srgb_light.hpp"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>
#include <utility>

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

    std::string read_linear(const std::filesystem::path& path, AlphaUse use, LinearPicture& picture) const override
    {
        const auto input = opened(path);
        if (!input) return reason(OIIO::geterror());
        const OIIO::ImageSpec spec = input->spec();
        const std::size_t most = use == AlphaUse::covers ? most_pixels : most_raw_pixels(spec);
        if (const std::string lack = lack_of(spec, most); !lack.empty()) return lack;
        const auto pixels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
        std::vector<float> values(pixels * static_cast<std::uint64_t>(spec.nchannels));
        if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
            return reason(input->geterror());
        const PixelAlpha alpha = alpha_of(spec, input->format_name(), values);
        if (!spec.format.is_floating_point()) make_linear(values, alpha);
        const bool is_multiplied = alpha.is_multiplied && spec.format.is_floating_point();
        if (use == AlphaUse::covers && !is_multiplied) multiply_by_alpha(values, alpha);
        picture.alpha = alpha.channel;
        return upright(spec, values, picture);
    }

    std::string read_header(const std::filesystem::path& path, PictureHeader& header) const override
    {
        const auto input = opened(path);
        if (!input) return reason(OIIO::geterror());
        const OIIO::ImageSpec& spec = input->spec();
        header = {spec.width, spec.height, spec.nchannels, type_of(spec)};
        if (spec.get_int_attribute("Orientation", 1) > 4) std::swap(header.width, header.height);
        return lack_of(spec, most_raw_pixels(spec));
    }

    std::string read_raw(const std::filesystem::path& path, RawPicture& picture) const override
    {
        const auto input = opened(path);
        if (!input) return reason(OIIO::geterror());
        const OIIO::ImageSpec spec = input->spec();
        if (const std::string lack = lack_of(spec, most_raw_pixels(spec)); !lack.empty()) return lack;
        const std::optional<SampleType> type = type_of(spec);
        if (!type) return "it has numbers of another kind";
        picture = {spec.width, spec.height, *type, spec.channelnames, {}};
        picture.bytes.resize(picture.at(0, spec.height));
        if (!input->read_image(0, 0, 0, spec.nchannels, stored_as(*type), picture.bytes.data()))
            return reason(input->geterror());
        const int orientation = spec.get_int_attribute("Orientation", 1);
        return orientation == 1 ? "" : turn(orientation, picture);
    }

    std::string write_raw(const std::filesystem::path& path, const RawPicture& picture) const override
    {
        const int channels = static_cast<int>(picture.channels.size());
        OIIO::ImageSpec spec(picture.width, picture.height, channels, stored_as(picture.type));
        spec.attribute("oiio:UnassociatedAlpha", 1); // else colours would be divided by it
        const auto output = OIIO::ImageOutput::create("png");
        if (!output) return OIIO::geterror();
        const bool is_written = output->open(path.string(), spec) &&
                                output->write_image(spec.format, picture.bytes.data()) && output->close();
        return is_written ? "" : reason(output->geterror());
    }

private:
    static constexpr int most_channels = 256;

    /// A file whose colours are not multiplied by alpha.
    static std::unique_ptr<OIIO::ImageInput> opened(const std::filesystem::path& path)
    {
        OIIO::ImageSpec settings;
        settings.attribute("oiio:UnassociatedAlpha", 1);
        return OIIO::ImageInput::open(path.string(), &settings);
    }

    /// The words for a picture that is not read, empty for others.
    static std::string lack_of(const OIIO::ImageSpec& spec, std::size_t most)
    {
        if (spec.nchannels < 1 || spec.nchannels > most_channels || spec.width < 1 || spec.height < 1)
            return "it has no pixels, or hundreds of channels";
        if (spec.depth > 1) return "it has layers";
        if (static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height) > most)
            return std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels: must be at most " +
                   std::to_string(most);
        return "";
    }

    /// Atlases of tiles are larger than what weights are made of.
    static std::size_t most_raw_pixels(const OIIO::ImageSpec& spec)
    {
        return most_png_values / static_cast<std::size_t>(std::max(1, spec.nchannels));
    }

    static OIIO::TypeDesc stored_as(SampleType type)
    {
        return type == SampleType::byte   ? OIIO::TypeDesc::UINT8
               : type == SampleType::word ? OIIO::TypeDesc::UINT16
                                          : OIIO::TypeDesc::FLOAT;
    }

    /// The type that holds all numbers of a picture as they are, if there is one.
    static std::optional<SampleType> type_of(const OIIO::ImageSpec& spec)
    {
        std::optional<SampleType> all;
        for (int channel = 0; channel < spec.nchannels; ++channel) {
            const OIIO::TypeDesc format = spec.channelformat(channel);
            std::optional<SampleType> one;
            if (format == OIIO::TypeDesc::UINT8) one = SampleType::byte;
            if (format == OIIO::TypeDesc::UINT16) one = SampleType::word;
            if (format == OIIO::TypeDesc::HALF || format == OIIO::TypeDesc::FLOAT) one = SampleType::real;
            if (!one || (all && *all != *one)) return {};
            all = one;
        }
        return all;
    }

    /// Turns pixels as the camera says that it was held.
    static std::string turn(int orientation, RawPicture& picture)
    {
        const int channels = static_cast<int>(picture.channels.size());
        OIIO::ImageSpec layout(picture.width, picture.height, channels, stored_as(picture.type));
        layout.attribute("Orientation", orientation);
        const OIIO::ImageBuf turned = OIIO::ImageBufAlgo::reorient(OIIO::ImageBuf(layout, picture.bytes.data()));
        if (turned.has_error()) return reason(turned.geterror());
        picture.width = turned.spec().width;
        picture.height = turned.spec().height;
        std::vector<std::uint8_t> bytes(picture.bytes.size());
        if (!turned.get_pixels(turned.roi(), stored_as(picture.type), bytes.data())) return reason(turned.geterror());
        picture.bytes = std::move(bytes);
        return "";
    }

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

    /// Which channel of a pixel is alpha, and whether the library has multiplied the others by it.
    struct PixelAlpha
    {
        std::size_t channels = 1;
        std::optional<std::size_t> channel;
        bool is_multiplied = false;
    };

    /// Alpha as the library has it, or as it should: GIF files have it in a channel beyond the last one, some formats
    /// do not say that their colours are not multiplied, and the fourth byte of most BMP files is 0, which is no alpha.
    static PixelAlpha alpha_of(const OIIO::ImageSpec& spec, const std::string& format, const std::vector<float>& values)
    {
        PixelAlpha alpha{static_cast<std::size_t>(spec.nchannels), {}, false};
        if (spec.alpha_channel < 0 || spec.nchannels < 2) return alpha;
        alpha.channel = static_cast<std::size_t>(std::min(spec.alpha_channel, spec.nchannels - 1));
        const bool is_plain = format == "bmp" || format == "ico" || format == "sgi" || format == "gif";
        alpha.is_multiplied = !is_plain && spec.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
        bool has_cover = format != "bmp";
        for (std::size_t i = *alpha.channel; i < values.size() && !has_cover; i += alpha.channels)
            has_cover = values[i] > 0;
        if (!has_cover) alpha.channel.reset();
        return alpha;
    }

    /// Calls `change` with each colour and the alpha of its pixel.
    template <class Change>
    static void for_each_color(std::vector<float>& values, const PixelAlpha& alpha, const Change& change)
    {
        for (std::size_t pixel = 0; pixel < values.size(); pixel += alpha.channels) {
            const float cover = alpha.channel ? values[pixel + *alpha.channel] : 1;
            for (std::size_t c = 0; c < alpha.channels; ++c)
                if (c != alpha.channel) change(values[pixel + c], cover);
        }
    }

    /// Colours, without alpha in them, become linear from sRGB.
    static void make_linear(std::vector<float>& values, const PixelAlpha& alpha)
    {
        for_each_color(values, alpha, [&](float& color, float cover) {
            if (alpha.is_multiplied && cover > 0) color = std::min(color / cover, 1.0F);
            color = static_cast<float>(light_of_srgb(color));
        });
    }

    static void multiply_by_alpha(std::vector<float>& values, const PixelAlpha& alpha)
    {
        if (alpha.channel) for_each_color(values, alpha, [](float& color, float cover) { color *= cover; });
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
