#include "analysis/spectra/spectrum_planes.hpp"

#include <algorithm>
#include <stdexcept>

namespace poissonlab {

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
