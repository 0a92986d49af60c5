#include "analysis/spectrum_file.hpp"

#include "errors/errors.hpp"
#include "io/whole_file.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <stdexcept>

namespace poissonlab {

namespace {

// Our attributes have names of their own: no clash with those that mean something to OpenEXR ("type").
const std::string points_name = "poissonlab:points";
const std::string realizations_name = "poissonlab:realizations";
const std::string metadata_prefix = "poissonlab:meta:";
constexpr int max_size = 1 << 15; // a larger "spectrum" is a damaged header

/// The layout of `size` x `size` floats that are one channel, for reading and for writing.
Imf::FrameBuffer frame_buffer(std::vector<float>& pixels, int size)
{
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), sizeof(float),
                                 sizeof(float) * static_cast<std::size_t>(size)));
    return frame;
}

Imf::Header header_of(const Spectrum& spectrum, const std::map<std::string, std::string>& metadata)
{
    Imf::Header header(spectrum.size, spectrum.size);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    header.compression() = Imf::NO_COMPRESSION; // periodograms are noise: nothing to gain but waiting
    header.insert(points_name, Imf::StringAttribute(std::to_string(spectrum.points)));
    header.insert(realizations_name, Imf::StringAttribute(std::to_string(spectrum.realizations)));
    for (const auto& [name, value] : metadata) {
        header.insert(metadata_prefix + name, Imf::StringAttribute(value));
    }
    return header;
}

/// Runs `body`, which uses OpenEXR; what that throws becomes an InputError about `path`.
template <class Body>
auto reading(const std::filesystem::path& path, const Body& body)
{
    try {
        return body();
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(path.string() + ": not a spectrum: " + error.what());
    }
}

unsigned long count_attribute(const Imf::Header& header, const std::string& name)
{
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
    if (!attribute) throw std::runtime_error("the attribute " + name + " is missing");
    return std::stoul(attribute->value());
}

/// The size of the spectrum, once the header has everything that write_spectrum puts there.
int checked_size(const Imf::Header& header)
{
    const auto& window = header.dataWindow();
    const int width = window.max.x - window.min.x + 1;
    const int height = window.max.y - window.min.y + 1;
    if (window.min.x != 0 || window.min.y != 0 || width != height || width % 2 != 0 || width > max_size) {
        throw std::runtime_error("a spectrum is a square of even size with its corner at (0, 0)");
    }
    const Imf::Channel* channel = header.channels().findChannel("Y");
    if (!channel || channel->type != Imf::FLOAT || channel->xSampling != 1 || channel->ySampling != 1) {
        throw std::runtime_error("there is no float32 channel \"Y\"");
    }
    return width;
}

}

void write_spectrum(const std::filesystem::path& path, const Spectrum& spectrum,
                    const std::map<std::string, std::string>& metadata)
{
    if (spectrum.dimension != 2) throw std::invalid_argument("write_spectrum: needs a 2D spectrum");
    std::vector<float> pixels(spectrum.power.begin(), spectrum.power.end());
    write_whole_file(path, [&](const std::filesystem::path& temporary) {
        try {
            Imf::OutputFile file(temporary.c_str(), header_of(spectrum, metadata));
            file.setFrameBuffer(frame_buffer(pixels, spectrum.size));
            file.writePixels(spectrum.size);
        } catch (const std::exception& error) {
            throw StorageError(path.string() + ": cannot be written: " + error.what());
        }
    });
}

Spectrum read_spectrum(const std::filesystem::path& path)
{
    return reading(path, [&] {
        Imf::InputFile file(path.c_str());
        Spectrum spectrum;
        spectrum.size = checked_size(file.header());
        spectrum.points = count_attribute(file.header(), points_name);
        spectrum.realizations = static_cast<int>(count_attribute(file.header(), realizations_name));

        std::vector<float> pixels(static_cast<std::size_t>(spectrum.size) * spectrum.size);
        file.setFrameBuffer(frame_buffer(pixels, spectrum.size));
        file.readPixels(0, spectrum.size - 1);
        spectrum.power.assign(pixels.begin(), pixels.end());
        return spectrum;
    });
}

std::map<std::string, std::string> read_spectrum_metadata(const std::filesystem::path& path)
{
    return reading(path, [&] {
        const Imf::InputFile file(path.c_str());
        checked_size(file.header());
        std::map<std::string, std::string> metadata;
        for (auto it = file.header().begin(); it != file.header().end(); ++it) {
            const std::string name = it.name();
            const auto* text = dynamic_cast<const Imf::StringAttribute*>(&it.attribute());
            if (text && name.starts_with(metadata_prefix)) {
                metadata[name.substr(metadata_prefix.size())] = text->value();
            }
        }
        return metadata;
    });
}

}
