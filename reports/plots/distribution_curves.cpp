#include "reports/plots/distribution_curves.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace poissonlab {

Plot chart_plot(const CurveChart& chart)
{
    Plot plot;
    const auto axis = [](const ChartAxis& of) {
        return PlotAxis{.label = of.name, .low = of.low, .high = of.high, .step = of.step};
    };
    plot.x = axis(chart.x);
    plot.y = axis(chart.y);
    double least = chart.level, most = chart.level;
    for (const ChartCurve& of : chart.curves) {
        PlotCurve& curve = plot.curves.emplace_back();
        curve.index = plot.curves.size() - 1;
        curve.label = of.name;
        curve.color = of.color;
        for (const auto& [x, y] : of.places) {
            curve.x.push_back(x);
            curve.y.push_back(y);
            if (std::isfinite(y) && x >= chart.x.low && x <= chart.x.high)
                least = std::min(least, y), most = std::max(most, y);
        }
    }
    plot.y.high =
        std::min(chart.y.high, chart.y.low + chart.y.step * (1 + std::floor((most - chart.y.low) / chart.y.step)));
    plot.y.low += chart.y.step * std::max(0.0, std::floor((least - chart.y.low) / chart.y.step));
    if (chart.level > plot.y.low) plot.references.push_back({chart.level});
    plot.has_key = chart.curves.size() > 1;
    return plot;
}

namespace {

constexpr double most_correlation = 5, most_j = 10;

double l_minus_r(double k, double r) { return std::sqrt(std::max(k, 0.0) / std::numbers::pi) - r; }

/// A curve in the same colour, with dashes.
std::size_t dashed(std::size_t index) { return index + palette().size(); }

/// A round step with two to five labels, which do not run into each other however long they are.
double few_labels(const PlotAxis& axis)
{
    const double least = (axis.high - axis.low) / 5, unit = std::pow(10, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * unit >= least) return step * unit;
    return 10 * unit;
}

/// Distance 0, where all curves begin, is no row.
Plot function_plot(const PlaneRegionCurves& curves, RegionFunction function, const char* name,
                   const std::function<double(double value, double r)>& shown)
{
    Plot plot;
    PlotCurve curve{.index = curves.index};
    const auto f = static_cast<std::size_t>(function);
    for (const RegionCurveRow& row : *curves.rows) {
        curve.x.push_back(row.distance);
        curve.y.push_back(shown(row.value[f], row.distance));
        curve.low.push_back(shown(row.low[f], row.distance));
        curve.high.push_back(shown(row.high[f], row.distance));
    }
    curve.end = curve.x.back();
    plot.x = {.label = curves.is_in_metres ? "distance (m)" : "distance (units of the region)", .high = curve.x.back()};
    plot.x.step = few_labels(plot.x);
    plot.y = {.label = name};
    plot.curves.push_back(std::move(curve));
    return plot;
}

double value_itself(double value, double) { return value; }

/// The largest and the smallest finite number of a curve and its band.
std::pair<double, double> extent(const PlotCurve& curve)
{
    double low = 0, high = 0;
    for (const auto* numbers : {&curve.y, &curve.low, &curve.high})
        for (const double number : *numbers)
            if (std::isfinite(number)) low = std::min(low, number), high = std::max(high, number);
    return {low, high};
}

void add_formula(Plot& plot, const PlaneRegionCurves& curves, const std::function<double(const RegionCurveRow&)>& y)
{
    PlotCurve formula{.index = dashed(curves.index)};
    for (const RegionCurveRow& row : *curves.rows) {
        formula.x.push_back(row.distance);
        formula.y.push_back(y(row));
    }
    formula.end = formula.x.back();
    plot.curves.push_back(std::move(formula));
}

}

Plot region_pair_correlation_plot(const PlaneRegionCurves& curves)
{
    Plot plot = function_plot(curves, RegionFunction::pair_correlation, "pair correlation", value_itself);
    plot.references = {{1, "", 0}};
    const double top = std::clamp(std::ceil(2.2 * highest(plot.curves, 0)) / 2, 1.5, most_correlation);
    plot.y.high = top;
    plot.y.step = top > 2.5 ? 1 : 0.5;
    return plot;
}

Plot region_l_plot(const PlaneRegionCurves& curves)
{
    Plot plot = function_plot(curves, RegionFunction::k, "L − distance", l_minus_r);
    plot.references = {{0, "", 0}};
    const auto [low, high] = extent(plot.curves.front());
    const double span = std::max(high - low, 1e-12);
    plot.y.low = low - 0.05 * span;
    plot.y.high = high + 0.05 * span;
    plot.y.step = few_labels(plot.y);
    plot.left_margin = 9;
    add_formula(plot, curves, [](const RegionCurveRow& row) { return l_minus_r(row.k_isotropic, row.distance); });
    return plot;
}

Plot region_distance_plot(const PlaneRegionCurves& curves, RegionFunction function)
{
    Plot plot = function_plot(curves, function, "share", value_itself);
    plot.y.step = 0.2;
    // The axis ends where nearly all are counted.
    const auto& rows = *curves.rows;
    const auto end = std::ranges::find_if(rows, [](const RegionCurveRow& row) {
        return row.of(RegionFunction::nearest) > 0.999 && row.of(RegionFunction::empty_space) > 0.999;
    });
    if (end != rows.end()) plot.x.high = std::min(rows.back().distance, 1.6 * end->distance);
    plot.x.step = few_labels(plot.x);
    if (curves.has_formula)
        add_formula(plot, curves, [&](const RegionCurveRow& row) {
            return 1 - std::exp(-curves.intensity * std::numbers::pi * row.distance * row.distance);
        });
    return plot;
}

Plot region_j_plot(const PlaneRegionCurves& curves)
{
    Plot plot = function_plot(curves, RegionFunction::j, "J", value_itself);
    plot.references = {{1, "", 0}};
    plot.y.high = std::clamp(std::ceil(1.1 * highest(plot.curves, 1)), 2.0, most_j);
    plot.y.step = plot.y.high > 4 ? 2 : 0.5;
    const auto& rows = *curves.rows;
    const auto last = std::find_if(rows.rbegin(), rows.rend(), [](const RegionCurveRow& row) {
        return std::isfinite(row.of(RegionFunction::j)) || std::isfinite(row.high[4]);
    });
    if (last != rows.rend()) plot.x.high = last->distance;
    plot.x.step = few_labels(plot.x);
    return plot;
}

}
