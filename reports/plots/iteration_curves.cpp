#include "reports/plots/iteration_curves.hpp"

#include "reports/words/number_format.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace poissonlab {

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

}
