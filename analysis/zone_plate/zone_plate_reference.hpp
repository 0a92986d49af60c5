// The picture of the zone plate that infinitely many samples would give.
//
// The dissertation (section 6.2.3, figure 6.3) takes a million stratified samples a pixel. Their limit is
//
//   (1 + S / W) / 2,   S = integral of w(x, y) sin(x^2 + y^2),   W = integral of w(x, y)
//
// over the part of the filter's support that lies on the plate. Filter, support and plate are products of the
// axes, and sin(x^2 + y^2) is the imaginary part of exp(i x^2) exp(i y^2): S is that of a product of two
// integrals along an axis, one a column and one a row. There is nothing to sample.
#pragma once

#include "analysis/zone_plate/reconstruction.hpp"

namespace poissonlab {

/// The reference of `size` x `size` pixels, each within 2e-12 of the exact value: integrals are by
/// Gauss-Legendre quadrature, whose own error is below 1e-20, so that what remains is the rounding of phases
/// x^2 up to 48^2. It has no aliasing, but what the filter lets through of frequencies above half a cycle per
/// pixel is there, as faint rings: postaliasing, of which no set of points is to blame.
SquareImage zone_plate_reference(int size);

}
