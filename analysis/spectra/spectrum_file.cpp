#include "analysis/spectra/spectrum_file.hpp"

#include "analysis/spectra/spectrum_planes.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/images/square_header.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfCompression.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <charconv>
#include <climits>
#include <stdexcept>

namespace poissonlab {

namespace {

/// Our attributes have names of their own: no clash with those that mean something to OpenEXR ("type").
const std::string points_name = "poissonlab:points";
const std::string realizations_name = "poissonlab:realizations";
const std::string metadata_prefix = "poissonlab:meta:";

/// The prefixes of channel names: "" for a 2D spectrum, the planes of a 3D one.
std::vector<std::string> layers_of(int dimension, int size)
{
    if (dimension == 2) return {""};
    std::vector<std::string> layers;
    for (const PlanePlace& place : shown_planes(size)) layers.push_back(plane_name(place) + ".");
    return layers;
}

/// One channel of an image and its pixels, row after row.
struct Channel
{
    std::string name;
    std::vector<float> pixels;
};

Imf::FrameBuffer frame_buffer(std::vector<Channel>& channels, int width)
{
    Imf::FrameBuffer frame;
    for (Channel& channel : channels)
        frame.insert(channel.name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(channel.pixels.data()), sizeof(float),
                                              sizeof(float) * static_cast<std::size_t>(width)));
    return frame;
}

Imf::Header header_of(const Spectrum& spectrum, int height, const std::map<std::string, std::string>& metadata)
{
    Imf::Header header(spectrum.size, height);
    header.compression() = Imf::NO_COMPRESSION; // periodograms are noise: nothing to gain but waiting
    header.insert(points_name, Imf::StringAttribute(std::to_string(spectrum.points)));
    header.insert(realizations_name, Imf::StringAttribute(std::to_string(spectrum.realizations)));
    for (const auto& [name, value] : metadata) {
        header.insert(metadata_prefix + name, Imf::StringAttribute(value));
    }
    return header;
}

void write_image(const std::filesystem::path& path, Imf::Header header, std::vector<Channel>& channels)
{
    const int width = header.dataWindow().max.x + 1, height = header.dataWindow().max.y + 1;
    for (const Channel& channel : channels) header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    write_whole_file(path, [&](const std::filesystem::path& temporary) {
        try {
            Imf::OutputFile file(temporary.c_str(), header);
            file.setFrameBuffer(frame_buffer(channels, width));
            file.writePixels(height);
        } catch (const std::exception& error) {
            throw StorageError(path.string() + ": cannot be written: " + error.what());
        }
    });
}

/// Runs `body`, which uses OpenEXR; what that throws becomes an InputError about `path`.
template <class Body>
auto reading(const std::filesystem::path& path, const Body& body)
{
    try {
        check_header_fits(path);
        return body();
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(path.string() + ": not a spectrum: " + error.what());
    }
}

unsigned long count_attribute(const Imf::Header& header, const std::string& name, unsigned long largest)
{
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
    if (!attribute) throw std::runtime_error("the attribute " + name + " is missing");
    const std::string& text = attribute->value();
    unsigned long count = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (status != std::errc{} || end != text.data() + text.size() || count > largest)
        throw std::runtime_error("the attribute " + name + " = \"" + shortened(text) +
                                 "\" must be an integer from 0 to " + std::to_string(largest));
    return count;
}

/// The size of the spectrum, once the header has everything that write_spectrum puts there.
int checked_size(const Imf::Header& header)
{
    const int size = checked_square_size(header);
    if (size % 2 != 0) throw std::runtime_error("a spectrum has an even size, not " + std::to_string(size));
    return size;
}

/// The layers of the spectrum that the channels hold.
std::vector<std::string> checked_layers(const Imf::Header& header, int size)
{
    for (const int dimension : {2, 3}) {
        const auto layers = layers_of(dimension, size);
        if (std::ranges::all_of(layers, [&](const auto& layer) { return has_float_channel(header, layer + "Y"); }))
            return layers;
    }
    throw std::runtime_error("there is no float32 channel \"Y\", nor those of the planes of a 3D spectrum");
}

}

void write_spectrum(const std::filesystem::path& path, const Spectrum& spectrum,
                    const std::map<std::string, std::string>& metadata)
{
    std::vector<Channel> channels;
    const auto add = [&](const std::string& layer, const Spectrum& plane) {
        channels.push_back({layer + "Y", {plane.power.begin(), plane.power.end()}});
        if (!plane.variance.empty())
            channels.push_back({layer + "variance", {plane.variance.begin(), plane.variance.end()}});
    };
    if (spectrum.dimension == 2) {
        add("", spectrum);
    } else {
        for (const PlanePlace& place : shown_planes(spectrum.size))
            add(plane_name(place) + ".", spectrum_plane(spectrum, place));
    }
    write_image(path, header_of(spectrum, spectrum.size, metadata), channels);
}

void write_spectrum_volume(const std::filesystem::path& path, const Spectrum& volume,
                           const std::map<std::string, std::string>& metadata)
{
    if (volume.dimension != 3) throw std::invalid_argument("write_spectrum_volume: needs a 3D spectrum");
    std::vector<Channel> channels = {{"Y", {volume.power.begin(), volume.power.end()}}};
    write_image(path, header_of(volume, volume.size * volume.size, metadata), channels);
}

std::vector<Spectrum> read_spectrum_planes(const std::filesystem::path& path)
{
    return reading(path, [&] {
        Imf::InputFile file(path.c_str());
        Spectrum plane;
        plane.size = checked_size(file.header());
        plane.points = count_attribute(file.header(), points_name, 1UL << 53);
        plane.realizations = static_cast<int>(count_attribute(file.header(), realizations_name, INT_MAX));

        const auto pixels = static_cast<std::size_t>(plane.size) * plane.size;
        const auto layers = checked_layers(file.header(), plane.size);
        std::vector<Channel> channels;
        for (const auto& layer : layers) {
            channels.push_back({layer + "Y", std::vector<float>(pixels)});
            if (has_float_channel(file.header(), layer + "variance"))
                channels.push_back({layer + "variance", std::vector<float>(pixels)});
        }
        file.setFrameBuffer(frame_buffer(channels, plane.size));
        file.readPixels(0, plane.size - 1);
        std::vector<Spectrum> planes;
        for (const Channel& channel : channels) {
            const bool is_power = channel.name.ends_with("Y");
            if (is_power) planes.push_back(plane);
            auto& values = is_power ? planes.back().power : planes.back().variance;
            values.assign(channel.pixels.begin(), channel.pixels.end());
        }
        return planes;
    });
}

}
