#include "reports/plots/number_variance_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr double least_variance_shown = 1e-8;

PlotCurve variance_ratios(const NumberVarianceCurve& source)
{
    PlotCurve curve{source.index, source.label};
    const auto n = static_cast<double>(source.points);
    const double spacings = std::pow(n, 1.0 / source.dimension);
    for (const auto& bin : *source.bins) {
        const double random = bin.points * (1 - bin.points / n);
        const auto ratio = [&](double variance) { return std::max(variance / random, least_variance_shown / 1000); };
        curve.x.push_back(bin.radius * spacings);
        curve.y.push_back(ratio(bin.variance));
        curve.low.push_back(ratio(bin.variance - bin.standard_error));
        curve.high.push_back(ratio(bin.variance + bin.standard_error));
    }
    curve.end = curve.x.back();
    return curve;
}

}

Plot number_variance_plot(const std::vector<NumberVarianceCurve>& sources)
{
    Plot plot{.references = {{1, "", 0}}};
    double least = 0.1, nearest = std::numeric_limits<double>::infinity();
    for (const auto& source : sources) {
        PlotCurve curve = variance_ratios(source);
        least = std::min(least, std::ranges::min(curve.y));
        nearest = std::min(nearest, curve.x.front());
        plot.curves.push_back(std::move(curve));
    }
    least = std::pow(10, std::floor(std::log10(std::max(least, least_variance_shown))));
    const double most = std::pow(10, std::ceil(std::log10(highest(plot.curves, 2))));
    plot.x = {.label = "radius (mean spacings of the points)", .low = nearest, .step = 10, .logarithmic = true};
    plot.y = {.label = "number variance / that of random points",
              .low = least,
              .high = most,
              .step = 10,
              .logarithmic = true};
    plot.left_margin = 9;
    return plot;
}

}
