// The reconstruction filter of Mitchell and Netravali (1988) with B = C = 1/3.
//
// Separable, as in that paper: in 2D the weight is the product of two of these, 4 x 4 pixels wide. Both
// cubics are equation 8 of the paper with B = C = 1/3.
#pragma once

namespace poissonlab {

/// The weight at a distance of t >= 0 pixels; 0 from 2 on. Integer shifts of it sum to 1 everywhere, and so
/// does its integral.
constexpr double mitchell_weight(double t)
{
    if (t < 1) return ((21 * t - 36) * t * t + 16) / 18;
    if (t < 2) return (((-7 * t + 36) * t - 60) * t + 32) / 18;
    return 0;
}

}
