// Windows of an exemplar that look like what is there: coarse to fine.
//
// Sums of squared differences of features over all windows of the exemplar at half its resolution, exact by transforms
// (masked_squares.hpp); the best of them are compared again pixel by pixel, with their neighbours.
#pragma once

#include "host/texture/masked_squares.hpp"
#include "host/texture/window_choice.hpp"

namespace poissonlab {

/// The means of 2 x 2 pixels each.
PngPixels halved(const PngPixels& picture);

class WindowSearch
{
public:
    /// For squares of so many pixels, an even number. `counts` are the pixels that are compared, row by row; none: all.
    /// The features must live longer.
    WindowSearch(const PngPixels& features, int side, const std::vector<std::uint8_t>& counts = {});

    int side() const { return side_; }
    const PngPixels& features() const { return features_; }

    /// The windows with the smallest differences from a picture of features, the best first: at most so many, not those
    /// that are used, nor those nearer than 4 pixels to ones that are `shown`.
    std::vector<ExemplarWindow> best(const PngPixels& canvas, const UsedWindows& used,
                                     const std::vector<ExemplarWindow>& shown, int count) const;

private:
    std::uint64_t difference(const PngPixels& canvas, const ExemplarWindow& window) const;

    const PngPixels& features_;
    int side_;
    std::vector<std::uint8_t> factors_; ///< of each value of a window: 1 where it counts; none: all do
    MaskedSquares squares_;
};

}
