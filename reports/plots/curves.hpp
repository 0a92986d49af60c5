// The curves of spectra: radially averaged power and anisotropy over frequency.
#pragma once

#include "analysis/measures/low_frequency_power.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "reports/plots/plot.hpp"

#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The content of the curves of a series.
struct Curve
{
    std::size_t points = 0; ///< N
    int dimension = 2;
    std::vector<RadialBin> bins;
    double background_db = 0;                  ///< anisotropy of white noise, -10 log10 K
    int periodograms = 0;                      ///< K
    std::optional<double> principal_frequency; ///< 1 / minimum distance
    double max_frequency = 0;                  ///< end of the axis

    /// True if the curve reaches its principal frequency.
    bool has_principal_in_sight() const { return principal_frequency && *principal_frequency <= max_frequency; }
};

/// The units that lengths are measured in, and frequencies in its inverse.
enum class LengthUnit
{
    absolute,  ///< the side of the torus
    spacing,   ///< the mean spacing of the points, N^(-1/dimension)
    principal, ///< the minimum distance, the inverse of the principal frequency
};

/// The words of a horizontal axis.
std::string frequency_words(LengthUnit unit);
std::string distance_words(LengthUnit unit);

/// Axes in units of the principal frequency end here.
inline constexpr double principal_units_shown = 4;

/// A curve of a series, in a plot of several.
struct NumberedCurve
{
    std::size_t index = 0; ///< number of the series
    std::string label;
    const Curve* curve = nullptr; ///< outlives this
};

/// Radially averaged power with one standard error, and anisotropy, of all these series. Axes show all curves, power
/// up to 5 and anisotropy up to 30 dB, so that the single peaks of a regular grid do not flatten everything else. In
/// units of the principal frequency, all must have theirs in sight.
Plot power_plot(const std::vector<NumberedCurve>& curves, LengthUnit unit);
Plot anisotropy_plot(const std::vector<NumberedCurve>& curves, LengthUnit unit);

/// The plot of anisotropy for series side by side: where these have different numbers K of realizations, each curve is
/// drawn above the −10 log10 K dB that chance gives its mean of K spectra.
Plot anisotropy_comparison(const std::vector<NumberedCurve>& curves, LengthUnit unit);

/// Plots the power of power_plot() over the same frequencies with both axes logarithmic, where power laws are straight
/// lines: the structure factor as it is drawn for hyperuniform systems. Rings without power lie below the axis.
Plot structure_factor_plot(const std::vector<NumberedCurve>& curves, LengthUnit unit);

/// The plots of series `index` alone, with a second axis in units of its principal frequency along the top;
/// `all` is in absolute frequencies.
Plot power_alone(const Plot& all, std::size_t index, const Curve& curve);
Plot anisotropy_alone(const Plot& all, std::size_t index, const Curve& curve);

/// The structure factor of series `index` alone, with the line of its low-frequency exponent, where it has one.
Plot structure_factor_alone(const Plot& all, std::size_t index, const Curve& curve,
                            const std::optional<LowFrequencyPower>& fit);

/// The label of a key where sizes differ: with the number of points, unless it says that already.
std::string label_with_points(const std::string& label, std::size_t points);

/// The label without "N = 16,384" and the comma beside it, where it says that.
std::string label_without_points(const std::string& label, std::size_t points);

}
