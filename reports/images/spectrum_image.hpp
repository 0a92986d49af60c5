// The picture of a spectrum: one pixel a frequency, zero in the middle.
//
// Pictures of what is 1 on average: densities, pair correlations.
#pragma once

#include "analysis/spectra/spectrum.hpp"
#include "base/images/grey_image.hpp"
#include "base/images/square_image.hpp"
#include "reports/images/tone_mapping.hpp"

namespace poissonlab {

/// A 2D spectrum as grey values. Frequencies along y grow upwards, as in the picture of the points. A pixel
/// shows the mean power of `block` x `block` frequencies, or the largest where that is a spike of more than 20, which
/// readers should see in small pictures too; `block` divides the size. Frequency zero (DC, always N) is left out:
/// black where a pixel would show nothing else.
GreyImage draw_spectrum(const Spectrum& spectrum, const ToneMapping& tone_mapping, int block = 1);

/// A plane of the spectrum of a box in true proportion: frequencies along both axes reach as far as they do along the
/// longest side of the box, and those along shorter ones, which are further apart, fill several pixels. Sides of the
/// box along columns and rows, over the longest.
Spectrum in_true_proportion(const Spectrum& plane, double column_side, double row_side);

/// The block for a picture on the page: the smallest power of two that makes it at most 512 pixels wide.
int page_block(int spectrum_size);

/// The block for a picture of either dimension on the page: two planes of a 3D spectrum stand side by side.
inline int spectrum_page_block(int spectrum_size, int dimension)
{
    return page_block(dimension == 3 ? 2 * spectrum_size : spectrum_size);
}

/// Grey values: 0 is black, 1 in the middle, 2 and more white, linear between. Each pixel becomes a square of
/// `magnification` pixels; the lowest y is at the bottom.
GreyImage draw_density(const SquareImage& image, int magnification = 1);

}
