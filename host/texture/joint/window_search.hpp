// Windows of an exemplar that look like what is there: coarse to fine.
//
// Sums of squared differences of features over all windows of the exemplar at half its resolution, exact by transforms
// (masked_squares.hpp); the best of them are compared again pixel by pixel, with their neighbours.
#pragma once

#include "host/texture/joint/phase_rule.hpp"
#include "host/texture/masked_squares.hpp"
#include "host/texture/window_choice.hpp"

#include <functional>

namespace poissonlab {

/// The means of 2 x 2 pixels each.
PngPixels halved(const PngPixels& picture);

/// Says whether a window may be taken; with `slack` also those that are so many pixels away from one.
using WindowTest = std::function<bool(const ExemplarWindow& window, double slack)>;

/// The test of windows whose middles are to lie at (x, y), pixels from a tile's corner: none where the rule is empty.
/// The rule must live longer.
WindowTest window_test(const PhaseRule& rule, double x, double y);

class WindowSearch
{
public:
    /// Searches for squares of `side` pixels, an even number. `counts` are the pixels that are compared, row by row;
    /// none: all. The features must live longer.
    WindowSearch(const PngPixels& features, int side, const std::vector<std::uint8_t>& counts = {});

    int side() const { return side_; }
    const PngPixels& features() const { return features_; }

    /// The windows with the smallest differences from a picture of features, the best first: at most so many, not those
    /// that are used, nor those nearer than 4 pixels to ones that are `shown`, nor those that `is_allowed` refuses, if
    /// there is such a test.
    std::vector<ExemplarWindow> best(const PngPixels& canvas, const UsedWindows& used,
                                     const std::vector<ExemplarWindow>& shown, int count,
                                     const WindowTest& is_allowed = {}) const;

private:
    SquareSums coarse_sums(const PngPixels& canvas, const WindowTest& is_allowed) const;
    std::uint64_t difference(const PngPixels& canvas, const ExemplarWindow& window) const;

    const PngPixels& features_;
    int side_;
    std::vector<std::uint8_t> factors_; ///< of each value of a window: 1 where it counts; none: all do
    MaskedSquares squares_;
};

}
