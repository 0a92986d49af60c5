#include "reports/drawings/plane_image.hpp"

#include "reports/images/spectrum_image.hpp"

#include <algorithm>

namespace poissonlab {

namespace {

constexpr double plane_letter_size = 11; // where planes have up to 255 pixels

/// A spectrum with its name above it.
struct NamedPlane
{
    const Spectrum& spectrum;
    std::string name;
    int column = 0;
    int row = 0;
};

Drawing draw_planes(const std::vector<NamedPlane>& planes, const ToneMapping& tone_mapping, int block)
{
    const int size = planes.front().spectrum.size / block;
    const int scale = std::max(1, size / 128);
    const int strip = 10 * scale; // above a plane, for its name
    const int gap = 2 * scale;
    const int columns = std::ranges::max_element(planes, {}, &NamedPlane::column)->column + 1;
    const int rows = std::ranges::max_element(planes, {}, &NamedPlane::row)->row + 1;
    Drawing drawing{double(columns * (size + gap) - gap), double(rows * (strip + size)), {}};
    for (const NamedPlane& plane : planes) {
        const double left = plane.column * (size + gap), top = plane.row * (strip + size);
        const GreyImage image = draw_spectrum(plane.spectrum, tone_mapping, block);
        drawing.shapes.push_back({Image{{left, top + strip}, double(size), {size, size, 1, image.pixels}}, {}, {}});
        drawing.shapes.push_back(
            {Text{{left + scale, top + strip - 3 * scale}, plane_letter_size * scale, plane.name}, "#000000", {}});
    }
    return drawing;
}

}

Drawing draw_spectrum_planes(const std::vector<Spectrum>& planes, const ToneMapping& tone_mapping, int block)
{
    return draw_planes({{planes.at(0), "xy", 0, 1}, {planes.at(1), "xz", 0, 0}, {planes.at(2), "yz", 1, 0}},
                       tone_mapping, block);
}

Drawing draw_plane_row(const std::vector<Spectrum>& planes, const std::vector<std::string>& names,
                       const ToneMapping& tone_mapping, int block)
{
    std::vector<NamedPlane> row;
    for (std::size_t i = 0; i < planes.size(); ++i) row.push_back({planes[i], names.at(i), static_cast<int>(i), 0});
    return draw_planes(row, tone_mapping, block);
}

Spectrum spectrum_close_up(const Spectrum& plane)
{
    const int half = std::max(1, 5 * plane.size / 16);
    Spectrum middle{2, 2 * half, plane.points, plane.realizations, {}};
    for (int y = -half; y < half; ++y)
        for (int x = -half; x < half; ++x) middle.power.push_back(plane.at(x, y));
    return middle;
}

}
