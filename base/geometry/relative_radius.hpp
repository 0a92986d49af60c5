// The radius specification of Lagae and Dutre (dissertation, section 4.2.3).
//
// The papers' disk radius r is HALF the minimum distance between points. This code speaks of
// min_distance (2 r) and of relative_radius (rho = r / rmax = min_distance / max_min_distance).
#pragma once

#include <cstddef>

namespace poissonlab {

/// The largest minimum distance that N points on the unit torus can have, 2 rmax: that of the densest
/// packing, hexagonal in 2D (equation 4.2), face-centred cubic in 3D (equation 4.5). Unit lengths.
/// `points` >= 1, `dimension` 2 or 3.
double max_min_distance(std::size_t points, int dimension);

/// min_distance / max_min_distance(points, dimension).
double relative_radius(double min_distance, std::size_t points, int dimension);

/// relative_radius * max_min_distance(points, dimension).
double min_distance_for(double relative_radius, std::size_t points, int dimension);

/// The frequency of the first peak of that packing's spectrum, cycles along an axis: its reciprocal lattice's shortest
/// vectors are sqrt(2 / sqrt 3) sqrt N long in 2D and sqrt 3 cbrt(N / 4) in 3D.
double principal_frequency(std::size_t points, int dimension);

/// The fraction of the unit torus that disks (spheres) of diameter min_distance around the points cover.
double covered_fraction(double min_distance, std::size_t points, int dimension);

/// Covered fraction of random sequential addition at saturation, in the limit of many points.
/// 2D 0.5470735(28), 3D 0.3841307(21): Zhang and Torquato, Phys. Rev. E 88, 053312 (2013).
double saturation_covered_fraction(int dimension);

/// The relative radius of saturated random sequential addition: 0.7767 in 2D, 0.8035 in 3D.
/// No dart throwing places (many) points at a larger one.
double saturation_relative_radius(int dimension);

}
