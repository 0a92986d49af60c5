// The curves of the number variance over the radius.
#pragma once

#include "analysis/measures/number_variance.hpp"
#include "reports/plots/plot.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

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
