// Differences of a tiling with texture tiles from its exemplar, as pictures: steps by their place in the tile, power on
// the lattice of tiles, and colours.
#pragma once

#include "base/images/png_file.hpp"

#include <optional>
#include <vector>

namespace poissonlab {

/// Mean differences between neighbours by the place in a tile, in parts of the exemplar's mean in the same direction.
struct StepMap
{
    int size = 0;              ///< T
    std::vector<double> steps; ///< T x T, means of both directions, rows from the north: to the east and to the south
    double border = 0;         ///< mean over the steps from tile to tile
    double largest = 0;        ///< the largest mean over a column of steps to the east, or a row of steps to the south
};

/// The map of a tiling of whole tiles of size x size pixels, with the exemplar's channels.
StepMap step_map(const PngPixels& tiling, const PngPixels& exemplar, int size);

/// The part of the tiling's power, without its mean, at frequencies that are whole multiples of one over `width` pixels
/// to the east and of one over `height` pixels to the south: by Parseval's theorem the variance of the mean over all
/// rectangles of this size, over that of all pixels. Sums over channels. What does not fill a rectangle takes no part.
double lattice_power(const PngPixels& tiling, int width, int height);

/// Returns the share of the power on a lattice beyond chance. For `squares` rectangles of `pixels` pixels, the lattice
/// holds pixels - 1 of the squares x pixels - 1 frequencies, and white noise has that share of its power on it. The
/// result is 0 for white noise on average, and 1 for one repeated rectangle. `squares` and `pixels` are at least 2.
double beyond_chance(double share, double squares, double pixels);

/// Says how much of a tiling recurs: lattice_power() beyond chance. There is no value for fewer than two rectangles,
/// and without any power.
std::optional<double> recurrence(const PngPixels& tiling, int width, int height);

/// Returns the sum over channels of the variance of a picture's values.
double variance_of_channels(const PngPixels& picture);

/// The part of a picture's power, without its mean, at frequencies below one over `period` pixels, in any direction: of
/// its periodogram, summed over channels.
double slow_power(const PngPixels& picture, double period);

/// Says how much of the power is light and colour that change over more than a tile: slow_power() with a period of two
/// tiles, of the exemplar and of a tiling. A periodogram depends on its window: without the mean, 8 frequencies of
/// 256^2 pixels are below 1/128, but 192 of 1024^2, half as many more a pixel. The larger picture is therefore measured
/// by the mean over windows as large as the smaller one, so that pictures of one law have the same expected share.
/// There is no value if such a window has no such frequency, or if the exemplar has no power there.
struct SlowPower
{
    double exemplar = 0;
    double tiling = 0;
};
std::optional<SlowPower> slow_powers(const PngPixels& tiling, const PngPixels& exemplar, int size);

/// The mean over channels of the area between the cumulative distributions of two pictures' values: by how many levels
/// out of 255 pixels of one must change on average to have the other's colours.
double color_distance(const PngPixels& one, const PngPixels& other);

}
