// Polygons of meshes as triangles, by CGAL.
#include "base/surfaces/triangle_mesh.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

namespace poissonlab {

std::vector<MeshTriangle> polygon_triangles(const std::vector<MeshPoint>& corners)
{
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    struct Triangle
    {
        Triangle(int a, int b, int c) : corners{a, b, c} {}
        std::array<int, 3> corners;
    };
    std::vector<Point> polyline;
    polyline.reserve(corners.size());
    for (const auto& [x, y, z] : corners) polyline.emplace_back(x, y, z);
    std::vector<Triangle> filled;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
        polyline, std::back_inserter(filled), CGAL::parameters::use_2d_constrained_delaunay_triangulation(false));
    std::vector<MeshTriangle> triangles;
    triangles.reserve(filled.size());
    for (const Triangle& t : filled)
        triangles.push_back({static_cast<std::uint32_t>(t.corners[0]), static_cast<std::uint32_t>(t.corners[1]),
                             static_cast<std::uint32_t>(t.corners[2])});
    return triangles;
}

}
