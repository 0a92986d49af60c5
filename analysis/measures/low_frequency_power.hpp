// The power spectrum at low frequencies: the exponent b of P(f) ~ f^b, and P extrapolated to f = 0.
//
// A set is hyperuniform when the power vanishes at f = 0, and b says how fast: Torquato and Stillinger, Local
// density fluctuations, hyperuniformity, and order metrics, Phys. Rev. E 68, 041113 (2003); Torquato,
// Hyperuniform states of matter, Phys. Rep. 745 (2018). For integration it is b that decides the rate at
// which errors fall: Pilleboue et al., Variance analysis for Monte Carlo integration, ACM Transactions on
// Graphics 34(4), 2015.
//
// Both are weighted least squares over the bins with frequency in a range:
//
//   exponent   ln P = ln a + b ln f, weight = samples of the bin: the variance of ln P is 2 / (K samples)
//   intercept  P = S(0) + c f^2,     weight = samples of the bin: isotropic spectra without long-range
//              order are even and smooth at f = 0
//
// Standard errors come from the residuals, with m - 2 degrees of freedom for m bins. They hold for the model:
// a range that is too long for it shows as bias that they do not hold.
#pragma once

#include "analysis/spectra/radial_statistics.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace poissonlab {

/// The usual end of the range in units of points^(1/dimension): a quarter of the frequency near which the
/// spectrum of a Poisson disk set has its first peak.
inline constexpr double low_frequency_end = 0.25;

struct LowFrequencyPower
{
    double exponent = 0; ///< b
    double exponent_standard_error = 0;
    double intercept = 0; ///< S(0); below 0 only by noise or where the model does not hold
    double intercept_standard_error = 0;
    double begin = 0; ///< the first and the last frequency that took part
    double end = 0;
    std::size_t bins = 0; ///< m

    bool operator==(const LowFrequencyPower&) const = default;
};

/// Frequencies in cycles per unit length, both ends included.
struct FrequencyRange
{
    double begin = 0;
    double end = 0;
};

/// The usual range: from the first bin to low_frequency_end points^(1/dimension).
FrequencyRange low_frequency_range(std::size_t points, int dimension);

/// The mean power of all frequencies of a range: a level that stealthy sets, whose power is none rather than a power of
/// the frequency, are told by. Nothing where the range has no bins.
std::optional<double> mean_power_in(const std::vector<RadialBin>& radial, const FrequencyRange& range);

/// The fits over a range. Bins without power take no part in the exponent, as they have no logarithm. Nothing
/// where fewer than three bins with power are left.
std::optional<LowFrequencyPower> low_frequency_power(const std::vector<RadialBin>& radial, const FrequencyRange& range);

}
