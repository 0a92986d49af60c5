#include "analysis/spectra/spectrum_file.hpp"

#include "base/errors/errors.hpp"
#include "base/images/float_image.hpp"

#include <algorithm>
#include <charconv>
#include <climits>
#include <stdexcept>

namespace poissonlab {
namespace {

const std::string points_name = "poissonlab:points";
const std::string realizations_name = "poissonlab:realizations";

/// The prefixes of channel names: "" for a 2D spectrum, the planes of a 3D one.
std::vector<std::string> layers_of(int dimension, int size)
{
    if (dimension == 2) return {""};
    std::vector<std::string> layers;
    for (const PlanePlace& place : shown_planes(size)) layers.push_back(plane_name(place) + ".");
    return layers;
}

/// An image with the attributes of a spectrum, without channels.
FloatImage image_of(const Spectrum& spectrum, int height, const std::map<std::string, std::string>& metadata)
{
    FloatImage image{spectrum.size, height, {}, {}};
    image.texts[points_name] = std::to_string(spectrum.points);
    image.texts[realizations_name] = std::to_string(spectrum.realizations);
    for (const auto& [name, value] : metadata) image.texts[metadata_prefix + name] = value;
    return image;
}

unsigned long count_attribute(const FloatImage& image, const std::string& name, unsigned long largest)
{
    const std::string& text = image.text(name);
    unsigned long count = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (status != std::errc{} || end != text.data() + text.size() || count > largest)
        throw std::runtime_error("the attribute " + name + " = \"" + shortened(text) +
                                 "\" must be an integer from 0 to " + std::to_string(largest));
    return count;
}

/// The layers of the spectrum that the channels hold.
std::vector<std::string> checked_layers(const FloatImage& image)
{
    if (image.width % 2 != 0)
        throw std::runtime_error("a spectrum has an even size, not " + std::to_string(image.width));
    for (const int dimension : {2, 3}) {
        const auto layers = layers_of(dimension, image.width);
        if (std::ranges::all_of(layers, [&](const auto& layer) { return image.channels.contains(layer + "Y"); }))
            return layers;
    }
    throw std::runtime_error("there is no float32 channel \"Y\", nor those of the planes of a 3D spectrum");
}

/// The planes of a spectrum's image. Throws std::runtime_error for other images.
std::vector<Spectrum> planes_of(const FloatImage& image)
{
    std::vector<Spectrum> planes;
    for (const std::string& layer : checked_layers(image)) {
        Spectrum& plane = planes.emplace_back();
        plane.size = image.width;
        plane.points = count_attribute(image, points_name, 1UL << 53);
        plane.realizations = static_cast<int>(count_attribute(image, realizations_name, INT_MAX));
        const auto& power = image.channels.at(layer + "Y");
        plane.power.assign(power.begin(), power.end());
        if (const auto variance = image.channels.find(layer + "variance"); variance != image.channels.end())
            plane.variance.assign(variance->second.begin(), variance->second.end());
    }
    return planes;
}

}

void write_spectrum(const std::filesystem::path& path, const Spectrum& spectrum,
                    const std::map<std::string, std::string>& metadata)
{
    FloatImage image = image_of(spectrum, spectrum.size, metadata);
    const auto add = [&](const std::string& layer, const Spectrum& plane) {
        image.channels[layer + "Y"] = {plane.power.begin(), plane.power.end()};
        if (!plane.variance.empty())
            image.channels[layer + "variance"] = {plane.variance.begin(), plane.variance.end()};
    };
    if (spectrum.dimension == 2) {
        add("", spectrum);
    } else {
        for (const PlanePlace& place : shown_planes(spectrum.size))
            add(plane_name(place) + ".", spectrum_plane(spectrum, place));
    }
    write_float_image(path, image);
}

void write_spectrum_volume(const std::filesystem::path& path, const Spectrum& volume,
                           const std::map<std::string, std::string>& metadata)
{
    if (volume.dimension != 3) throw std::invalid_argument("write_spectrum_volume: needs a 3D spectrum");
    FloatImage image = image_of(volume, volume.size * volume.size, metadata);
    image.channels["Y"] = {volume.power.begin(), volume.power.end()};
    write_float_image(path, image);
}

std::vector<Spectrum> read_spectrum_planes(const std::filesystem::path& path)
{
    try {
        return planes_of(read_float_image(path));
    } catch (const std::exception& error) {
        throw InputError(path.string() + ": not a spectrum: " + error.what());
    }
}

const char* plane_axes(const PlanePlace& place) { return place.axis == 2 ? "xy" : place.axis == 1 ? "xz" : "yz"; }

std::string plane_name(const PlanePlace& place)
{
    const std::string axes = plane_axes(place);
    return place.frequency == 0 ? axes : axes + "_" + std::to_string(place.frequency);
}

std::vector<PlanePlace> shown_planes(int size)
{
    std::vector<PlanePlace> places;
    for (const PlanePlace place :
         {PlanePlace{2, 0}, PlanePlace{1, 0}, PlanePlace{0, 0}, PlanePlace{2, -size / 2}, PlanePlace{1, -size / 2},
          PlanePlace{0, -size / 2}, PlanePlace{2, size / 16}, PlanePlace{2, size / 8}, PlanePlace{2, 3 * size / 16}}) {
        const bool known = std::ranges::find(places, place) != places.end(); // spectra of a few frequencies
        if (!known && place.frequency < size / 2) places.push_back(place);
    }
    return places;
}

Spectrum spectrum_plane(const Spectrum& volume, const PlanePlace& place)
{
    const int half = volume.size / 2;
    if (volume.dimension != 3 || place.axis < 0 || place.axis > 2 || place.frequency < -half || place.frequency >= half)
        throw std::invalid_argument("spectrum_plane: needs a 3D spectrum, an axis 0, 1 or 2, and a frequency in it");
    const auto size = static_cast<std::size_t>(volume.size);
    const std::size_t stride[3] = {1, size, size * size};
    const std::size_t across = stride[place.axis == 0 ? 1 : 0], up = stride[place.axis == 2 ? 1 : 2];
    const std::size_t first = static_cast<std::size_t>(place.frequency + half) * stride[place.axis];
    const auto cut = [&](const std::vector<double>& values) {
        std::vector<double> plane;
        if (values.empty()) return plane;
        plane.reserve(size * size);
        for (std::size_t v = 0; v < size; ++v)
            for (std::size_t u = 0; u < size; ++u) plane.push_back(values[first + u * across + v * up]);
        return plane;
    };
    return {2,
            volume.size,
            volume.points,
            volume.realizations,
            cut(volume.power),
            cut(volume.variance),
            volume.transform_error};
}

}
