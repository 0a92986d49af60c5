#include "reports/plots/second_order_curves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr double most_value_shown = 5;

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
