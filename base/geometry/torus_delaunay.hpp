// Delaunay triangulations of point sets on the unit torus, and the Voronoi cells that are dual to them.
//
// They are CGAL's periodic triangulations, with exact predicates. The two files behind this header and the one behind
// plane_delaunay.hpp are the only ones that include CGAL: its templates take half a minute to compile.
#pragma once

#include "base/geometry/point_set.hpp"

#include <array>
#include <functional>
#include <vector>

namespace poissonlab {

/// A corner of a Delaunay triangle or tetrahedron: a point of the unit square or cube, and in which image of it the
/// corner lies.
template <int D>
struct DelaunayCorner
{
    std::array<double, D> position{};
    std::array<int, D> image{};
};

template <int D>
using DelaunaySimplex = std::array<DelaunayCorner<D>, D + 1>;

/// Shows every triangle (2D) or tetrahedron (3D) of the triangulation once. Coinciding points are one corner. The set
/// must not be empty and have the dimension in question; coordinates must lie in [0, 1).
void visit_triangles(const PointSet& points, const std::function<void(const DelaunaySimplex<2>&)>& visit);
void visit_tetrahedra(const PointSet& points, const std::function<void(const DelaunaySimplex<3>&)>& visit);

/// Throws MissingModule where this program was built without triangulations in 3D. Long work that will call for them
/// asks before it begins.
void need_triangulations_3d();

/// The Voronoi cell of a position, relative to it.
template <int D>
struct TorusCell
{
    using Position = std::array<double, D>;
    using Polygon = std::vector<Position>;

    Position site{};
    /// 2D: one polygon, counterclockwise. 3D: the faces, in either orientation. Vertices are circumcentres: where more
    /// than D + 1 cells meet, they are told apart by rounding only.
    std::vector<Polygon> faces;
    double squared_near = 0; ///< to the nearest neighbouring position, or image of the site
};

/// Shows the cell of every position that has a point, in the order of the triangulation's vertices. The same conditions
/// as above.
void visit_voronoi_cells_2d(const PointSet& points, const std::function<void(const TorusCell<2>&)>& visit);
void visit_voronoi_cells_3d(const PointSet& points, const std::function<void(const TorusCell<3>&)>& visit);

}
