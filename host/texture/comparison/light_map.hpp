// Lightness of pictures, numbers at the places of a rectangle, and smaller pictures.
#pragma once

#include "base/images/png_file.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace poissonlab {

/// Numbers row by row.
struct LightMap
{
    int width = 0;
    int height = 0;
    std::vector<double> values;

    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    double at(int x, int y) const { return values[index(x, y)]; }
};

/// The lightness of pixels, in levels: of colours 0.299 R + 0.587 G + 0.114 B (ITU-R BT.601).
LightMap lightness_map(const PngPixels& picture);

/// The standard deviations within squares of `side` values, side by side.
LightMap contrast_map(const LightMap& map, int side);

/// The part of a picture from (left, top) on.
PngPixels picture_part(const PngPixels& picture, int left, int top, int width, int height);

/// Returns a picture whose pixels are means over squares of `factor` x `factor` pixels. Incomplete squares at the
/// eastern and southern borders are dropped.
struct ReducedPicture
{
    PngPixels pixels;
    int factor = 1;
};

/// Reduces a picture to at most `most` pixels, by the least factor, which is at most `most_factor`.
ReducedPicture reduced_picture(const PngPixels& picture, std::size_t most,
                               int most_factor = std::numeric_limits<int>::max());

}
