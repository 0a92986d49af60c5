#include "analysis/measures/voronoi_diagram.hpp"

#include "base/errors/errors.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace poissonlab {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_2_Delaunay_triangulation_traits_2<Kernel>;
using Triangulation = CGAL::Periodic_2_Delaunay_triangulation_2<Traits>;
using Position = std::array<double, 2>;
using Polygon = std::vector<Position>;

/// Some hundred times the rounding of circumcentres, of coordinates up to 1.
constexpr double shortest_edge = 1e-13;

/// Circumcentres of the triangles around a site: the vertices of its cell, counterclockwise and relative to
/// the site.
Polygon circumcentres(const Triangulation& triangulation, Triangulation::Vertex_handle site)
{
    Polygon polygon;
    auto face = triangulation.incident_faces(site);
    const auto first = face;
    do {
        const auto triangle = triangulation.triangle(triangulation.periodic_triangle(face));
        const int own = face->index(site);
        const auto p = triangle.vertex(own);
        const auto a = triangle.vertex(Triangulation::ccw(own)) - p;
        const auto b = triangle.vertex(Triangulation::cw(own)) - p;
        const auto centre = CGAL::circumcenter(Kernel::Point_2(CGAL::ORIGIN), CGAL::ORIGIN + a, CGAL::ORIGIN + b);
        polygon.push_back({centre.x(), centre.y()});
    } while (++face != first);
    return polygon;
}

/// Each corner once, and the start fixed: which triangles meet at a corner of four or more cells, and which
/// one comes first, is up to the triangulation.
Polygon tidy(const Polygon& polygon)
{
    Polygon corners;
    const auto differ = [&](const Position& p, const Position& q) {
        return std::hypot(p[0] - q[0], p[1] - q[1]) >= shortest_edge;
    };
    for (const Position& p : polygon) {
        if (corners.empty() || differ(p, corners.back())) corners.push_back(p);
    }
    while (corners.size() > 1 && !differ(corners.front(), corners.back())) corners.pop_back();
    const auto direction = [](const Position& p) { return std::atan2(p[1], p[0]); };
    std::rotate(corners.begin(), std::ranges::min_element(corners, {}, direction), corners.end());
    return corners;
}

double area_of(const Polygon& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Position& p = polygon[i];
        const Position& q = polygon[(i + 1) % polygon.size()];
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
    std::vector<Kernel::Point_2> positions;
    std::map<Position, std::size_t> owners;
    for (std::size_t i = 0; i < points.size(); ++i) {
        positions.emplace_back(points[i][0], points[i][1]);
        owners.try_emplace({points[i][0], points[i][1]}, i);
    }
    Triangulation triangulation(Traits::Iso_rectangle_2(0, 0, 1, 1));
    triangulation.insert(positions.begin(), positions.end(), true);

    VoronoiDiagram diagram{std::vector<VoronoiCell>(points.size())};
    for (auto v = triangulation.unique_vertices_begin(); v != triangulation.unique_vertices_end(); ++v) {
        VoronoiCell& cell = diagram.cells[owners.at({v->point().x(), v->point().y()})];
        cell.polygon = tidy(circumcentres(triangulation, v));
        cell.area = area_of(cell.polygon);
        cell.neighbours = static_cast<int>(cell.polygon.size());
    }
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
