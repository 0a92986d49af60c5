// The curves of the pair correlation function over distance, alone and overlaid.
#pragma once

#include "analysis/measures/pair_correlation.hpp"
#include "reports/plots/gnuplot.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// What is drawn of one series.
struct PairCorrelationCurve
{
    std::size_t index = 0;                 ///< number of the series, for its colour
    std::string label;                     ///< for the key
    double unit = 1;                       ///< of the axis: the largest possible minimum distance, in unit lengths
    std::optional<double> relative_radius; ///< where the curve leaves 0
    std::vector<PairCorrelationBin> bins;
};

/// The axes, the same in all plots of a report so that plots compare.
struct PairCorrelationScales
{
    double max_distance = 4; ///< in units of the largest possible minimum distance
    double max_value = 2;
};

/// Scales that show all curves, values up to 5: the peaks of a lattice would flatten everything else.
PairCorrelationScales common_pair_correlation_scales(const std::vector<PairCorrelationCurve>& curves);

/// The plot of a series, with a band of one standard error.
GnuplotPicture plot_pair_correlation(const PairCorrelationCurve& curve, const PairCorrelationScales& scales,
                                     const std::filesystem::path& stem);

/// Several series in one plot, with a key.
GnuplotPicture overlay_pair_correlation(const std::vector<PairCorrelationCurve>& curves,
                                        const PairCorrelationScales& scales, const std::filesystem::path& stem);

}
