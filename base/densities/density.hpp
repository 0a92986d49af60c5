// Densities that points follow: pictures and formulas as exact integers, from which every device gets the same points.
#pragma once

#include "base/images/linear_picture.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

/// The weight of the densest place.
inline constexpr std::uint64_t full_weight = std::uint64_t{1} << 40;

/// A density over a rectangle, constant in each of its pixels, in parts of the largest one. Row by row from the bottom:
/// y goes up. At least one weight is full_weight.
struct Density
{
    int width = 0;
    int height = 0;
    std::vector<std::uint64_t> weights;
    std::string note{}; ///< for users, where numbers below 0 became 0: "name: 3 pixels below 0 ..."

    /// The weight at a place of the rectangle, whose sides are 1 here: 0 <= x, y < 1.
    std::uint64_t at(double x, double y) const
    {
        const auto column = static_cast<std::size_t>(x * width), row = static_cast<std::size_t>(y * height);
        return weights[row * static_cast<std::size_t>(width) + column];
    }
};

/// The density of numbers for all pixels, row by row from the bottom: each over the largest one times full_weight,
/// rounded down. Those of clamp_rounding() are 0, and the note says so. Throws InputError, a sentence that starts with
/// `name` and the pixel, for others that are negative or not finite, and where all are 0.
Density density_of_values(int width, int height, std::vector<double> values, const std::string& name);

/// The luminance of a pixel, by column and row from the top left: that of Rec. 709, which is that of sRGB as well. A
/// picture without three colours is grey: its first channel.
double luminance(const LinearPicture& picture, int column, int row);

/// The density of a picture. `channel` says what of it: "light", its luminance; "ink", 1 - luminance; or the name of a
/// channel. Throws InputError, one line with the picture's name, for an unknown channel, ink of pixels that are
/// brighter than 1, and what density_of_values() refuses. Pixels are named by column and row from the top left.
Density density_of_picture(const LinearPicture& picture, std::string_view channel, const std::string& name);

}
