// An endless texture against its exemplar: how far its windows are from those of the exemplar, by how much more than
// these are from each other, and how much it repeats.
//
// All windows are squares of half of the exemplar's shorter side. The exemplar has four, whose distances from each
// other are its own spread: a texture that cannot be told from its exemplar has distances as large as these, mean over
// 4 x 4 windows and all four of the exemplar.
#pragma once

#include "base/images/png_file.hpp"
#include "host/texture/comparison/window_statistics.hpp"

#include <functional>

namespace poissonlab {

/// The pixels of a square of a texture, of so many along each side, always from the same place on.
using TextureSquare = std::function<PngPixels(int side)>;

struct TextureComparison
{
    WindowDistances distances; ///< from the exemplar's windows
    WindowDistances own;       ///< of the exemplar's windows from each other
    double contrast = 1;       ///< over the exemplar's
    double peak = 0;           ///< the largest correlation of the texture with itself, moved far
    double chance_peak = 0;    ///< how large that is by chance
    double contrast_peak = 0;  ///< the same of its contrast within squares
    double chance_contrast_peak = 0;
};

/// The part of the exemplar's shorter side that a texture is moved by at least, and the sides in pixels of the squares
/// whose contrast is compared.
inline constexpr double least_peak_part = 0.25;
inline constexpr int peak_contrast_side = 16;

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
