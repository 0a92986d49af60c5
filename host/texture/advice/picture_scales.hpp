// The scales of a picture: how wide the things are that it shows, and whether it is alike everywhere.
//
// Means over squares vary less the larger the squares are. For a random field, the variance of local averages begins to
// fall at the scale of fluctuation (VanMarcke, Random Fields, 1983, chapter 5), which is the size of the picture's
// features. For larger squares it falls as one over the area.
#pragma once

#include "host/texture/comparison/light_map.hpp"

#include <optional>

namespace poissonlab {

/// A picture whose pixels are means over squares of `factor` x `factor` pixels; what is left over at the eastern and
/// southern borders is dropped.
struct ReducedPicture
{
    PngPixels pixels;
    int factor = 1;
};

/// Reduces a picture to at most `most` pixels, by the least factor.
ReducedPicture reduced_picture(const PngPixels& picture, std::size_t most);

/// Subtracts from each value the mean over a square of 2 reach + 1 values around it, as far as it is in the map: what
/// changes slowly is gone.
LightMap without_slow_light(const LightMap& light, int reach);

/// Returns the side of the squares, between whole numbers, whose means have the part `share` of the variance of all
/// values. It returns nothing if squares of half of the shorter side still have more, or if all values are the same.
std::optional<double> side_at_share(const LightMap& light, double share);

}
