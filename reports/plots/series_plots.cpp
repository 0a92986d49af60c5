#include "reports/plots/series_plots.hpp"

#include "reports/words/number_format.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace poissonlab {
namespace {

struct ValueRange
{
    double low = 0;
    double high = 0;

    void add(double value)
    {
        low = low > 0 ? std::min(low, value) : value;
        high = std::max(high, value);
    }
};

}

std::vector<std::string> integrands_of(const std::vector<IntegrationCurve>& curves)
{
    std::vector<std::string> names;
    for (const auto& curve : curves)
        if (std::ranges::find(names, curve.integrand) == names.end()) names.push_back(curve.integrand);
    return names;
}

Plot integration_error_plot(const std::vector<IntegrationCurve>& curves, const std::string& integrand)
{
    Plot plot;
    ValueRange points, errors;
    for (const auto& source : curves) {
        if (source.integrand != integrand) continue;
        PlotCurve curve{source.index, source.label};
        curve.has_bars = true;
        for (const auto& sample : source.samples) {
            points.add(sample.points);
            curve.end = std::max(curve.end, sample.points);
            if (!(sample.rms_error > 0)) continue;
            errors.add(sample.rms_error);
            curve.x.push_back(sample.points);
            curve.y.push_back(sample.rms_error);
            curve.low.push_back(sample.rms_error - sample.standard_error);
            curve.high.push_back(sample.rms_error + sample.standard_error);
        }
        curve.dots = curve.y;
        plot.curves.push_back(std::move(curve));
    }
    if (!(errors.low > 0)) errors = {1, 1};
    plot.x = {.label = "number of points N", .low = points.low, .step = 4, .logarithmic = true};
    plot.y = {.label = "RMS error of the integral",
              .low = std::pow(10, std::floor(std::log10(errors.low))),
              .high = std::pow(10, std::ceil(std::log10(errors.high))),
              .step = 10,
              .logarithmic = true};
    // Errors of random points fall with slope -1/2, here from the upper left.
    plot.slopes = {
        {points.low, errors.high, points.high, errors.high * std::sqrt(points.low / points.high), "N^{−1/2}"}};
    plot.left_margin = 9;
    plot.right_margin = 4;
    return together(std::move(plot));
}

namespace {

constexpr double columns_of_a_plot = 1000; // more points than these are not seen
constexpr std::size_t most_linear_iterations = 100;

/// Returns the place of an iteration on the axis: a logarithmic axis starts at 1, so that iteration 0 has a place.
class IterationAxis
{
public:
    explicit IterationAxis(const std::vector<IterationCurve>& curves)
    {
        for (const auto& curve : curves) last_ = std::max(last_, curve.stored->count());
    }

    double position(std::size_t iteration) const
    {
        return static_cast<double>(is_logarithmic() ? iteration + 1 : iteration);
    }
    double end() const { return position(last_); }

    // The column of pixels that an iteration falls into, about.
    double column(std::size_t iteration) const
    {
        const double at = position(iteration);
        return std::floor(columns_of_a_plot * (is_logarithmic() ? std::log(at) / std::log(end()) : at / end()));
    }

    // Ticks of a logarithmic axis are at 0, 1, 10, 100 ... iterations, which are no powers of ten on it.
    PlotAxis axis() const
    {
        if (!is_logarithmic()) return {.label = "iterations", .step = end() <= 10 ? 1.0 : 0.0};
        PlotAxis axis{.label = "iterations (logarithmic)", .low = 1, .logarithmic = true, .ticks = {{1, "0"}}};
        for (std::size_t i = 1; i <= last_; i *= 10) axis.ticks.emplace_back(position(i), format_count(i));
        return axis;
    }

    bool is_logarithmic() const { return last_ > most_linear_iterations; }

private:
    std::size_t last_ = 1;
};

/// The first of the iterations that fall into one column of pixels.
PlotCurve curve_of(const IterationCurve& source, const IterationSpread& values, const IterationAxis& axis)
{
    PlotCurve curve{source.index, source.label};
    curve.end = axis.end();
    for (std::size_t i = 0; i < values.mean.size(); ++i) {
        const bool seen = i > 0 && axis.column(i) == axis.column(i - 1);
        if (seen && i + 1 < values.mean.size()) continue;
        curve.x.push_back(axis.position(i));
        curve.y.push_back(values.mean[i]);
        curve.low.push_back(values.min[i]);
        curve.high.push_back(values.max[i]);
    }
    return curve;
}

Plot plot_of(const std::vector<IterationCurve>& curves, IterationSpread Iterations::*spread)
{
    const IterationAxis axis(curves);
    Plot plot;
    plot.x = axis.axis();
    if (axis.is_logarithmic()) plot.right_margin = 3; // "1,000" stands at the end
    for (const auto& curve : curves) plot.curves.push_back(curve_of(curve, curve.stored->*spread, axis));
    return plot;
}

}

double least_energy(int dimension)
{
    return dimension == 2 ? 5 / (18 * std::numbers::sqrt3) : 19 / (64 * std::cbrt(2.0));
}

Plot relative_radius_plot(const std::vector<IterationCurve>& curves)
{
    Plot plot = plot_of(curves, &Iterations::relative_radius);
    double radius = 0;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        const Iterations& stored = *curves[k].stored;
        radius = std::max(radius, std::ranges::max(stored.relative_radius.max));
        if (!stored.relative_radius_within_tiles) continue;
        radius = std::max(radius, std::ranges::max(stored.relative_radius_within_tiles->mean));
        plot.curves[k].dots = curve_of(curves[k], *stored.relative_radius_within_tiles, IterationAxis(curves)).y;
    }
    const double top = std::max(0.2, std::ceil(10 * radius - 1e-9) / 10);
    plot.y = {.label = "relative radius", .high = top, .step = top > 0.5 ? 0.2 : 0.1};
    return plot;
}

Plot energy_plot(const std::vector<IterationCurve>& curves)
{
    Plot plot = plot_of(curves, &Iterations::energy);
    const bool has_least = !curves.front().is_own_energy;
    double low = has_least ? least_energy(curves.front().dimension) : 0.05;
    double high = low;
    std::set<int> dimensions;
    for (const auto& curve : curves) {
        low = std::min(low, std::ranges::min(curve.stored->energy.min));
        high = std::max(high, std::ranges::max(curve.stored->energy.max));
        if (!has_least) continue;
        low = std::min(low, least_energy(curve.dimension));
        dimensions.insert(curve.dimension);
    }
    const double bottom = std::floor(20 * low - 0.2) / 20; // there is room for the words below the least energy
    const double top = std::max(std::ceil(20 * high) / 20, bottom + 0.1);
    plot.y = {.label = "energy", .low = bottom, .high = top, .step = top - bottom > 0.5 ? 0.2 : 0.05};
    plot.left_margin = 8.5; // "0.25" is wide
    for (const int dimension : dimensions)
        plot.references.push_back(
            {least_energy(dimension), dimension == 2 ? "hexagonal lattice" : "body-centred cubic lattice", -0.7});
    return plot;
}

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
