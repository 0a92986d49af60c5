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

std::vector<std::string> channels_of(int dimension)
{
    if (dimension == 2) return {"Y"};
    std::vector<std::string> channels;
    for (const char* plane : plane_names) channels.push_back(std::string(plane) + ".Y");
    return channels;
}

/// The layout of `size` x `size` floats a channel, for reading and for writing.
Imf::FrameBuffer frame_buffer(std::vector<std::vector<float>>& planes, int size)
{
    const auto channels = channels_of(planes.size() == 1 ? 2 : 3);
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < planes.size(); ++i)
        frame.insert(channels[i], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(planes[i].data()),
                                             sizeof(float), sizeof(float) * static_cast<std::size_t>(size)));
    return frame;
}

Imf::Header header_of(const Spectrum& spectrum, const std::map<std::string, std::string>& metadata)
{
    Imf::Header header(spectrum.size, spectrum.size);
    for (const auto& channel : channels_of(spectrum.dimension))
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
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

bool has_channel(const Imf::Header& header, const std::string& name)
{
    const Imf::Channel* channel = header.channels().findChannel(name);
    return channel && channel->type == Imf::FLOAT && channel->xSampling == 1 && channel->ySampling == 1;
}

/// The dimension of the spectrum that the channels hold.
int checked_dimension(const Imf::Header& header)
{
    for (const int dimension : {2, 3}) {
        bool complete = true;
        for (const auto& channel : channels_of(dimension))
            complete = complete && has_channel(header, channel);
        if (complete) return dimension;
    }
    throw std::runtime_error("there is no float32 channel \"Y\", and no three of coordinate planes");
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
    return width;
}

}

void write_spectrum(const std::filesystem::path& path, const Spectrum& spectrum,
                    const std::map<std::string, std::string>& metadata)
{
    std::vector<std::vector<float>> pixels;
    for (const Spectrum& plane : coordinate_planes(spectrum))
        pixels.emplace_back(plane.power.begin(), plane.power.end());
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

std::vector<Spectrum> read_spectrum_planes(const std::filesystem::path& path)
{
    return reading(path, [&] {
        Imf::InputFile file(path.c_str());
        Spectrum plane;
        plane.size = checked_size(file.header());
        plane.points = count_attribute(file.header(), points_name);
        plane.realizations = static_cast<int>(count_attribute(file.header(), realizations_name));

        const auto pixels_of_plane = static_cast<std::size_t>(plane.size) * plane.size;
        std::vector<std::vector<float>> pixels(checked_dimension(file.header()) == 2 ? 1 : 3,
                                               std::vector<float>(pixels_of_plane));
        file.setFrameBuffer(frame_buffer(pixels, plane.size));
        file.readPixels(0, plane.size - 1);
        std::vector<Spectrum> planes;
        for (const auto& values : pixels) {
            plane.power.assign(values.begin(), values.end());
            planes.push_back(plane);
        }
        return planes;
    });
}

Spectrum read_spectrum(const std::filesystem::path& path)
{
    auto planes = read_spectrum_planes(path);
    if (planes.size() != 1)
        throw InputError(path.string() + ": has the planes of a 3D spectrum, not a 2D one");
    return std::move(planes.front());
}

std::map<std::string, std::string> read_spectrum_metadata(const std::filesystem::path& path)
{
    return reading(path, [&] {
        const Imf::InputFile file(path.c_str());
        checked_size(file.header());
        checked_dimension(file.header());
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
