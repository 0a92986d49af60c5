// Following a wave from the middle of a picture to its rim.
//
// A small part of a picture says a wave's period and slope too coarsely for the whole, where it would soon be half of a
// period off. In a part twice as large it is less than that, and is found again there by its power; and so on. As
// numbers change little, the picture is turned back by the wave as it is known once a part, and sums of blocks of
// pixels stand for them.
#pragma once

#include "host/texture/comparison/light_map.hpp"

#include <cmath>

namespace poissonlab {

// The view of a plane in a picture: the two numbers of a projective map that do not keep parallels.

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

    bool operator==(const Slope&) const = default;

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

/// A wave of a plane that is seen at a slope: periods over half of the picture's width and height, in the plane.
struct SeenWave
{
    double x = 0;
    double y = 0;
    Slope slope;

    /// Periods from the middle to a place of the picture.
    double periods(const Place& seen) const
    {
        const Place place = slope.above(seen);
        return x * place.x + y * place.y;
    }
};

struct TrackedWave
{
    SeenWave wave;
    double share = 0; ///< of the picture's variance, that the wave and its harmonics hold
    double kept = 0;  ///< that share in parts of the one in the middle
};

/// A wave that is known in the middle, in so large a part of the picture's sides. `has_slope`: whether the slope is
/// looked for as well. The result does not depend on the number of threads.
TrackedWave tracked(const LightMap& light, double part, const SeenWave& wave, bool has_slope);

}
