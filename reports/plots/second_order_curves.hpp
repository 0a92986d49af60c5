// Curves of second-order statistics: the pair correlation function over the distance, the number variance over the
// radius.
#pragma once

#include "analysis/measures/number_variance.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "reports/plots/plot.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

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
