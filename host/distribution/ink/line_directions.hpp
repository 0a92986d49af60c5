// The directions of lines in a picture, for strokes that follow them: across the steepest change of its smoothed
// structure tensor.
//
// Bigün and Granlund, Optimal orientation detection of linear symmetry, 1987. The dissertation says nothing of the
// directions of its strokes (section 7.3).
#pragma once

#include "base/densities/density_values.hpp"

#include <vector>

namespace poissonlab {

class LineDirections
{
public:
    /// `otherwise`: the direction where the picture is even, in radians.
    LineDirections(const PixelValues& picture, double otherwise);

    /// The direction at a place in pixels, in radians from the x axis; lines have no arrows.
    double at(double x, double y) const;

private:
    int width_;
    double otherwise_;
    std::vector<double> xx_, xy_, yy_;
};

}
