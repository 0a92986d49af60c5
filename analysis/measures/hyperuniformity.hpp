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
// their tiles, and of curves that bend. Those who have several realizations know better, by how much b depends on each.
// A curve that bends has no exponent over a range: b of S = t f^2 (1 - beta f^2 / N) over f <= F is 2 - beta F^2 / 2N
// in 2D, by the regression of beta f^2 / N on ln f. Of points displaced by normal deviates of 0.5 grid steps, beta
// is 4.9, and b is 1.85 over the range of half the Nyquist frequency.
//
// Test: their likelihood ratio T = 2 (max L - max L at s = 0) for S = s + t f^2 exp(-c f^2 / F^2) with s, t >= 0 and c
// from 0 to 1/2, F the end of the range. Where s = 0, T depends on c only: its distribution follows from the
// frequencies and the most likely c, and is found here by drawing 9,999 times. The p-value is the probability that a
// hyperuniform set has such a T or a larger one. It is small for sets that are not hyperuniform, of which one
// realization is enough; it is 1 for all that have no power left at 0, steep ones as well. Departures from the paper:
// it gives one distribution, a fit to simulations for many frequencies, where this is that of the frequencies at hand;
// s / t is one of 33 values, and c one of (j / 10)^2 for j from 0 to 7, in the data and in the draws alike; and it has
// no c. Without it concave curves, as those of displaced grids are, look like power at 0, by a number of standard
// errors that grows with the root of K: of 1,024 points displaced by normal deviates of one grid step, 64 of 100
// ensembles of 40 would be rejected at 5 %.
#pragma once

#include "analysis/measures/low_frequency_power.hpp"
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

/// The shells of all frequencies of a range, which are integers on the unit torus. Those that the spectrum does not
/// hold are left out.
std::vector<PowerShell> power_shells(const Spectrum& spectrum, const FrequencyRange& range);
std::vector<PowerShell> power_shells(const HalfSpectrum& periodogram, const FrequencyRange& range);

/// The powers of these shells.
std::vector<double> powers_of(const std::vector<PowerShell>& shells);

/// The range of the exponent: low_frequency_range(), and of sets of `tiles` tiles along each axis no more than 0.4 of
/// the frequency at which they repeat. The lattice of the tiles and what they are inside begin above; 0: no tiles. In a
/// box it begins with the lowest frequency along the longest side.
FrequencyRange hyperuniform_range(std::size_t points, int dimension, int tiles, const PeriodicBox& box = {});

/// The range of the test: half of that one, over which curves bend little, and at most 16 (3D: 6) cycles per unit
/// length, beyond which frequencies of large sets say little of S(0).
FrequencyRange hyperuniformity_test_range(std::size_t points, int dimension, int tiles, const PeriodicBox& box = {});

struct HyperuniformityExponent
{
    double value = 0; ///< b
    double standard_error = 0;
};

/// The exponent from shells of K averaged periodograms. Powers below `least` are no more than rounding: the
/// lowest frequencies, as far as half of their shells have no more, are left out, and others are taken to have `least`.
/// It has no value where fewer than three shells are left, or most of them have no more.
std::optional<HyperuniformityExponent> hyperuniformity_exponent(const std::vector<PowerShell>& shells, int realizations,
                                                                double least);

/// T of shells of K averaged periodograms, at least 0.
double hyperuniformity_statistic(const std::vector<PowerShell>& shells, int realizations);

/// The p-value of the test, a multiple of 1/10,000; nothing under the same conditions as for the exponent.
std::optional<double> hyperuniformity_p_value(const std::vector<PowerShell>& shells, int realizations, double least);

}
