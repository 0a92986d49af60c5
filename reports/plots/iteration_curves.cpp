#include "reports/plots/iteration_curves.hpp"

#include "reports/plots/plot_style.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

namespace poissonlab {

namespace {

constexpr double columns_of_a_plot = 1000; // more points than these are not seen

// A quantity of a curve with the axis that it is drawn over.
struct Quantity
{
    IterationSpread Iterations::*spread;
    ValueAxis axis;
    bool has_least_energy = false;
};

Quantity relative_radius(const IterationScales& scales)
{
    return {&Iterations::relative_radius,
            {"relative radius", 0, scales.max_radius, scales.max_radius > 0.5 ? 0.2 : 0.1, 1.4},
            false};
}

Quantity energy(const IterationScales& scales)
{
    return {
        &Iterations::energy,
        {"energy", scales.min_energy, scales.max_energy, scales.max_energy - scales.min_energy > 0.5 ? 0.2 : 0.05, 1.4},
        true};
}

// Where an iteration stands on the axis: a logarithmic one starts at 1, so that iteration 0 has a place.
double position(std::size_t iteration, const IterationScales& scales)
{
    return static_cast<double>(scales.logarithmic() ? iteration + 1 : iteration);
}

// Ticks at 0, 1, 10, 100 ... iterations, which are no powers of ten on the axis.
std::string logarithmic_ticks(std::size_t iterations)
{
    std::string ticks = "'0' 1";
    for (std::size_t i = 1; i <= iterations; i *= 10) ticks += fmt::format(", '{}' {}", format_count(i), i + 1);
    return "set logscale x\nset rmargin 3\nset xtics (" + ticks + ")\n"; // room for "1,000" at the end
}

std::string iteration_axes(const IterationScales& scales, const ValueAxis& value)
{
    const double last = position(scales.iterations, scales);
    const std::string whole_steps = last <= 10 ? "set xtics 1\n" : "";
    if (!scales.logarithmic()) return axes("iterations", 0, last, value) + whole_steps;
    return axes("iterations (logarithmic)", 1, last, value) + logarithmic_ticks(scales.iterations);
}

// The column of pixels that an iteration falls into, about.
double column(std::size_t iteration, const IterationScales& scales)
{
    const double at = position(iteration, scales);
    const double end = position(scales.iterations, scales);
    return std::floor(columns_of_a_plot * (scales.logarithmic() ? std::log(at) / std::log(end) : at / end));
}

// Columns position, mean, min, max; of iterations that fall into one column of pixels, the first.
std::string data_block(const IterationCurve& curve, const Quantity& quantity, const IterationScales& scales)
{
    const IterationSpread& values = curve.stored->*quantity.spread;
    std::string block = fmt::format("$iterations{} << END\n", curve.index);
    for (std::size_t i = 0; i < values.mean.size(); ++i) {
        const bool seen = i > 0 && column(i, scales) == column(i - 1, scales);
        if (seen && i + 1 < values.mean.size()) continue;
        fmt::format_to(std::back_inserter(block), "{:.10g} {:.6g} {:.6g} {:.6g}\n", position(i, scales), values.mean[i],
                       values.min[i], values.max[i]);
    }
    return block + "END\n";
}

// Of a method that stopped before its first iteration there is only a point.
std::string plot_style(const IterationCurve& curve)
{
    return fmt::format("{} {}", curve.stored->count() == 0 ? "linespoints pt 7 ps 0.5" : "lines",
                       line_style(curve.index));
}

std::string least_energy_mark(const std::vector<IterationCurve>& curves)
{
    std::set<int> dimensions;
    for (const auto& curve : curves) dimensions.insert(curve.dimension);
    std::string commands;
    for (const int dimension : dimensions)
        commands += reference_line(least_energy(dimension)) +
                    fmt::format("set label '{}' at graph 1, first {:.6g} right offset 0,-0.7 "
                                "textcolor rgb '{}'\n",
                                dimension == 2 ? "hexagonal lattice" : "body-centred cubic lattice",
                                least_energy(dimension), mark_color);
    return commands;
}

std::string frame(const std::vector<IterationCurve>& curves, const Quantity& quantity, const IterationScales& scales)
{
    auto commands = iteration_axes(scales, quantity.axis);
    if (quantity.has_least_energy) commands += "set lmargin 8.5\n" + least_energy_mark(curves); // "0.25" is wide
    for (const auto& curve : curves) commands += data_block(curve, quantity, scales);
    return commands;
}

GnuplotPicture plot_alone(const IterationCurve& curve, const Quantity& quantity, const IterationScales& scales,
                          const std::filesystem::path& stem)
{
    const auto plot = fmt::format("plot $iterations{0} using 1:3:4 with filledcurves fc rgb '{1}' "
                                  "fs transparent solid 0.2 noborder, "
                                  "$iterations{0} using 1:2 with {2}",
                                  curve.index, curve_color(curve.index), plot_style(curve));
    return {frame({curve}, quantity, scales) + plot, panel_width, panel_height, stem};
}

GnuplotPicture overlay(const std::vector<IterationCurve>& curves, const Quantity& quantity,
                       const IterationScales& scales, const std::filesystem::path& stem)
{
    std::string plot;
    std::vector<KeyEntry> key;
    for (const auto& curve : curves) {
        plot += fmt::format("{}$iterations{} using 1:2 with {} notitle", plot.empty() ? "plot " : ", ", curve.index,
                            plot_style(curve));
        key.push_back({curve.index, curve.label});
    }
    return with_key(frame(curves, quantity, scales), plot, key, stem);
}

}

double least_energy(int dimension)
{
    return dimension == 2 ? 5 / (18 * std::numbers::sqrt3) : 19 / (64 * std::cbrt(2.0));
}

IterationScales common_iteration_scales(const std::vector<IterationCurve>& curves)
{
    double radius = 0;
    double low = least_energy(curves.front().dimension);
    double high = low;
    IterationScales scales;
    for (const auto& curve : curves) {
        const auto& stored = *curve.stored;
        scales.iterations = std::max(scales.iterations, stored.count());
        radius = std::max(radius, std::ranges::max(stored.relative_radius.max));
        low = std::min({low, least_energy(curve.dimension), std::ranges::min(stored.energy.min)});
        high = std::max(high, std::ranges::max(stored.energy.max));
    }
    scales.max_radius = std::max(0.2, std::ceil(10 * radius - 1e-9) / 10);
    scales.min_energy = std::floor(20 * low - 0.2) / 20; // room for the words below the least energy
    scales.max_energy = std::max(std::ceil(20 * high) / 20, scales.min_energy + 0.1);
    return scales;
}

GnuplotPicture plot_relative_radius(const IterationCurve& curve, const IterationScales& scales,
                                    const std::filesystem::path& stem)
{
    return plot_alone(curve, relative_radius(scales), scales, stem);
}

GnuplotPicture plot_energy(const IterationCurve& curve, const IterationScales& scales,
                           const std::filesystem::path& stem)
{
    return plot_alone(curve, energy(scales), scales, stem);
}

GnuplotPicture overlay_relative_radius(const std::vector<IterationCurve>& curves, const IterationScales& scales,
                                       const std::filesystem::path& stem)
{
    return overlay(curves, relative_radius(scales), scales, stem);
}

GnuplotPicture overlay_energy(const std::vector<IterationCurve>& curves, const IterationScales& scales,
                              const std::filesystem::path& stem)
{
    return overlay(curves, energy(scales), scales, stem);
}

}
