#include "reports/drawings/cells_image.hpp"

#include "analysis/measures/voronoi_diagram.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace poissonlab {

namespace {

constexpr std::size_t most_cells_shown_whole = 600;
constexpr double cells_in_window = 400;
constexpr double margin_in_spacings = 8;
constexpr double cells_size = 640;
constexpr double dot_radius = 2.2; // units of the drawing

using Position = std::array<double, 2>;

/// A square of the torus with its lower left corner at (-margin, -margin).
struct CutOut
{
    double margin = 0;
    double size = 1;
};

double reach(const VoronoiCell& cell)
{
    double longest = 0;
    for (const auto& corner : cell.polygon) longest = std::max(longest, std::hypot(corner[0], corner[1]));
    return longest;
}

bool meets_window(const ShownCell& cell, double window)
{
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto along = [&](const Position& corner) { return corner[axis]; };
        const auto [low, high] = std::ranges::minmax(cell.polygon, {}, along);
        if (along(low) >= window || along(high) <= 0) return false;
    }
    return true;
}

ShownCell moved(const VoronoiCell& cell, const Position& point, double scale)
{
    ShownCell shown{point, cell.neighbours, {}};
    for (const auto& corner : cell.polygon)
        shown.polygon.push_back({point[0] + scale * corner[0], point[1] + scale * corner[1]});
    return shown;
}

/// All cells of the torus, with images of those that reach across its border.
CellsView whole_view(const PointSet& points, double window)
{
    const auto diagram = voronoi_diagram(points);
    CellsView view{window, {}};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (diagram.cells[i].polygon.empty()) continue;
        for (const double dx : {0.0, -1.0, 1.0})
            for (const double dy : {0.0, -1.0, 1.0}) {
                auto cell = moved(diagram.cells[i], {points[i][0] + dx, points[i][1] + dy}, 1);
                if (meets_window(cell, window)) view.cells.push_back(std::move(cell));
            }
    }
    return view;
}

/// The points in the cut-out, whose size becomes 1.
PointSet points_in(const CutOut& cut, const PointSet& points)
{
    PointSet inside;
    inside.dimension = 2;
    for (std::size_t i = 0; i < points.size(); ++i) {
        Position p{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double x = points[i][axis] + cut.margin;
            p[axis] = (x - std::floor(x)) / cut.size;
        }
        if (p[0] < 1 && p[1] < 1) inside.coordinates.insert(inside.coordinates.end(), p.begin(), p.end());
    }
    return inside;
}

/// The view from the cut-out alone. A corner of a cell is right where the circle around it through the cell's point, in
/// which there is no other point, lies inside the cut-out. Nothing where that is not so for all cells that are shown.
std::optional<CellsView> cut_out_view(const PointSet& points, double window, const CutOut& cut)
{
    const auto inside = points_in(cut, points);
    if (inside.size() < 1) return std::nullopt;
    const auto diagram = voronoi_diagram(inside);
    CellsView view{window, {}};
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const auto p = inside[i];
        const auto& cell = diagram.cells[i];
        if (cell.polygon.empty()) continue;
        auto shown = moved(cell, {p[0] * cut.size - cut.margin, p[1] * cut.size - cut.margin}, cut.size);
        if (!meets_window(shown, window)) continue;
        const double border = std::min({p[0], p[1], 1 - p[0], 1 - p[1]});
        if (2 * reach(cell) > border) return std::nullopt;
        view.cells.push_back(std::move(shown));
    }
    return view;
}

}

CellsView choose_cells_view(const PointSet& points)
{
    const auto total = static_cast<double>(points.size());
    if (points.size() <= most_cells_shown_whole) return whole_view(points, 1);
    const double window = std::sqrt(cells_in_window / total);
    const double margin = margin_in_spacings / std::sqrt(total);
    const CutOut cut{margin, window + 2 * margin};
    if (cut.size < 1)
        if (auto view = cut_out_view(points, window, cut)) return *view;
    return whole_view(points, window);
}

std::size_t cell_class(int neighbours) { return static_cast<std::size_t>(std::clamp(neighbours, 4, 8) - 4); }

std::string cell_class_name(std::size_t cell_class)
{
    static const std::array<std::string, cell_classes> names = {"up to 4", "5", "6", "7", "8 and more"};
    return names.at(cell_class);
}

std::string cell_class_color(std::size_t cell_class)
{
    static const std::array<std::string, cell_classes> colors = {"#0072b2", "#56b4e9", "#f3f1ea", "#f0b429", "#d55e00"};
    return colors.at(cell_class);
}

Drawing draw_cells(const CellsView& view)
{
    Drawing drawing{cells_size, cells_size, {}};
    const double scale = cells_size / view.window;
    const auto place = [&](const Position& p) -> DrawingPoint { return {scale * p[0], cells_size - scale * p[1]}; };
    for (const auto& cell : view.cells) {
        Polygon outline;
        for (const auto& corner : cell.polygon) outline.push_back(place(corner));
        drawing.shapes.push_back({std::move(outline), cell_class_color(cell_class(cell.neighbours)), "#6b7078", 0.8});
    }
    for (const auto& cell : view.cells) drawing.shapes.push_back({Disk{place(cell.point), dot_radius}, "#1d2024", {}});
    return drawing;
}

}
