// One Lloyd iteration in 2D as users of CGAL would write it, in the two usual ways.
#pragma once

#include "base/geometry/point_set.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cmath>
#include <utility>
#include <vector>

namespace poissonlab::bench {

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPoint = CgalKernel::Point_2;

/// Adds the triangles of a polygon, which is given vertex by vertex, to its centroid.
class CentroidSum
{
public:
    void add(double x, double y)
    {
        if (count_++ == 0) {
            first_x_ = x;
            first_y_ = y;
        } else {
            const double cross = (last_x_ - first_x_) * (y - first_y_) - (last_y_ - first_y_) * (x - first_x_);
            area_ += cross;
            x_ += cross * (last_x_ + x + first_x_) / 3;
            y_ += cross * (last_y_ + y + first_y_) / 3;
        }
        last_x_ = x;
        last_y_ = y;
    }
    CgalPoint centroid() const { return {x_ / area_, y_ / area_}; }

private:
    int count_ = 0;
    double first_x_ = 0, first_y_ = 0, last_x_ = 0, last_y_ = 0, area_ = 0, x_ = 0, y_ = 0;
};

/// Centroids from a periodic Delaunay triangulation.
inline std::vector<CgalPoint> cgal_periodic_centroids(const std::vector<CgalPoint>& points)
{
    using Traits = CGAL::Periodic_2_Delaunay_triangulation_traits_2<CgalKernel>;
    using Triangulation = CGAL::Periodic_2_Delaunay_triangulation_2<Traits>;
    Triangulation triangulation(Traits::Iso_rectangle_2(0, 0, 1, 1));
    triangulation.insert(points.begin(), points.end(), true);
    std::vector<CgalPoint> centroids;
    centroids.reserve(points.size());
    for (auto v = triangulation.unique_vertices_begin(); v != triangulation.unique_vertices_end(); ++v) {
        CentroidSum sum;
        auto face = triangulation.incident_faces(v);
        const auto first = face;
        do {
            const auto triangle = triangulation.triangle(triangulation.periodic_triangle(face));
            const auto centre = CGAL::circumcenter(triangle[0], triangle[1], triangle[2]);
            const auto shift = v->point() - triangle[face->index(v)];
            sum.add(centre.x() + shift.x(), centre.y() + shift.y());
        } while (++face != first);
        centroids.push_back(sum.centroid());
    }
    return centroids;
}

/// Centroids from a plain Delaunay triangulation of the square with copies of the points in a margin around
/// it.
inline std::vector<CgalPoint> cgal_ghost_centroids(const std::vector<CgalPoint>& points)
{
    using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, CgalKernel>;
    using Structure = CGAL::Triangulation_data_structure_2<Vertex>;
    using Triangulation = CGAL::Delaunay_triangulation_2<CgalKernel, Structure>;
    const double margin = 5 / std::sqrt(static_cast<double>(points.size()));
    std::vector<std::pair<CgalPoint, std::size_t>> all;
    all.reserve(points.size() * 5 / 4);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const double x = points[i].x() + dx;
                const double y = points[i].y() + dy;
                if (x < -margin || y < -margin || x >= 1 + margin || y >= 1 + margin) continue;
                all.emplace_back(CgalPoint(x, y), dx == 0 && dy == 0 ? i : points.size());
            }
        }
    }
    const Triangulation triangulation(all.begin(), all.end());
    std::vector<CgalPoint> centroids(points.size());
    for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v) {
        if (v->info() == points.size()) continue;
        CentroidSum sum;
        auto face = triangulation.incident_faces(v);
        const auto first = face;
        do {
            const auto centre = triangulation.circumcenter(face);
            sum.add(centre.x(), centre.y());
        } while (++face != first);
        centroids[v->info()] = sum.centroid();
    }
    return centroids;
}

}
