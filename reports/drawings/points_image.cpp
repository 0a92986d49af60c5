#include "reports/drawings/points_image.hpp"

#include "base/geometry/relative_radius.hpp"

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

}
