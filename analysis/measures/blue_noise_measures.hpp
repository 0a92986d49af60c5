// Effective Nyquist frequency and oscillation of a radial power spectrum: how far the frequencies reach that
// are nearly free of power, and how far from flat the spectrum is beyond.
//
// Heck, Schloemer and Deussen, Blue noise sampling with controlled aliasing, ACM Transactions on Graphics
// 32(3), 2013. The exact limits are those of the authors' tool psa (github.com/nodag/psa,
// src/statistics.cpp). With frequencies f in cycles per unit length, radial power P(f), and the principal
// unit s = N^(1/d), the number of points along an axis of a square lattice:
//
//   C(f)  = mean power of all frequencies up to |f|, f = 0 left out
//   nu    = f* / s,  f* the largest f below f0 with C(f) < 0.1,
//           f0 the smallest f >= s / 2 with C(f) > 0.5
//   Omega = 10 sqrt(mean over all frequencies with a <= |f| <= b of (P(|f|) - 1)^2),
//           a the frequency of the first bin at or above s / 2 with P >= 0.98 (of the largest P where there is none),
//           b = a + 5 s, or the end of the spectrum
//
// nu is f*/2, the effective Nyquist frequency, relative to s / 2, the Nyquist frequency of the square
// lattice, as psa prints it. Means weigh a frequency as often as it occurs, with f^(d-1): the step spectrum,
// 0 up to f1 and 1 beyond, has C(f) = 1 - (f1/f)^d, and the largest step that any point set can have in 2D,
// f1 = s / sqrt pi, has nu = 0.564 / sqrt(1 - 0.1) = 0.595.
//
// Departures from psa: it computes P from g(r) as a smooth function of f, here P is the radial mean of
// periodograms in bins of one cycle per unit length, and C is interpolated within a bin. Spectra of this
// laboratory end between 2.5 s and 5 s (2D), so that b is nearly always their end; a spectrum's noise adds
// to Omega. 3D is the same with d = 3.
//
// psa looks for a from frequency 0 on. The lowest bins have a few frequencies each, whose power relaxation from random
// points leaves near 1: in some runs and not in others they would pass 0.98, and all of the gap would count. Below s /
// 2, the Nyquist frequency of the square lattice, no set that fills its gap has risen to 1. A bin that has 0.98 or not
// by chance is of no account, as it adds nearly nothing.
#pragma once

#include "analysis/spectra/radial_statistics.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace poissonlab {

/// nu: f*/2 over half of points^(1/dimension). 0 where there is no such frequency, as for white noise, whose
/// mean power is never below 0.1. Nothing where C does not exceed 0.5 within the spectrum: it ends before f0.
///
/// `radial` is what radial_statistics gives; `points` >= 1, `dimension` 2 or 3, otherwise InputError.
std::optional<double> effective_nyquist_frequency(const std::vector<RadialBin>& radial, std::size_t points,
                                                  int dimension);

struct Oscillation
{
    double value = 0;                          ///< Omega
    double begin = 0;                          ///< a, in cycles per unit length
    double end = 0;                            ///< the last frequency that took part
    std::optional<double> standard_error = {}; ///< for whoever has several realizations to set

    bool operator==(const Oscillation&) const = default;
};

/// Omega. Without any bin all is 0. Throws InputError for points below 1 and dimensions other than 2 and 3.
Oscillation oscillation(const std::vector<RadialBin>& radial, std::size_t points, int dimension);

}
