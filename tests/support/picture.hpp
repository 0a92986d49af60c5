// Pictures read back, to check that they show something.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab::test {

/// A PNG as grey values.
struct Picture
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> grey;

    /// The variance of the grey values: 0 for a blank picture.
    double variance() const;
};

/// A PNG in colour.
struct ColorPicture
{
    int width = 0;
    int height = 0;
    std::vector<std::array<std::uint8_t, 3>> pixels; ///< red, green, blue; row after row from the top

    /// "#rrggbb". Throws std::out_of_range outside of the picture.
    std::string at(int column, int row) const;
};

/// Throws std::runtime_error for bytes that are not a PNG.
Picture decode_png(const std::string& bytes);
ColorPicture decode_color_png(const std::string& bytes);

}
