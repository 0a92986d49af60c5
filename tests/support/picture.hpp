// Pictures read back, to check that they show something.
#pragma once

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

/// Throws std::runtime_error for bytes that are not a PNG.
Picture decode_png(const std::string& bytes);

}
