#include "reports/plots/pair_correlation_curves.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {

namespace {

constexpr double most_value_shown = 5;

}

Plot pair_correlation_plot(const std::vector<PairCorrelationCurve>& curves, const std::string& distance)
{
    Plot plot{.key = "pairs", .references = {{1, "", 0}}};
    double furthest = 0;
    for (const auto& source : curves) {
        PlotCurve curve{source.index, source.label};
        for (const auto& bin : *source.bins) {
            curve.x.push_back(bin.distance / source.unit);
            curve.y.push_back(bin.value);
            curve.low.push_back(bin.value - bin.standard_error);
            curve.high.push_back(bin.value + bin.standard_error);
        }
        furthest = std::max(furthest, std::ranges::max(curve.x));
        plot.curves.push_back(std::move(curve));
    }
    for (auto& curve : plot.curves) curve.end = std::ceil(furthest);
    const double top = std::clamp(std::ceil(2.2 * highest(plot.curves, 0)) / 2, 1.5, most_value_shown);
    plot.x = {.label = distance};
    plot.y = {
        .label = "pair correlation", .high = top, .step = top > 2.5 ? 1 : 0.5, .most = most_value_shown, .floor = 1e-2};
    return plot;
}

Plot pair_correlation_alone(const Plot& all, std::size_t index, std::optional<double> relative_radius)
{
    Plot plot = alone(all, index);
    if (relative_radius && *relative_radius <= plot.x.high)
        plot.marks.push_back({*relative_radius, "d_{min}", *relative_radius > 0.15 * plot.x.high});
    return plot;
}

}
