// Voronoi cells in 3D from CGAL's periodic Delaunay triangulation.
#include "host/sampling/reference/voronoi_cells.hpp"

#include "host/sampling/reference/coincident_points.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <array>
#include <cmath>
#include <list>

namespace poissonlab::reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
using Triangulation = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;
using Position = std::array<double, 3>;
using Polygon = std::vector<Position>;

struct Cell
{
    double volume = 0;
    Position moment{};
    double energy = 0;
};

/// The centre of the sphere through a cell's vertices, relative to its vertex `site`.
Position centre_relative_to(const Triangulation& triangulation, Triangulation::Cell_handle cell,
                            Triangulation::Vertex_handle site)
{
    const auto tetrahedron = triangulation.construct_tetrahedron(triangulation.periodic_tetrahedron(cell));
    const int own = cell->index(site);
    const auto p = tetrahedron.vertex(own);
    const auto at = [&](int i) { return CGAL::ORIGIN + (tetrahedron.vertex((own + i) % 4) - p); };
    const auto centre = CGAL::circumcenter(at(0), at(1), at(2), at(3));
    return {centre.x(), centre.y(), centre.z()};
}

/// The faces of the Voronoi cell, relative to the site, in either orientation; and the squared distance of
/// the nearest Voronoi neighbour.
std::vector<Polygon> faces_of(const Triangulation& triangulation, Triangulation::Vertex_handle site,
                              double& squared_near)
{
    std::list<Triangulation::Edge> edges;
    triangulation.incident_edges(site, std::back_inserter(edges));
    std::vector<Polygon> faces;
    squared_near = 3;
    for (const Triangulation::Edge& edge : edges) {
        const auto segment = triangulation.construct_segment(triangulation.periodic_segment(edge));
        squared_near = std::min(squared_near, segment.squared_length());
        Polygon& face = faces.emplace_back();
        auto cell = triangulation.incident_cells(edge);
        const auto first = cell;
        do {
            face.push_back(centre_relative_to(triangulation, cell, site));
        } while (++cell != first);
    }
    return faces;
}

/// The part of a face on one side of the site (Sutherland and Hodgman).
Polygon clipped(const Polygon& face, Share share)
{
    if (share == Share::all) return face;
    const double side = share == Share::left ? -1 : 1;
    Polygon result;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Position& p = face[i];
        const Position& q = face[(i + 1) % face.size()];
        if (side * p[0] >= 0) result.push_back(p);
        if ((side * p[0] >= 0) == (side * q[0] >= 0)) continue;
        const double t = p[0] / (p[0] - q[0]);
        result.push_back({0, p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])});
    }
    return result;
}

void add_tetrahedron(const Position& p, const Position& q, const Position& r, Cell& cell)
{
    const double volume = std::abs(p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                                   p[2] * (q[0] * r[1] - q[1] * r[0])) /
                          6;
    cell.volume += volume;
    for (int k = 0; k < 3; ++k) {
        const double sum = p[k] + q[k] + r[k];
        cell.moment[k] += volume * sum / 4;
        cell.energy += volume * (sum * sum + p[k] * p[k] + q[k] * q[k] + r[k] * r[k]) / 20;
    }
}

Cell integrate(const std::vector<Polygon>& faces, Share share)
{
    Cell cell;
    if (share == Share::nothing) return cell;
    // Pyramids with the site as apex. The face that clipping makes holds the site, so it adds nothing.
    for (const Polygon& whole : faces) {
        const Polygon face = clipped(whole, share);
        for (std::size_t i = 2; i < face.size(); ++i) add_tetrahedron(face[0], face[i - 1], face[i], cell);
    }
    return cell;
}

}

VoronoiCells voronoi_cells_3d(const PointSet& points)
{
    std::vector<Triangulation::Point> positions;
    for (std::size_t i = 0; i < points.size(); ++i) {
        positions.emplace_back(points[i][0], points[i][1], points[i][2]);
    }
    Triangulation triangulation(Traits::Iso_cuboid_3(0, 0, 0, 1, 1, 1));
    triangulation.insert(positions.begin(), positions.end(), true);

    const std::size_t n = points.size();
    VoronoiCells cells{3, std::vector<double>(n), std::vector<double>(3 * n), std::vector<double>(n),
                       std::vector<double>(n)};
    const PositionIndex index(points);
    for (auto v = triangulation.unique_vertices_begin(); v != triangulation.unique_vertices_end(); ++v) {
        const Position position{v->point().x(), v->point().y(), v->point().z()};
        const auto sites = index.at(position);
        double squared_near = 0;
        const std::vector<Polygon> faces = faces_of(triangulation, v, squared_near);
        for (std::size_t i = 0; i < sites.size(); ++i) {
            const Cell cell = integrate(faces, share_of(i, sites.size()));
            const std::size_t id = sites[i];
            cells.volumes[id] = cell.volume;
            cells.energies[id] = cell.energy;
            cells.squared_near[id] = sites.size() > 1 ? 0 : squared_near;
            for (std::size_t k = 0; k < 3; ++k) {
                cells.displacements[3 * id + k] = cell.volume > 0 ? cell.moment[k] / cell.volume : 0;
            }
        }
    }
    return cells;
}

}
