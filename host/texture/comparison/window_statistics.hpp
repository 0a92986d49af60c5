// Numbers by which windows of textures are told apart: colours, contrast, gradients, structure.
#pragma once

#include "base/images/png_file.hpp"
#include "host/texture/comparison/steerable_pyramid.hpp"

#include <array>
#include <vector>

namespace poissonlab {

/// Statistics of a window.
struct WindowStatistics
{
    std::vector<std::array<double, 256>> colors;   ///< cumulative distributions of each channel's values
    std::array<double, 256> steps{};               ///< cumulative distribution of differences of neighbours' lightness
    double mean_step = 0;                          ///< levels
    std::vector<std::vector<double>> contrasts;    ///< for each scale, quantiles of contrast within squares, in levels
    std::vector<double> mean_contrasts;            ///< for each scale
    std::vector<std::vector<double>> correlations; ///< for each scale, magnitude_correlations()
};

/// Sides of the squares in which contrast is taken.
inline constexpr std::array<int, 4> contrast_sides{4, 8, 16, 32};

WindowStatistics window_statistics(const PngPixels& window);

/// Distances of two windows; each is 0 for equal ones.
struct WindowDistances
{
    double colors = 0;    ///< mean difference of quantiles (1-Wasserstein), mean over channels, in levels
    double largest = 0;   ///< largest difference of cumulative distributions of a channel (Kolmogorov and Smirnov)
    double contrast = 0;  ///< mean difference of quantiles of contrast, over `natural`'s mean, mean over scales
    double gradients = 0; ///< mean difference of quantiles of steps, over `natural`'s mean
    std::array<double, pyramid_scales>
        structure{}; ///< of each scale, root of the mean squared difference of correlations
};

WindowDistances window_distances(const WindowStatistics& window, const WindowStatistics& natural);

/// Mean contrast over `natural`'s, geometric mean over scales.
double contrast_ratio(const WindowStatistics& window, const WindowStatistics& natural);

}
