#include "analysis/measures/voronoi_diagram.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/torus_delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace poissonlab {

namespace {

using CellCorner = std::array<double, 2>;
using Polygon = std::vector<CellCorner>;

/// Some hundred times the rounding of circumcentres, of coordinates up to 1.
constexpr double shortest_edge = 1e-13;

/// Each corner once, and the start fixed: which triangles meet at a corner of four or more cells, and which
/// one comes first, is up to the triangulation.
Polygon tidy(const Polygon& polygon)
{
    Polygon corners;
    const auto differ = [&](const CellCorner& p, const CellCorner& q) {
        return std::hypot(p[0] - q[0], p[1] - q[1]) >= shortest_edge;
    };
    for (const CellCorner& p : polygon) {
        if (corners.empty() || differ(p, corners.back())) corners.push_back(p);
    }
    while (corners.size() > 1 && !differ(corners.front(), corners.back())) corners.pop_back();
    const auto direction = [](const CellCorner& p) { return std::atan2(p[1], p[0]); };
    std::rotate(corners.begin(), std::ranges::min_element(corners, {}, direction), corners.end());
    return corners;
}

double area_of(const Polygon& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const CellCorner& p = polygon[i];
        const CellCorner& q = polygon[(i + 1) % polygon.size()];
        twice += p[0] * q[1] - p[1] * q[0];
    }
    return twice / 2;
}

}

VoronoiDiagram voronoi_diagram(const PointSet& points)
{
    if (points.dimension != 2) throw InputError("Voronoi diagram: the point set must be 2D");
    if (points.size() == 0) throw InputError("Voronoi diagram: the point set must not be empty");

    // The first point at each position has the cell.
    std::map<CellCorner, std::size_t> owners;
    for (std::size_t i = 0; i < points.size(); ++i) owners.try_emplace({points[i][0], points[i][1]}, i);

    VoronoiDiagram diagram{std::vector<VoronoiCell>(points.size())};
    visit_voronoi_cells_2d(points, [&](const TorusCell<2>& found) {
        VoronoiCell& cell = diagram.cells[owners.at(found.site)];
        cell.polygon = tidy(found.faces[0]);
        cell.area = area_of(cell.polygon);
        cell.neighbours = static_cast<int>(cell.polygon.size());
    });
    return diagram;
}

VoronoiStatistics voronoi_statistics(const VoronoiDiagram& diagram)
{
    VoronoiStatistics statistics;
    if (diagram.cells.empty()) return statistics;
    const auto n = static_cast<double>(diagram.cells.size());
    double mean = 0;
    for (const VoronoiCell& cell : diagram.cells) {
        mean += cell.area / n;
        statistics.neighbour_share[static_cast<std::size_t>(std::clamp(cell.neighbours, 4, 8) - 4)] += 1;
    }
    for (double& share : statistics.neighbour_share) share /= n;
    for (const VoronoiCell& cell : diagram.cells) {
        const double difference = cell.area / mean - 1;
        statistics.relative_area_variance += difference * difference / n;
    }
    return statistics;
}

}
