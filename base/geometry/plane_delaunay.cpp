#include "base/geometry/plane_delaunay.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>

namespace poissonlab {
namespace {

using PlaneKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using NumberedVertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, PlaneKernel>;
using NumberedFace = CGAL::Triangulation_face_base_with_info_2<std::uint32_t, PlaneKernel>;
using PlaneTriangulation =
    CGAL::Delaunay_triangulation_2<PlaneKernel, CGAL::Triangulation_data_structure_2<NumberedVertex, NumberedFace>>;

}

std::vector<PlaneTriangle> plane_triangles(std::span<const PlanePosition> points)
{
    std::vector<std::pair<PlaneKernel::Point_2, std::uint32_t>> numbered;
    numbered.reserve(points.size());
    for (const PlanePosition& point : points)
        numbered.emplace_back(PlaneKernel::Point_2(point[0], point[1]), static_cast<std::uint32_t>(numbered.size()));
    const PlaneTriangulation triangulation(numbered.begin(), numbered.end());
    for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
        face->info() = UINT32_MAX;
    std::uint32_t count = 0;
    for (const auto face : triangulation.finite_face_handles()) face->info() = count++;
    std::vector<PlaneTriangle> triangles;
    triangles.reserve(count);
    for (const auto face : triangulation.finite_face_handles()) {
        PlaneTriangle& triangle = triangles.emplace_back();
        for (int i = 0; i < 3; ++i) {
            triangle.points[static_cast<std::size_t>(i)] = face->vertex(i)->info();
            triangle.across[static_cast<std::size_t>(i)] = face->neighbor(i)->info();
        }
    }
    return triangles;
}

PlanePosition circumcentre(const PlanePosition& a, const PlanePosition& b, const PlanePosition& c)
{
    const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
    const double twice = 2 * (bx * cy - by * cx), bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    return {a[0] + (cy * bb - by * cc) / twice, a[1] + (bx * cc - cx * bb) / twice};
}

}
