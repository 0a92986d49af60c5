// The picture of the zone plate that infinitely many samples would give.
//
// The dissertation (section 6.2.3, figure 6.3) takes a million stratified samples a pixel. Their limit is
//
//   (1 + S / W) / 2,   S = integral of w(x, y) sin(x^2 + y^2),   W = integral of w(x, y)
//
// over the part of the filter's support that lies on the plate. Filter, support and plate are products of the
// axes, and sin(x^2 + y^2) is the imaginary part of exp(i x^2) exp(i y^2): S is that of a product of two
// integrals along an axis, one a column and one a row. There is nothing to sample.
//
// The zone plate: a function whose frequency grows with the distance from the origin, to sample point sets
// with. Where its picture turns to noise or to rings that are not there, the set has too few points.
//
// Dissertation, section 6.2.3, equation 6.7. Unit square and plate: a point p of a set samples at 48 p.
#pragma once

#include "analysis/zone_plate/reconstruction.hpp"

#include <cmath>
#include <numbers>

namespace poissonlab {

/// The reference of `size` x `size` pixels, each within 2e-12 of the exact value: integrals are by
/// Gauss-Legendre quadrature, whose own error is below 1e-20, so that what remains is the rounding of phases
/// x^2 up to 48^2. It has no aliasing, but what the filter lets through of frequencies above half a cycle per
/// pixel is there, as faint rings: postaliasing, of which no set of points is to blame.
SquareImage zone_plate_reference(int size);

/// The plate is [0, 48)^2.
inline constexpr double plate_side = 48;

/// (1 + sin(x^2 + y^2)) / 2, for x and y on the plate.
inline double zone_plate(double x, double y) { return 0.5 + 0.5 * std::sin(x * x + y * y); }

/// The frequency of the plate at a distance from the origin, in cycles per pixel of a picture of `size`
/// pixels along each axis: the phase r^2 grows by 2 r per unit, so that there are r / pi cycles per unit.
/// Pixels can show up to 1/2.
inline double plate_frequency(double distance, int size) { return distance / std::numbers::pi * plate_side / size; }

/// The plate as `reconstruct` makes it from its values at a 2D set of points, with one_sample_a_pixel: 512 x 512
/// pixels for 262,144 points. The origin is at the lower left; values may lie a little outside of [0, 1]. Throws as
/// reconstruct() does.
SquareImage zone_plate_image(const PointSet& points);

}
