// The curves of the error of integrals over the number of points, for methods whose sets come in several
// sizes.
//
// The curves of iterative methods: relative radius and energy over iterations.
//
// Curves of second-order statistics: the pair correlation function over the distance, the number variance over the
// radius.
#pragma once

#include "analysis/measures/number_variance.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "reports/plots/plot.hpp"
#include "results/run.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The error of one integrand, with sets of N points.
struct IntegrationSample
{
    double points = 0;
    double rms_error = 0;
    double standard_error = 0;
};

/// One method with one integrand.
struct IntegrationCurve
{
    std::size_t index = 0; ///< number of the method among those with curves, for the colour
    std::string label;     ///< without numbers of points
    std::string integrand;
    std::vector<IntegrationSample> samples; ///< N grows
};

/// The integrands of the curves, each once, in their order.
std::vector<std::string> integrands_of(const std::vector<IntegrationCurve>& curves);

/// All curves of an integrand in one plot with logarithmic axes and bars of one standard error. Errors of 0 are left
/// out.
Plot integration_error_plot(const std::vector<IntegrationCurve>& curves, const std::string& integrand);

/// The curve of one series.
struct IterationCurve
{
    std::size_t index = 0; ///< number of the series
    std::string label;
    int dimension = 2;
    const Iterations* stored = nullptr; ///< outlives this
    bool is_own_energy = false;         ///< what the method makes smaller, else what Lloyd relaxation does
};

/// The smallest energy that is possible (2D: hexagonal lattice, Fejes Toth 1953) or known (3D: body-centred
/// cubic lattice, Barnes and Sloane 1983): its second moment per dimension, times the dimension.
double least_energy(int dimension);

/// All curves, of which there must be one: the mean over realizations in a band from the least to the largest, over
/// iterations, on a logarithmic axis where there are more than 100. Dots are the mean within tiles, of tiles.
Plot relative_radius_plot(const std::vector<IterationCurve>& curves);
/// Energies of one kind.
Plot energy_plot(const std::vector<IterationCurve>& curves);

/// The curve of one series.
struct PairCorrelationCurve
{
    std::size_t index = 0; ///< number of the series
    std::string label;
    double unit = 1;                                       ///< of the axis, in unit lengths
    const std::vector<PairCorrelationBin>* bins = nullptr; ///< outlive this
};

/// All curves over distances in the units of each, with one standard error; `distance` is what the axis says. Values
/// are shown up to 5: the peaks of a lattice would flatten everything else.
Plot pair_correlation_plot(const std::vector<PairCorrelationCurve>& curves, const std::string& distance);

/// The words of an axis in units of the largest possible minimum distance says.
inline constexpr auto packing_distance = "distance / largest possible minimum distance";

/// The plot of series `index` alone, which marks its relative radius, where the curve leaves 0.
Plot pair_correlation_alone(const Plot& all, std::size_t index, std::optional<double> relative_radius);

/// The curve of one series.
struct NumberVarianceCurve
{
    std::size_t index = 0; ///< number of the series
    std::string label;
    std::size_t points = 0;
    int dimension = 2;
    const std::vector<NumberVarianceBin>* bins = nullptr; ///< outlive this
};

/// All curves over the radius in mean spacings, both axes logarithmic: the variance over that of as many random points
/// on the torus, which are the dashed line.
Plot number_variance_plot(const std::vector<NumberVarianceCurve>& curves);

}
