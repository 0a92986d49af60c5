#include "base/geometry/torus_delaunay.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>

#include <algorithm>

namespace poissonlab {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Periodic_2_Delaunay_triangulation_traits_2<Kernel>;
using Triangulation = CGAL::Periodic_2_Delaunay_triangulation_2<Traits>;

Triangulation triangulation_of(const PointSet& points)
{
    std::vector<Kernel::Point_2> positions;
    for (std::size_t i = 0; i < points.size(); ++i) positions.emplace_back(points[i][0], points[i][1]);
    Triangulation triangulation(Traits::Iso_rectangle_2(0, 0, 1, 1));
    triangulation.insert(positions.begin(), positions.end(), true);
    return triangulation;
}

TorusCell<2> cell_of(const Triangulation& triangulation, Triangulation::Vertex_handle site)
{
    TorusCell<2> cell{{site->point().x(), site->point().y()}, {{}}, 2};
    auto face = triangulation.incident_faces(site);
    const auto first = face;
    do {
        const auto triangle = triangulation.triangle(triangulation.periodic_triangle(face));
        const int own = face->index(site);
        const auto p = triangle.vertex(own);
        const auto a = triangle.vertex(Triangulation::ccw(own)) - p;
        const auto b = triangle.vertex(Triangulation::cw(own)) - p;
        const auto centre = CGAL::circumcenter(Kernel::Point_2(CGAL::ORIGIN), CGAL::ORIGIN + a, CGAL::ORIGIN + b);
        cell.faces[0].push_back({centre.x(), centre.y()});
        cell.squared_near = std::min(cell.squared_near, a.squared_length());
    } while (++face != first);
    return cell;
}

}

void visit_triangles(const PointSet& points, const std::function<void(const DelaunaySimplex<2>&)>& visit)
{
    const Triangulation triangulation = triangulation_of(points);
    for (auto face = triangulation.faces_begin(); face != triangulation.faces_end(); ++face) {
        const auto triangle = triangulation.periodic_triangle(face);
        DelaunaySimplex<2> simplex;
        for (std::size_t i = 0; i < simplex.size(); ++i) {
            const auto& [point, image] = triangle[i];
            simplex[i] = {{point.x(), point.y()}, {image.x(), image.y()}};
        }
        visit(simplex);
    }
}

void visit_voronoi_cells_2d(const PointSet& points, const std::function<void(const TorusCell<2>&)>& visit)
{
    const Triangulation triangulation = triangulation_of(points);
    for (auto v = triangulation.unique_vertices_begin(); v != triangulation.unique_vertices_end(); ++v)
        visit(cell_of(triangulation, v));
}

}
