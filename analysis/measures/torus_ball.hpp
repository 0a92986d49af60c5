// The volume of a ball on the unit torus, where it overlaps itself as well.
//
// The toroidal distance of two points is the length of their difference reduced to the cube [-1/2, 1/2)^d, so
// that the points within r of another are as many as the ball of radius r and that cube have in common:
// Theodorou and Suter, Geometrical considerations in model systems with periodic boundaries, J. Chem.
// Phys. 82, 955 (1985). The closed forms, with h = 1/2:
//
//   2D  pi r^2                                                                  r <= h
//       pi r^2 - 4 (r^2 acos(h/r) - h sqrt(r^2 - h^2))      four segments less  r <= sqrt 2 h
//   3D  4/3 pi r^3                                                              r <= h
//       4/3 pi r^3 - 6 pi/3 (r - h)^2 (2 r + h)             six caps less       r <= sqrt 2 h
//       2 z1 + 2 (F(h) - F(z1)),  z1 = sqrt(r^2 - 2 h^2)    caps overlap        r <= sqrt 3 h
//
// The last one is the integral of the 2D form over slices at heights z, of disks with rho^2 = r^2 - z^2: they
// fill the square for |z| < z1. F is the antiderivative of the 2D form in z (by parts).
//
// In a box with other sides it is the whole ball as far as half of the shortest side, which is as far as it is asked
// for.
#pragma once

#include "base/geometry/periodic_box.hpp"

namespace poissonlab {

/// The largest toroidal distance: sqrt(dimension) / 2. `dimension` 2 or 3.
double largest_toroidal_distance(int dimension);

/// The area (2D) or volume (3D) of all positions within `radius` of a point, within 1e-15; 0 for radii below
/// 0, 1 beyond largest_toroidal_distance. It is also the distribution function of the toroidal distance of
/// two independent uniform points.
double torus_ball_volume(double radius, int dimension);

/// The area or volume of such positions in a periodic box, for radii up to half of its shortest side where it is no
/// square (cube).
double torus_ball_volume(double radius, int dimension, const PeriodicBox& box);

/// The distribution function of the distance of two independent uniform points of the unit square or cube, for
/// distances up to 1: pi r^2 - 8/3 r^3 + r^4/2, and 4/3 pi r^3 - 3/2 pi r^4 + 8/5 r^5 - r^6/6. From the volume that
/// the square and its shifted copy have in common, the product of 1 - |x_k|, averaged over directions.
double window_pair_volume(double distance, int dimension);

}
