// The distance of the two nearest of many points, by CGAL.
#pragma once

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The shortest edge of the Delaunay triangulation, squared: the distance of the two nearest points in the plane.
inline double squared_distance_by_cgal(const std::vector<std::array<std::int64_t, 3>>& points)
{
    using DistanceKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<DistanceKernel::Point_2> positions;
    for (const auto& p : points) positions.emplace_back(p[0], p[1]);
    CGAL::Delaunay_triangulation_2<DistanceKernel> triangulation(positions.begin(), positions.end());
    double least = 1e300;
    for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge)
        least = std::min(least, triangulation.segment(*edge).squared_length());
    return least;
}

}
