#include "reports/drawings/points_image.hpp"

#include "base/geometry/relative_radius.hpp"
#include "reports/images/spectrum_image.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::size_t most_points_shown_whole = 2000;
constexpr double points_in_window = 1500;
constexpr double dot_per_disk = 1.0 / 3.0;
constexpr double largest_dot = 0.02; // of the window
constexpr double drawing_size = 1000;

/// A window side that holds about `points_in_window` of `points`, with two significant digits.
double window_side(double points)
{
    if (points <= most_points_shown_whole) return 1;
    const double side = std::sqrt(points_in_window / points);
    const double unit = std::pow(10.0, std::floor(std::log10(side)) - 1);
    return std::round(side / unit) * unit;
}

}

PointsView choose_points_view(const PointSet& points, const PeriodicBox& box)
{
    PointsView view;
    view.total = points.size();
    const auto total = static_cast<double>(view.total);
    if (!box.is_unit()) view.width = std::sqrt(box.sides[0] / box.sides[1]);
    if (points.dimension == 3) view.depth = std::min(1.0, max_min_distance(view.total, 3) / box.sides[2]);
    const double in_slab = points.dimension == 3 ? total * view.depth : total;
    view.window = window_side(in_slab);

    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto p = points[i];
        if (p[0] >= view.window || p[1] >= view.window) continue;
        if (points.dimension == 3 && p[2] >= view.depth) continue;
        view.visible.push_back(p[0] / view.window);
        view.visible.push_back(p[1] / view.window);
    }

    const double expected = std::max(1.0, in_slab * view.window * view.window);
    const double disk = max_min_distance(static_cast<std::size_t>(std::lround(expected)), 2);
    view.dot_diameter = std::min(largest_dot, dot_per_disk * disk);
    return view;
}

Drawing draw_points(const PointsView& view)
{
    const double width = drawing_size * view.width, height = drawing_size / view.width;
    Drawing drawing{width, height, {}};
    for (std::size_t i = 0; i < view.visible.size(); i += 2) {
        const DrawingPoint place{width * view.visible[i], height * (1 - view.visible[i + 1])};
        drawing.shapes.push_back({Disk{place, drawing_size * view.dot_diameter / 2}, "#000000", {}});
    }
    return drawing;
}

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
