// Voronoi cells in 2D from CGAL's periodic Delaunay triangulation.
#include "host/sampling/reference/voronoi_cells.hpp"

#include "host/sampling/reference/coincident_points.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>

#include <array>
#include <cmath>

namespace poissonlab::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_2_Delaunay_triangulation_traits_2<Kernel>;
using Triangulation = CGAL::Periodic_2_Delaunay_triangulation_2<Traits>;
using Position = std::array<double, 2>;

struct Cell
{
    double area = 0;
    Position moment{};
    double energy = 0;
    double squared_near = 2;
};

/// The vertices of the Voronoi cell, counterclockwise and relative to the site, and the squared distance of
/// the nearest Voronoi neighbour.
std::vector<Position> polygon_of(const Triangulation& triangulation, Triangulation::Vertex_handle site,
                                 double& squared_near)
{
    std::vector<Position> polygon;
    squared_near = 2;
    auto face = triangulation.incident_faces(site);
    const auto first = face;
    do {
        const Triangulation::Triangle triangle = triangulation.triangle(triangulation.periodic_triangle(face));
        const int own = face->index(site);
        const auto p = triangle.vertex(own);
        const auto origin = CGAL::ORIGIN;
        const auto a = triangle.vertex(Triangulation::ccw(own)) - p;
        const auto b = triangle.vertex(Triangulation::cw(own)) - p;
        const auto centre = CGAL::circumcenter(origin + Kernel::Vector_2(0, 0), origin + a, origin + b);
        polygon.push_back({centre.x(), centre.y()});
        squared_near = std::min(squared_near, a.squared_length());
    } while (++face != first);
    return polygon;
}

/// The part of an edge on one side of the site; false where there is none.
bool clip(Position& p, Position& q, Share share)
{
    if (share == Share::all) return true;
    const double side = share == Share::left ? -1 : 1;
    if (side * p[0] < 0 && side * q[0] < 0) return false;
    if (side * p[0] >= 0 && side * q[0] >= 0) return true;
    const double y = (p[1] * q[0] - q[1] * p[0]) / (q[0] - p[0]);
    (side * p[0] < 0 ? p : q) = {0, y};
    return true;
}

Cell integrate(const std::vector<Position>& polygon, Share share)
{
    Cell cell;
    if (share == Share::nothing) return cell;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Position p = polygon[i];
        Position q = polygon[(i + 1) % polygon.size()];
        if (!clip(p, q, share)) continue;
        // A triangle with the site as its third vertex. What clipping cuts off ends at the site, so nothing
        // is missing.
        const double area = (p[0] * q[1] - p[1] * q[0]) / 2;
        cell.area += area;
        for (int k = 0; k < 2; ++k) {
            cell.moment[k] += area * (p[k] + q[k]) / 3;
            cell.energy += area * (p[k] * p[k] + q[k] * q[k] + p[k] * q[k]) / 6;
        }
    }
    return cell;
}

}

VoronoiCells voronoi_cells_2d(const PointSet& points)
{
    std::vector<Triangulation::Point> positions;
    for (std::size_t i = 0; i < points.size(); ++i) positions.emplace_back(points[i][0], points[i][1]);
    Triangulation triangulation(Traits::Iso_rectangle_2(0, 0, 1, 1));
    triangulation.insert(positions.begin(), positions.end(), true);

    const std::size_t n = points.size();
    VoronoiCells cells{2, std::vector<double>(n), std::vector<double>(2 * n), std::vector<double>(n),
                       std::vector<double>(n)};
    const PositionIndex index(points);
    for (auto v = triangulation.unique_vertices_begin(); v != triangulation.unique_vertices_end(); ++v) {
        const Position position{v->point().x(), v->point().y()};
        const auto sites = index.at(position);
        double squared_near = 0;
        const std::vector<Position> polygon = polygon_of(triangulation, v, squared_near);
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const Cell cell = integrate(polygon, share_of(i, sites.size()));
            const std::size_t id = sites[i];
            cells.volumes[id] = cell.area;
            cells.energies[id] = cell.energy;
            cells.squared_near[id] = sites.size() > 1 ? 0 : squared_near;
            for (std::size_t k = 0; k < 2; ++k) {
                cells.displacements[2 * id + k] = cell.area > 0 ? cell.moment[k] / cell.area : 0;
            }
        }
    }
    return cells;
}

}
