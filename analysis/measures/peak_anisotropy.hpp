// The largest anisotropy of a ring: how far a spectrum is from being the same in all directions.
//
// Anisotropy as in radial_statistics.hpp. Rings of few samples are left out: their anisotropy is mostly chance. So are
// rings with next to no power, whose directions nobody sees.
#pragma once

#include "analysis/spectra/radial_statistics.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace poissonlab {

/// The least number of samples of a ring that takes part.
inline constexpr std::size_t least_peak_samples = 100;

/// The least power of a ring that takes part; random points have 1.
inline constexpr double least_peak_power = 0.01;

struct PeakAnisotropy
{
    double db = 0;
    double frequency = 0;                         ///< of the ring, in cycles per unit length
    std::size_t samples = 0;                      ///< of the ring
    std::optional<double> standard_error_db = {}; ///< for whoever has several realizations to set
    double power = 0;                             ///< mean of the ring; 0: not known, as in older results

    bool operator==(const PeakAnisotropy&) const = default;
};

/// The peak over rings one sample wide; std::nullopt if no ring has enough samples.
std::optional<PeakAnisotropy> peak_anisotropy(const std::vector<RadialBin>& radial);

/// The standard error of the peak of the mean of several independent periodograms, in dB: the standard deviation of the
/// largest of independent normal deviates, one a ring, whose means are the level of chance and whose deviations are
/// those of anisotropy_standard_error_db(). The largest of many deviates less than each of them. Rings that are more
/// than four deviations above chance keep what was measured as their means; where the peak is one of them, its
/// deviation is that which follows from the variance of its powers between realizations.
double peak_anisotropy_error_db(const std::vector<RadialBin>& radial, const PeakAnisotropy& peak, const Spectrum& mean);

/// The anisotropy that stands out of chance, in dB above it: that of the largest of all rings that do; 0 where none
/// does, so that sets of different numbers of realizations K compare. Nothing where no ring takes part. `radial` has
/// rings one sample wide, one after the other, of the mean of K periodograms.
///
/// Chance alone gives the ratio 1/K of variance to squared mean. A ring is one frequency wide, and where the power
/// rises by the factor e^s from ring to ring it varies within a ring in every direction: by the ratio g = (s/2)
/// coth(s/2) - 1, so that (1 + 1/K)(1 + g) - 1 is expected of isotropic sets. A ring stands out where its height above
/// that, over anisotropy_standard_error_db(), is less likely than one in a thousand over the number of rings
/// (Bonferroni). Decibels of such ratios are nearly normal, the ratios themselves have long tails.
std::optional<double> anisotropy_above_chance_db(const std::vector<RadialBin>& radial, int realizations);

/// The standard error of a ring's anisotropy where all that varies within the ring is chance, in dB.
///
/// The ratio of sample variance to squared mean of n independent values has the relative variance
/// (kappa - 1 + 4 c^2 - 4 gamma c) / n for large n, with their coefficient of variation c, skewness gamma and kurtosis
/// kappa (delta method). Averages of K exponential variables are Gamma(K): c = 1 / sqrt K, gamma = 2 / sqrt K,
/// kappa = 3 + 6 / K, which gives (2 + 2 / K) / n. f and -f have the same power: n is half of `samples`.
double anisotropy_standard_error_db(std::size_t samples, int realizations);

}
