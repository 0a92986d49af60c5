// The autocorrelation of point sets in the plane: the pair correlation by direction as well as distance.
//
// Spectrum and autocorrelation are Fourier transforms of one another (Wiener and Khinchin). With P as in spectrum.hpp,
// of N points, g(x) = sum_f w(f) (P(f) - 1) exp(2 pi i f.x) / N: the share of pairs x apart over the share that random
// points have, without the pairs of a point with itself. The taper w(f) = cos^2(pi |f| / M) for |f| < M/2, else 0,
// keeps the end of the spectrum from ringing; it blurs g to some 2 / M.
#pragma once

#include "analysis/spectra/spectrum.hpp"
#include "base/images/square_image.hpp"

namespace poissonlab {

/// g at displacements up to `reach` along each axis, at most 1/2. Pixel (size/2, size/2) of the result is displacement
/// 0, its neighbours are autocorrelation_step() away. Takes a 2D spectrum of at least two points; throws
/// std::invalid_argument otherwise.
SquareImage autocorrelation(const Spectrum& spectrum, double reach);

/// The distance of neighbouring pixels: 1 / (2 M), of large spectra 1 / M.
double autocorrelation_step(int spectrum_size);

}
