// The looks of drawings: their pixels, and the exact areas of their shapes.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "tests/support/picture.hpp"

#include <map>
#include <string>

namespace poissonlab::test {

/// A drawing as PNG, read back.
ColorPicture drawn(const Drawing& drawing, int pixels_wide);

/// Pictures whose pixels are `scale` a unit.
class Pixels
{
public:
    Pixels(const Drawing& drawing, int scale);

    /// The colour of the pixel at a place in units of the drawing.
    std::string at(double x, double y) const;
    std::string at(const DrawingPoint& p) const { return at(p[0], p[1]); }

private:
    int scale_;
    ColorPicture picture_;
};

/// Square units (shoelace formula).
double area_of(const std::vector<DrawingPoint>& outline);

/// The sum of the areas of all shapes with a fill, which must be polygons; overlaps count twice.
std::map<std::string, double> filled_areas(const Drawing& drawing);

}
