// Cosines and sines whose last bits do not depend on a library.
#pragma once

#include <array>

namespace poissonlab {

/// Cosine and sine of `part` turns, 0 <= part <= 1, by their series.
std::array<double, 2> circle_point(double part);

}
