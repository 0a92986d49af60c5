// A picture from samples of a function at the points of a set: how renderers use point sets.
//
// Dissertation, section 6.2.3: Mitchell filter, 4 x 4 pixels, divided by the sum of weights, as is usual
// since the number of samples around a pixel varies.
//
// The reconstruction filter of Mitchell and Netravali (1988) with B = C = 1/3.
//
// Separable, as in that paper: in 2D the weight is the product of two of these, 4 x 4 pixels wide. Both
// cubics are equation 8 of the paper with B = C = 1/3.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/images/square_image.hpp"

#include <cstddef>
#include <span>

namespace poissonlab {

/// The size with which so many points are one sample a pixel, about: round(sqrt(points)), at least 1.
int one_sample_a_pixel(std::size_t points);

/// Pixels whose weights sum to less than this, where a uniform density of one sample a pixel has 1, are not
/// divided by that sum: the filter has negative lobes, so sums of scattered samples can be small or negative,
/// and dividing by them would give anything. In such a gap a pixel shows the sample nearest to its centre.
inline constexpr double least_weight = 0.25;

/// The value of a pixel that has no sample in the 5 x 5 pixels around it.
inline constexpr double empty_pixel = 0.5;

/// The picture of `size` x `size` pixels from values[k] at point k: pixel p is
///
///   sum_k w_pk values[k] / sum_k w_pk,
///
/// w_pk being the Mitchell filter's weight of the way from the pixel's centre to the point, in pixels; see
/// least_weight for gaps. Samples do not wrap around: what is sampled need not be periodic, so pixels at the
/// border have samples on their inner side only.
///
/// The set must be 2D, not empty, and have a value a point (std::invalid_argument); coordinates in [0, 1).
/// O(N + size^2); sums are in an order that depends on the set alone: any number of threads gives the same
/// bytes.
SquareImage reconstruct(const PointSet& points, std::span<const double> values, int size);

/// The weight at a distance of t >= 0 pixels; 0 from 2 on. Integer shifts of it sum to 1 everywhere, and so
/// does its integral.
constexpr double mitchell_weight(double t)
{
    if (t < 1) return ((21 * t - 36) * t * t + 16) / 18;
    if (t < 2) return (((-7 * t + 36) * t - 60) * t + 32) / 18;
    return 0;
}

}
