// Questions that claims ask of radial curves: anisotropy above chance, the rise to the first peak, powers of ranges,
// and how far two curves are from each other; with errors.
#pragma once

#include "reports/claims/claim_series.hpp"

#include <optional>
#include <vector>

namespace poissonlab {

/// The mean anisotropy in dB of rings with at least 100 samples, above that of chance, with its standard error from the
/// scatter of rings. Rings without power, which lattices have, have no direction and are left out.
Estimate mean_excess_anisotropy(const ReportSeries& series);

/// The largest anisotropy of such a ring in dB, above that of chance, with its standard error.
Estimate peak_excess_anisotropy(const ReportSeries& series);

/// The highest radially averaged power, and its standard error.
RadialBin power_peak(const ReportSeries& series);

/// The steepness of the power's rise to its peak: the width of the rise from 0.25 to 0.75, in cycles per mean spacing
/// of the points, with the error that those of the rings make. Empty for curves that do not rise so.
std::optional<Estimate> rise_width(const ReportSeries& series);

/// The principal frequency of sets of as many points with a relative radius of 0.75, by which all figures of the
/// dissertation are scaled. That of the set itself is no scale: one pair of close points moves it.
double usual_principal_frequency(const ReportSeries& series);

/// The mean radial power between two frequencies; empty where there are no rings.
std::optional<Estimate> mean_power(const ReportSeries& series, double low, double high);

/// The differences of radial powers, ring by ring of at least 100 samples. Sets of different sizes are compared at
/// equal frequencies over the square root of their points: tilings have some more or fewer than other sets.
std::vector<double> differences_of_curves(const ReportSeries& a, const ReportSeries& b);

/// The mean of the absolute differences, with its standard error from the scatter of rings.
std::optional<Estimate> distance_of_curves(const ReportSeries& a, const ReportSeries& b);

}
