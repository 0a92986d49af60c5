// Radially averaged power and anisotropy (dissertation, equations 6.3 to 6.5).
#pragma once

#include "analysis/spectra/spectrum.hpp"

#include <cstddef>
#include <vector>

namespace poissonlab {

/// The anisotropy of "no variation at all", a finite number that tables and plots can hold. Bins of constant
/// power and bins without any power, or with no more than rounding leaves of a zero, have this anisotropy.
/// The rounding of a mean over a million samples, relative 1e-10 at worst, lies below it as well.
inline constexpr double least_anisotropy_db = -200.0;

/// One annulus (2D) or spherical shell (3D) of frequencies.
struct RadialBin
{
    double frequency = 0;     ///< central radius, in cycles per unit length
    double power = 0;         ///< mean power of its samples, equation 6.3
    double anisotropy_db = 0; ///< 10 log10 of sample variance (divisor n - 1) over squared mean,
                              ///< equations 6.4 and 6.5, at least least_anisotropy_db
    std::size_t samples = 0;  ///< number of frequency samples
    double power_error = 0;   ///< standard error of `power`, from its spread between realizations; 0: not known
};

/// Bins k = 1, 2, ... hold the samples with 1/2 + (k - 1) w < |f| <= 1/2 + k w, w = `bin_width` in frequency
/// samples (at least 1). One sample wide, bin k holds those with round(|f|) = k, for k = 1 .. M/2 - 1.
/// Compared as integers, so that no sample changes its bin by rounding. The DC sample (f = 0) is left out,
/// and so are bins that reach beyond the spectrum's border. In a box |f| is the length in its reciprocal lattice, which
/// has one frequency in a unit of area (volume) as well: bins hold as many samples as those of the unit torus. The
/// first one also holds the frequencies of at most 1/2 that there are along sides longer than 2.
std::vector<RadialBin> radial_statistics(const Spectrum& spectrum, double bin_width = 1);

/// Powers up to this are zeros: the square of the transform's error, over N.
double zero_power(const Spectrum& spectrum);

/// The anisotropy of white noise averaged over K periodograms, the reference line: -10 log10 K dB.
double background_anisotropy_db(int realizations);

}
