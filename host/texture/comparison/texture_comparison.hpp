// An endless texture against its exemplar: how far its windows are from those of the exemplar, by how much more than
// these are from each other, and how much it repeats.
//
// All windows are squares of half of the exemplar's shorter side. The exemplar has four, whose distances from each
// other are its own spread: a texture that cannot be told from its exemplar has distances as large as these, mean over
// 4 x 4 windows and all four of the exemplar.
#pragma once

#include "base/images/png_file.hpp"
#include "host/texture/comparison/light_map.hpp"
#include "host/texture/comparison/steerable_pyramid.hpp"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace poissonlab {

// Repetition that shows wherever a lattice may lie: the largest correlation of a picture with itself, moved.
//
// By chance alone the correlations of far places of a random field are as large as Bartlett's formula has it: their
// variance is the sum of all squared correlations over the number of places (Bartlett, On the Theoretical
// Specification and Sampling Properties of Autocorrelated Time-Series, 1946). The largest one of m such is about
// sqrt(2 ln m) standard deviations.

/// Correlations of a map with itself at all distances up to a quarter of its sides to the east and the south, and to
/// the west and the south: over the pairs of places that the map has.
class SelfCorrelation
{
public:
    explicit SelfCorrelation(const LightMap& map);

    /// The correlation at a distance of (dx, dy), dy from 0 to height / 4, dx from -width / 4 to width / 4.
    double at(int dx, int dy) const;

    int most_dx() const { return width_ / 4; }
    int most_dy() const { return height_ / 4; }

private:
    int width_, height_;
    std::size_t line_;           ///< numbers a row
    std::vector<double> values_; ///< of maps with a border of zeros, over which opposite sides meet; row by row
};

struct CorrelationPeak
{
    double correlation = 0;
    int dx = 0; ///< where it is
    int dy = 0;
};

/// The largest correlation at distances of `least` places and more.
CorrelationPeak correlation_peak(const SelfCorrelation& correlations, int least);

/// The largest correlation that chance makes in a map of width x height places of a random field whose correlations
/// below `least` are those of `sample`.
double chance_of_peak(const SelfCorrelation& sample, int least, int width, int height);

// Numbers by which windows of textures are told apart: colours, contrast, gradients, structure.

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

/// The change of steps from an exemplar to its texture. Blurs and many blends lose edges, and cuts of large pieces lose
/// few. Means of pixels gain none: by Jensen's inequality, the mean excess of their steps over any limit is not larger.
struct EdgeChange
{
    /// The fraction by which the mean of the largest tenth of all steps is below the exemplar's. Blends turn large
    /// steps into several small ones: the gain of quantiles, over the mean step, is added, but at most doubles the
    /// loss.
    double lost = 0;
    /// The largest difference, over all limits, of the mean excess of steps over the limit from that of the exemplar;
    /// in parts of the mean step.
    double gained = 0;
};

/// Compares all steps of some windows of a texture with all steps of some windows of its exemplar.
EdgeChange edge_change(std::span<const WindowStatistics> texture, std::span<const WindowStatistics> natural);

/// Mean contrast over `natural`'s, geometric mean over scales.
double contrast_ratio(const WindowStatistics& window, const WindowStatistics& natural);

/// The pixels of a square of a texture, of so many along each side, always from the same place on.
using TextureSquare = std::function<PngPixels(int side)>;

struct TextureComparison
{
    WindowDistances distances; ///< from the exemplar's windows
    WindowDistances own;       ///< of the exemplar's windows from each other
    double contrast = 1;       ///< over the exemplar's
    EdgeChange edges;          ///< over all windows
    double peak = 0;           ///< the largest correlation of the texture with itself, moved far
    double chance_peak = 0;    ///< how large that is by chance
    double contrast_peak = 0;  ///< the same of its contrast within squares
    double chance_contrast_peak = 0;
};

/// The part of the exemplar's shorter side that a texture is moved by at least, and the sides in pixels of the squares
/// whose contrast is compared.
inline constexpr double least_peak_part = 0.25;
inline constexpr int peak_contrast_side = 16;

/// The change of edges that is natural, in parts of the mean step: the distance of the exemplar's windows from each
/// other, but at least a fortieth, so that an exemplar with equal windows has limits, too.
double natural_edge_change(const TextureComparison& comparison);

/// The mean over scales of how many times farther structures are than the exemplar's windows are from each other.
double structure_times(const TextureComparison& comparison);

/// The least side of an exemplar that can be compared.
inline constexpr int least_compared_side = 128;

/// Pixels along the sides of the square in which windows are compared, and the most of that in which repetition is
/// looked for: 64 x 64 tiles of 64 pixels.
int compared_side(const PngPixels& exemplar);
inline constexpr int peak_side = 4096;

/// Compares; repetition is looked for in a square of `side` pixels, peak_side at most.
TextureComparison compare_texture(const PngPixels& exemplar, const TextureSquare& texture, int side);

}
