// The curves of several series: which series have one, and what they are called in a plot of all.
#pragma once

#include "reports/layout/report_layout.hpp"
#include "reports/plots/curves.hpp"
#include "reports/plots/series_plots.hpp"
#include "reports/plots/zone_plate_curves.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// A series in a plot of several.
struct NamedSeries
{
    const ReportSeries* series = nullptr;
    std::string label;
};

/// The series outlive these; the place of a series is its number in plots.
using SeriesList = std::vector<NamedSeries>;

/// The series of a run under the names that they have there.
SeriesList series_of(const ReportRun& run);

/// In what frequencies of these series compare: in cycles per mean spacing of the points where the sets of some series
/// are larger than those of others by more than a tenth, or of another dimension.
LengthUnit common_unit(const SeriesList& series);

/// Adds the numbers of points to the names of series where they differ.
SeriesList with_points_in_names(SeriesList series);

/// Reads radial.csv. Throws InputError. For a series without spectrum, the curve has no bins.
Curve read_curve(const Run& run, const Series& stored);

/// The curves of the series that have a spectrum, and of those whose spectrum reaches the principal frequency.
std::vector<NumberedCurve> frequency_curves(const SeriesList& series);
std::vector<NumberedCurve> principal_curves(const SeriesList& series);

/// The pair correlations of the series that have one; distances in units of the largest possible minimum distance.
std::vector<PairCorrelationCurve> pair_correlation_curves(const SeriesList& series);

/// The number variances of the series that have one.
std::vector<NumberVarianceCurve> number_variance_curves(const SeriesList& series);

/// The iterations of the series that have some.
std::vector<IterationCurve> iteration_curves(const SeriesList& series);

/// Does a method record an energy of its own, rather than that of Lloyd relaxation?
bool has_own_energy(const ReportSeries& series);

/// The curves of methods that do, or of those that do not; without those that have no energy at all.
std::vector<IterationCurve> energy_curves(const SeriesList& series, bool are_own);

/// The errors of the series that have sampled the zone plate.
std::vector<ZonePlateCurve> zone_plate_curves(const SeriesList& series);

/// The errors of integrals against N: series that differ only in N are one curve. Empty where no curve has two
/// sizes.
std::vector<IntegrationCurve> integration_curves(const SeriesList& series);

}
