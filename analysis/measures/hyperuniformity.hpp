// Hyperuniformity at the lowest frequencies: the exponent b of S(f) ~ f^b, and the test of S(0) = 0.
//
// A set is hyperuniform where its power vanishes at frequency 0 (Torquato, Hyperuniform states of matter, Phys. Rep.
// 745, 2018). The powers of different frequencies are nearly independent, and exponential with mean S(f) for large
// sets: Klatt, Last and Henze, A genuine test for hyperuniformity, arXiv:2210.12790. The mean of K of them is a gamma
// variable, so that a model S(f; parameters) has, but for constants, the log-likelihood
//
//   L = -K sum over pairs f, -f of (ln S(f) + P(f) / S(f)).
//
// Exponent: the b that maximises L for S = a f^b, without the bias that logarithms of noisy powers have. At the
// maximum, the mean of ln f weighted by P f^-b is that without weights. The standard error is that of the likelihood,
// times the root of the observed variance of P / S over the expected one where that is above 1: of tilings that share
// their tiles, and of curves that bend.
//
// Test: their likelihood ratio T = 2 (max L - max L at s = 0) for S = s + t f^2 with s, t >= 0. Where s = 0, T does not
// depend on t: its distribution follows from the frequencies alone, and is found here by drawing 9,999 times. The
// p-value is the probability that a hyperuniform set has such a T or a larger one. It is small for sets that are not
// hyperuniform, of which one realization is enough; it is 1 for all that have no power left at 0, steep ones as well.
// Departures from the paper: it gives one distribution, a fit to simulations for many frequencies, where this is that
// of the frequencies at hand; s / t is one of 65 values in steps of a fifth, in the data and in the draws alike.
#pragma once

#include "analysis/measures/low_frequency_power.hpp"
#include "analysis/spectra/half_spectrum.hpp"
#include "analysis/spectra/spectrum.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace poissonlab {

/// The frequencies of one length.
struct PowerShell
{
    double frequency = 0;  ///< |f|, in cycles per unit length
    double power = 0;      ///< their mean power
    std::size_t pairs = 0; ///< of opposite frequencies, which have the same power: independent samples
};

/// The shells of all integer frequencies of a range. Those that the spectrum does not hold are left out.
std::vector<PowerShell> power_shells(const Spectrum& spectrum, const FrequencyRange& range);
std::vector<PowerShell> power_shells(const HalfSpectrum& periodogram, const FrequencyRange& range);

/// The range of the exponent: low_frequency_range(), and of sets of `tiles` tiles along each axis no more than 0.4 of
/// the frequency at which they repeat. The lattice of the tiles and what they are inside begin above; 0: no tiles.
FrequencyRange hyperuniform_range(std::size_t points, int dimension, int tiles);

/// The range of the test: half of that one, as curves that bend away from f^2 look like power at 0, and at most 16
/// (3D: 6) cycles per unit length, beyond which frequencies of large sets say little of S(0).
FrequencyRange hyperuniformity_test_range(std::size_t points, int dimension, int tiles);

struct HyperuniformityExponent
{
    double value = 0; ///< b
    double standard_error = 0;
};

/// The exponent from shells of K averaged periodograms. Powers below `least` are no more than rounding: the
/// lowest frequencies, as far as half of their shells have no more, are left out, and others are taken to have `least`.
/// Nothing where fewer than three shells are left, or most of them have no more.
std::optional<HyperuniformityExponent> hyperuniformity_exponent(const std::vector<PowerShell>& shells, int realizations,
                                                                double least);

/// T of shells of K averaged periodograms, at least 0.
double hyperuniformity_statistic(const std::vector<PowerShell>& shells, int realizations);

/// The p-value of the test, a multiple of 1/10,000; nothing under the same conditions as for the exponent.
std::optional<double> hyperuniformity_p_value(const std::vector<PowerShell>& shells, int realizations, double least);

}
