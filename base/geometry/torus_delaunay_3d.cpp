#include "base/geometry/torus_delaunay.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>

#include <algorithm>
#include <list>
#include <utility>

namespace poissonlab {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
using Triangulation = CGAL::Periodic_3_Delaunay_triangulation_3<Traits>;

/// Inserted as a range, points start from a regular set that is removed at the end: fast, but not where only few points
/// are left.
constexpr std::size_t few = 100;

Triangulation triangulation_of(const PointSet& points)
{
    std::vector<Kernel::Point_3> positions;
    for (std::size_t i = 0; i < points.size(); ++i) positions.emplace_back(points[i][0], points[i][1], points[i][2]);
    Triangulation triangulation(Traits::Iso_cuboid_3(0, 0, 0, 1, 1, 1));
    if (positions.size() <= few)
        for (const auto& position : positions) triangulation.insert(position);
    else
        triangulation.insert(positions.begin(), positions.end(), true);
    return triangulation;
}

// The order in which CGAL holds the corners of tetrahedra, and tetrahedra around edges, depends on addresses in memory.
// Rounding depends on the order: cells are computed, and shown, in an order of coordinates.

/// The centre of the sphere through the vertices of a tetrahedron, relative to its vertex `site`.
std::array<double, 3> centre_relative_to(const Triangulation& triangulation, Triangulation::Cell_handle cell,
                                         Triangulation::Vertex_handle site)
{
    const auto tetrahedron = triangulation.construct_tetrahedron(triangulation.periodic_tetrahedron(cell));
    const int own = cell->index(site);
    const auto p = tetrahedron.vertex(own);
    const auto at = [&](int i) { return CGAL::ORIGIN + (tetrahedron.vertex((own + i) % 4) - p); };
    std::array others{at(1), at(2), at(3)};
    std::ranges::sort(others);
    const auto centre = CGAL::circumcenter(at(0), others[0], others[1], others[2]);
    return {centre.x(), centre.y(), centre.z()};
}

/// The polygon from its least corner on, towards the lesser of the two beside it.
TorusCell<3>::Polygon in_order(TorusCell<3>::Polygon polygon)
{
    std::ranges::rotate(polygon, std::ranges::min_element(polygon));
    if (polygon.back() < polygon[1]) std::reverse(polygon.begin() + 1, polygon.end());
    return polygon;
}

TorusCell<3> cell_of(const Triangulation& triangulation, Triangulation::Vertex_handle site)
{
    TorusCell<3> result{{site->point().x(), site->point().y(), site->point().z()}, {}, 3};
    std::list<Triangulation::Edge> edges;
    triangulation.incident_edges(site, std::back_inserter(edges));
    for (const Triangulation::Edge& edge : edges) {
        const auto segment = triangulation.construct_segment(triangulation.periodic_segment(edge));
        result.squared_near = std::min(result.squared_near, segment.squared_length());
        TorusCell<3>::Polygon face;
        auto cell = triangulation.incident_cells(edge);
        const auto first = cell;
        do {
            face.push_back(centre_relative_to(triangulation, cell, site));
        } while (++cell != first);
        result.faces.push_back(in_order(std::move(face)));
    }
    std::ranges::sort(result.faces);
    return result;
}

}

void need_triangulations_3d() {}

void visit_tetrahedra(const PointSet& points, const std::function<void(const DelaunaySimplex<3>&)>& visit)
{
    const Triangulation triangulation = triangulation_of(points);
    for (auto cell = triangulation.cells_begin(); cell != triangulation.cells_end(); ++cell) {
        const auto tetrahedron = triangulation.periodic_tetrahedron(cell);
        DelaunaySimplex<3> simplex;
        for (std::size_t i = 0; i < simplex.size(); ++i) {
            const auto& [point, image] = tetrahedron[i];
            simplex[i] = {{point.x(), point.y(), point.z()}, {image.x(), image.y(), image.z()}};
        }
        visit(simplex);
    }
}

void visit_voronoi_cells_3d(const PointSet& points, const std::function<void(const TorusCell<3>&)>& visit)
{
    const Triangulation triangulation = triangulation_of(points);
    for (auto v = triangulation.unique_vertices_begin(); v != triangulation.unique_vertices_end(); ++v)
        visit(cell_of(triangulation, v));
}

}
