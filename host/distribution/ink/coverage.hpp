// Pictures of black marks whose pixels are as dark as the part of them that is covered.
//
// A disk's part of a pixel is the area that a circle and a polygon have in common; a stroke with round ends is a
// rectangle and two half disks. Where marks overlap in a pixel, what they have in common there is counted at 16 x 16
// places and taken off: pixels of marks that do not overlap are exact, others within some 1/256.
#pragma once

#include "results/pictures/mark_picture.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The corners of a convex polygon, counterclockwise.
struct ConvexPolygon
{
    std::array<std::array<double, 2>, 8> corners{};
    std::size_t count = 0;

    void add(const std::array<double, 2>& corner) { corners[count++] = corner; }
};

/// The area that a disk around the origin has in common with the polygon.
double disk_in_polygon(double radius, const ConvexPolygon& polygon);

/// The area that a stroke, x, y, x, y of its ends and its width, has in common with the square pixel from (x, y) on
/// whose side is 1. Ends are round: a stroke without length is a disk.
double stroke_in_pixel(const std::array<double, 5>& stroke, double x, double y);

struct Coverage
{
    int width = 0;
    int height = 0;
    std::vector<double> parts; ///< of pixels, 0 to 1, row by row from the bottom
    double laid = 0;           ///< the area of all marks inside the picture, in pixels
    double covered = 0;        ///< the sum of `parts`
};

/// The byte that makes a screen show the light of a pixel of which this part is covered: 1 - part, encoded as sRGB.
std::uint8_t shown_byte(double part);

/// The part that is covered as a viewer sees it, who decodes shown_byte() as sRGB: within 0.0045 of what it was, and
/// exact for nothing and for all.
double shown_part(std::uint8_t byte);

/// The covered part of each pixel of a picture, `scale` pixels to a unit of the marks. Throws Interrupted.
Coverage coverage_of(const MarkGroup& marks, int width, int height, double scale);

}
