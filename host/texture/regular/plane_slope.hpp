// How a plane was seen in a picture: the two numbers of a projective map that do not keep parallels.
#pragma once

#include <cmath>

namespace poissonlab {

/// A place is in pixels, or in halves of a picture's sides from its middle.
struct Place
{
    double x = 0;
    double y = 0;
};

/// The place (x, y) of the plane, from the middle, in halves of the picture's sides, is at
/// (x, y) / (1 + east x + south y) of the picture.
struct Slope
{
    double east = 0;
    double south = 0;

    /// Half of the side of the square around the middle that lies within the picture.
    double reach() const { return 1 - std::abs(east) - std::abs(south); }
    Place seen(const Place& place) const
    {
        const double nearness = 1 + east * place.x + south * place.y;
        return {place.x / nearness, place.y / nearness};
    }
    /// The other way.
    Place above(const Place& seen) const
    {
        const double nearness = 1 / (1 - east * seen.x - south * seen.y);
        return {seen.x * nearness, seen.y * nearness};
    }
};

}
