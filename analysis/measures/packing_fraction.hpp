// The packing fraction of a point set: the part of the unit torus that its largest disjoint disks cover.
//
// Lagae and Dutre, A comparison of methods for generating Poisson disk distributions, Computer Graphics Forum
// 27(1), 2008, measure the same by the relative radius: in 2D the packing fraction is its square times that
// of the hexagonal packing, pi / sqrt 12; in 3D its cube times that of the face-centred cubic packing,
// pi / sqrt 18.
#pragma once

#include "base/geometry/point_set.hpp"

namespace poissonlab {

/// The fraction of the unit torus covered by disks (balls) of radius min_distance / 2 around the points,
/// which do not overlap: N pi / 4 min_distance^2, in 3D N pi / 6 min_distance^3.
///
/// Exact up to rounding, as min_toroidal_distance is. A single point touches its own images at distance 1:
/// pi / 4, pi / 6. 0 for coinciding points and for the empty set.
double packing_fraction(const PointSet& points);

}
