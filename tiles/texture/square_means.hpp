// Computes means over squares of a picture, which vary less the larger the squares are.
//
// For a random field, the variance of local averages begins to fall at the scale of fluctuation (VanMarcke, Random
// Fields, 1983, chapter 5), which is the size of the picture's features. For larger squares it falls as one over the
// area.
#pragma once

#include "base/images/png_file.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace poissonlab {

/// Returns the sum over the channels of each pixel.
std::vector<double> channel_sums(const PngPixels& picture);

/// Holds sums over all rectangles of numbers that lie row by row. The mean is subtracted first, so that sums stay
/// small. Results are the same on any number of threads.
class SquareMeans
{
public:
    SquareMeans(std::span<const double> values, int width);

    /// Returns the mean over columns and rows, from the first up to but without the last.
    double mean(int left, int top, int right, int bottom) const;

    /// Returns the variance of the means over all squares of a side.
    double variance(int side) const;

    /// Returns the interpolated side of squares whose means have the variance `least`; larger squares have less. There
    /// is none if squares of half of the shorter side still have more.
    std::optional<double> side_of_variance(double least) const;

private:
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * (static_cast<std::size_t>(width_) + 1) + static_cast<std::size_t>(x);
    }

    int width_, height_;
    double mean_;
    std::vector<double> sums_; ///< over all numbers above and to the left, with a row and a column of zeros
};

}
