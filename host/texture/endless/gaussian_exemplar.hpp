// An exemplar whose values are Gaussian, and the way back: what by-example noise blends.
//
// Heitz and Neyret, High-Performance By-Example Noise using a Histogram-Preserving Blending Operator, HPG 2018, section
// 4; Deliot and Heitz, Procedural Stochastic Textures by Tiling and Blending, 2019, sections 1.3 and 1.4: colours
// become coordinates along the principal axes of their distribution, each of which is transformed by itself. The k-th
// smallest of N values becomes the quantile (k + 1/2) / N of the normal distribution. The papers leave open which of
// equal values comes first: here the one whose neighbourhood is darker, of 3 x 3 and then of 5 x 5 pixels (Coltuc,
// Bolon, Chassery, Exact Histogram Specification, IEEE TIP 15, 2006), so that flat places get no noise.
#pragma once

#include "base/images/png_file.hpp"
#include "kernels/common/fields/endless_texture.h"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

struct GaussianExemplar
{
    int channels = 1;
    std::array<float, 3> means{};       ///< of the exemplar's channels
    std::array<float, 9> axes{};        ///< the colour that coordinate k stands for: from 3 k on
    std::vector<std::uint16_t> numbers; ///< of each pixel, coordinates side by side: 32768 is 0, 4096 one deviation
    std::vector<float> inverse;         ///< the coordinate of each 32nd number, tables one after the other
};

GaussianExemplar gaussian_exemplar(const PngPixels& exemplar);

/// The means of a picture's channels; 0 of those that it does not have.
std::array<double, 3> channel_means(const PngPixels& picture);

// The normal distribution by nothing but sums and products, whose last bits are the same on all machines.

/// The probability of at most `deviations` standard deviations; error below 1e-12 up to four of them, and below the
/// probability beyond.
double normal_probability(double deviations);

}
