// The largest empty circle (2D) or ball (3D) of a point set on the unit torus: the largest gap.
//
// Its radius is also the coverage radius, the smallest with which disks around all points cover the torus:
// the counterpart of the minimum distance (in the theory of Delone sets, R to r). A set is a maximal Poisson
// disk set exactly if the radius is not above its minimum distance: Lagae and Dutre, A comparison of methods
// for generating Poisson disk distributions, Computer Graphics Forum 27(1), 2008; Ebeida et al., Efficient
// maximal Poisson-disk sampling, ACM Transactions on Graphics 30(4), 2011. The centre is a Voronoi vertex:
// the circle is the largest circumcircle of the Delaunay triangulation (Toussaint, Computing largest empty
// circles with location constraints, 1983). From CGAL's periodic triangulations, with exact predicates.
#pragma once

#include "base/geometry/point_set.hpp"

#include <array>

namespace poissonlab {

struct LargestEmptyBall
{
    double radius = 0;              ///< in unit lengths
    double relative_radius = 0;     ///< radius / max_min_distance(N): 1 / sqrt 3 for the hexagonal lattice
    std::array<double, 3> centre{}; ///< in [0, 1); one of several where they tie; 2D: z is 0

    bool operator==(const LargestEmptyBall&) const = default;
};

/// The largest ball that no point lies inside of. Radii are within some 1e-10 relative, whatever the position
/// of the points; coinciding points count as one, but N counts all of them. Throws InputError for the empty
/// set and dimensions other than 2 and 3. Coordinates must lie in [0, 1). Runs on one thread; lattices in 3D,
/// with eight and more points on every sphere, take some ten times as long as irregular sets.
LargestEmptyBall largest_empty_ball(const PointSet& points);

}
