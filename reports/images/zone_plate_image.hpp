// The picture of the zone plate as a set of points sees it: 0 is black, 1 is white, linear in between.
#pragma once

#include "analysis/zone_plate/reconstruction.hpp"
#include "base/images/grey_image.hpp"

namespace poissonlab {

/// Grey values with the origin at the lower left; what the filter's lobes push out of [0, 1] is clipped.
/// Pixels are values, not light: no gamma, as in the dissertation.
GreyImage draw_zone_plate(const SquareImage& image);

}
