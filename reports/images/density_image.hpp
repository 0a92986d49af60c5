// Pictures of what is 1 on average: densities, pair correlations.
#pragma once

#include "base/images/grey_image.hpp"
#include "base/images/square_image.hpp"

namespace poissonlab {

/// Grey values: 0 is black, 1 in the middle, 2 and more white, linear between. Each pixel becomes a square of
/// `magnification` pixels; the lowest y is at the bottom.
GreyImage draw_density(const SquareImage& image, int magnification = 1);

}
