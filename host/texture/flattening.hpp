// A picture whose light differs from side to side becomes one that is equally light everywhere.
//
// Tiles put parts of a picture side by side in another order. Light that changes over more than a tile cannot go on
// from one to the next, so that bright and dark parts become a pattern of their own. As texture artists do, the mean
// around each pixel, by weights of a Gaussian of half a tile, is subtracted, and the mean of the picture is added.
//
// Values are those of the file, of 8 bits sRGB: equal steps look about equally large there, so that a dark part that
// becomes brighter keeps the contrast that one sees. In linear light its contrast would remain too small, and bright
// parts that become darker would lose what is dark in them below black. Channels are separate, so that casts of colour
// go as well.
#pragma once

#include "base/images/png_file.hpp"
#include "base/images/raw_picture.hpp"

#include <cstddef>

namespace poissonlab {

/// The picture for tiles of size x size pixels; `clipped` becomes the number of values that would be below 0 or above
/// 255. Beside the rim, where half of the Gaussian is outside, the mean is that of the straight line that fits best
/// along each axis (local linear regression): a ramp of light goes everywhere. The picture has at least two pixels
/// along each axis.
PngPixels flattened(const PngPixels& picture, int size, std::size_t& clipped);

/// Flattens the channels of a picture of any type of numbers that read_exemplar() shows, which must be finite: three
/// colours, or the first one alone. Alpha, depths, normals and others stay as they are. Whole numbers are clipped, and
/// floating-point ones that would become negative; `clipped` becomes their number.
RawPicture flattened(const RawPicture& picture, int size, std::size_t& clipped);

/// Says how much of a picture's variation is light that differs over more than a tile.
struct UnevenLight
{
    double share = 0;     ///< slow_power() below one over two tiles
    double by_chance = 0; ///< what a texture of such features has without any uneven light, on average
    double most = 0;      ///< what one in a thousand of such textures has; 0 of smooth pictures, see is_smooth()
    bool is_uneven() const;
};

/// Measures a picture. The share is 0 where the picture has no such frequency, since it is at most two tiles wide.
///
/// A picture of more than 2^20 pixels is measured by means over boxes of f x f pixels, f being at most a sixteenth of a
/// tile. A mean over f pixels keeps the part sin(x) / x of a wave's amplitude along an axis, x = pi f times its
/// frequency. Below 1/(2 T) that is more than 1 - x^2 / 6 with x <= pi / 32, so that at most 0.4 % of the slow power is
/// lost. Waves whose frequencies differ by less than 1/(2 T) from a multiple of 1/f look slow in the means, with at
/// most 1/31 of their amplitude, which is 0.11 % of their power.
///
/// The power spectrum of a texture without slow light is flat below the size of its features. If its correlation is
/// exp(-d^2 / 2 s^2), its integral is 2 pi s^2, so that the part of the power below 1/(2 T) is 2 pi s^2 pi / (2 T)^2.
/// feature_side(), the side of squares whose means have half of the variance, is 2.35 s of such a texture: the share is
/// 0.89 (feature_side / T)^2. Features are measured after flattening, as slow light would enlarge them.
/// The spectrum of a real picture is symmetric, so that the power of n frequencies in n / 2 pairs f and -f varies as
/// chi-squared with n degrees of freedom. A smooth picture has no edges that tell features from light: all of it counts
/// as light.
UnevenLight uneven_light(const PngPixels& picture, int size);

}
