#include "reports/drawings/points_image.hpp"

#include "base/geometry/relative_radius.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace poissonlab {

namespace {

constexpr std::size_t most_points_shown_whole = 2000;
constexpr double points_in_window = 1500;
constexpr double dot_per_disk = 1.0 / 3.0;
constexpr double largest_dot = 0.02; // of the window
constexpr int image_size = 1024;

// A window side that holds about `points_in_window` of `points`, with two significant digits.
double window_side(double points)
{
    if (points <= most_points_shown_whole) return 1;
    const double side = std::sqrt(points_in_window / points);
    const double unit = std::pow(10.0, std::floor(std::log10(side)) - 1);
    return std::round(side / unit) * unit;
}

// Darkens the pixels that a dot covers; coordinates in pixels from the upper left corner.
void draw_dot(GreyImage& image, double x, double y, double radius)
{
    const auto first = [](double v) { return std::max(0, static_cast<int>(std::floor(v))); };
    const auto last = [](double v, int size) { return std::min(size - 1, static_cast<int>(std::ceil(v))); };
    for (int row = first(y - radius - 1); row <= last(y + radius, image.height); ++row)
        for (int column = first(x - radius - 1); column <= last(x + radius, image.width); ++column) {
            const double distance = std::hypot(column + 0.5 - x, row + 0.5 - y);
            const double coverage = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
            const auto grey = static_cast<std::uint8_t>(std::lround(255 * (1 - coverage)));
            image.at(column, row) = std::min(image.at(column, row), grey);
        }
}

}

PointsView choose_points_view(const PointSet& points)
{
    PointsView view;
    view.total = points.size();
    const auto total = static_cast<double>(view.total);
    if (points.dimension == 3) view.depth = std::min(1.0, max_min_distance(view.total, 3));
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

GreyImage draw_points(const PointsView& view)
{
    GreyImage image(image_size, image_size, 255);
    for (std::size_t i = 0; i < view.visible.size(); i += 2)
        draw_dot(image, view.visible[i] * image_size, (1 - view.visible[i + 1]) * image_size,
                 0.5 * view.dot_diameter * image_size);
    return image;
}

std::string points_svg(const PointsView& view)
{
    // A dot is a line of no length with round ends: the shortest way to write many.
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"600\" height=\"600\" viewBox=\"0 0 1000 1000\">\n"
        "<path fill=\"none\" stroke=\"#000\" stroke-linecap=\"round\" stroke-width=\"{:.2f}\" d=\"",
        1000 * view.dot_diameter);
    for (std::size_t i = 0; i < view.visible.size(); i += 2)
        fmt::format_to(std::back_inserter(svg), "M{:.1f} {:.1f}h0\n", 1000 * view.visible[i],
                       1000 * (1 - view.visible[i + 1]));
    return svg + "\"/>\n</svg>\n";
}

}
