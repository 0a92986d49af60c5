// Measures of points on the unit sphere: their spectrum in spherical harmonics, distances, and the discrepancy of caps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// The power of points x_1, ..., x_N in the real spherical harmonics of the degrees 1 to `highest`, 2 l + 1 of each
/// degree l: |sum of Y(x_i)|^2 4 pi / N, where the square of Y has the integral 1. Random points have 1 on average. The
/// mean of a degree is the sum of the Legendre polynomials P_l(x_i . x_j) of all pairs over N, whatever the axis.
/// `highest` is at most 1,000: Legendre functions of higher degrees leave the range of doubles.
std::vector<double> harmonic_powers(std::span<const std::array<double, 3>> points, std::uint32_t highest);

/// The eigenvalues l (l + 1) of these harmonics.
std::vector<double> harmonic_eigenvalues(std::uint32_t highest);

struct SpherePairs
{
    double least = 0;        ///< the least angle of two points; radians
    double mean_nearest = 0; ///< the mean angle to the nearest point

    /// The mean square discrepancy of spherical caps, 3 N D^2, which is 1 for random points on average. D^2 is the
    /// square of the part of the points in a cap less the part of the area, over caps around all places and all heights
    /// t from -1 to 1. By Stolarsky's invariance principle (1973; Brauchart and Dick, A simple proof of Stolarsky's
    /// invariance principle, 2013) it is a quarter of 4/3 less the mean distance of all N^2 pairs through space.
    double cap_discrepancy = 0;
};

/// Visits all pairs of two points or more.
SpherePairs sphere_pairs(std::span<const std::array<double, 3>> points);

}
