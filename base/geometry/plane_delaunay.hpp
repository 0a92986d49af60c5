// Delaunay triangulations of points in the plane, from CGAL, with exact predicates.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

using PlanePosition = std::array<double, 2>;

/// A triangle: the numbers of its points, counterclockwise; and beside each one that of the triangle across from it,
/// or UINT32_MAX where there is none.
struct PlaneTriangle
{
    std::array<std::uint32_t, 3> points{};
    std::array<std::uint32_t, 3> across{};
};

/// The triangles of a set of points. Of points that coincide, one is in the triangulation.
std::vector<PlaneTriangle> plane_triangles(std::span<const PlanePosition> points);

/// The centre of the circle through three points that do not lie on a line.
PlanePosition circumcentre(const PlanePosition& a, const PlanePosition& b, const PlanePosition& c);

}
