#include "reports/plots/curves.hpp"

#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace poissonlab {

namespace {

constexpr double most_power_shown = 5;
constexpr double most_db_shown = 30;
constexpr double least_power_on_log_axes = 1e-10; // rounding leaves less where lattices have no power

/// The factor of frequencies.
double frequency_factor(const Curve& curve, LengthUnit unit)
{
    if (unit == LengthUnit::absolute) return 1;
    if (unit == LengthUnit::principal) return 1 / *curve.principal_frequency;
    return std::pow(static_cast<double>(curve.points), -1.0 / curve.dimension);
}

/// A curve without its values.
PlotCurve with_frequencies(const NumberedCurve& numbered, LengthUnit unit)
{
    const Curve& curve = *numbered.curve;
    const double factor = frequency_factor(curve, unit);
    PlotCurve result{numbered.index, numbered.label, {}, {}, {}, {}, {}, false, factor * curve.max_frequency};
    if (unit == LengthUnit::principal) result.end = std::min(result.end, principal_units_shown);
    for (const auto& bin : curve.bins) result.x.push_back(factor * bin.frequency);
    return result;
}

/// Marks the principal frequency, and adds an axis in units of it.
Plot with_principal_frequency(Plot plot, const Curve& curve)
{
    if (!curve.has_principal_in_sight()) return plot;
    const double principal = *curve.principal_frequency;
    plot.top = {"in units of the principal frequency 1/d_{min}", curve.max_frequency / principal};
    plot.marks.push_back({principal, "1/d_{min}", principal >= 0.7 * curve.max_frequency});
    return plot;
}

/// The power of ten at or below a value, and the one at or above it.
double decade_below(double value) { return std::pow(10, std::floor(std::log10(value))); }
double decade_above(double value) { return std::pow(10, std::ceil(std::log10(value))); }

/// The logarithmic axis of power that shows these curves.
PlotAxis power_decades(const std::vector<PlotCurve>& curves)
{
    double least = 0.1;
    for (const auto& curve : curves)
        for (const double power : curve.y)
            if (power > 0) least = std::min(least, power);
    return {.label = "radially averaged power",
            .low = decade_below(std::max(least, least_power_on_log_axes)),
            .high = decade_above(highest(curves, 2)),
            .step = 10,
            .logarithmic = true};
}

/// The line P ~ f^b of a fit over its frequencies. A line of least squares passes through the weighted mean of what it
/// is fitted to, which are logarithms.
std::optional<SlopeMark> fitted_line(const std::vector<RadialBin>& bins, const LowFrequencyPower& fit)
{
    double weight = 0, frequency = 0, power = 0;
    for (const auto& bin : bins) {
        if (bin.frequency < fit.begin || bin.frequency > fit.end || !(bin.power > 0)) continue;
        const auto samples = static_cast<double>(bin.samples);
        weight += samples;
        frequency += samples * std::log(bin.frequency);
        power += samples * std::log(bin.power);
    }
    if (weight == 0) return std::nullopt;
    const auto height = [&](double f) {
        return std::exp(power / weight + fit.exponent * (std::log(f) - frequency / weight));
    };
    return SlopeMark{fit.begin, height(fit.begin), fit.end, height(fit.end),
                     fmt::format("f^{{{}}}", format_fixed(fit.exponent, 1))};
}

/// The part of a line on logarithmic axes that lies above a height; nothing where its right end does not.
std::optional<SlopeMark> above(double height, SlopeMark line)
{
    if (line.right_height <= height) return std::nullopt;
    if (line.left_height >= height) return line;
    const double part = std::log(height / line.right_height) / std::log(line.left_height / line.right_height);
    line.left = line.right * std::pow(line.left / line.right, part);
    line.left_height = height;
    return line;
}

/// Lines of f^2, f^4 and f^6 through one place, the power at which the first rise of good sets begins, to compare
/// curves with; where no power is as low, they would say nothing.
std::vector<SlopeMark> power_laws(const Plot& plot, double spacing_frequency)
{
    constexpr double shown_below = 1e-5, begin = 0.4, power = 0.03;
    std::vector<SlopeMark> laws;
    const double right = begin * spacing_frequency;
    if (plot.y.low > shown_below || !(plot.x.low < right)) return laws;
    for (const int exponent : {2, 4, 6}) {
        const SlopeMark whole{
            plot.x.low, power * std::pow(plot.x.low / right, exponent), right, power, fmt::format("f^{}", exponent),
            true};
        if (const auto part = above(plot.y.low, whole)) laws.push_back(*part);
    }
    return laws;
}

}

std::string frequency_words(LengthUnit unit)
{
    if (unit == LengthUnit::absolute) return "frequency (cycles per unit length)";
    if (unit == LengthUnit::spacing) return "frequency (cycles per mean spacing of the points)";
    return "frequency (in units of the principal frequency 1/d_{min})";
}

std::string distance_words(LengthUnit unit)
{
    if (unit == LengthUnit::absolute) return "distance (unit lengths)";
    if (unit == LengthUnit::spacing) return "distance (mean spacings of the points)";
    return "distance (in units of d_{min})";
}

Plot power_plot(const std::vector<NumberedCurve>& curves, LengthUnit unit)
{
    Plot plot{.key = "power", .references = {{1, "", 0}}};
    for (const auto& numbered : curves) {
        PlotCurve curve = with_frequencies(numbered, unit);
        for (const auto& bin : numbered.curve->bins) {
            curve.y.push_back(bin.power);
            curve.low.push_back(bin.power - bin.power_error);
            curve.high.push_back(bin.power + bin.power_error);
        }
        plot.curves.push_back(std::move(curve));
    }
    const double top = std::clamp(std::ceil(2.2 * highest(plot.curves, 0)) / 2, 1.5, most_power_shown);
    plot.x = {.label = frequency_words(unit)};
    plot.y = {.label = "radially averaged power",
              .high = top,
              .step = top > 2.5 ? 1 : 0.5,
              .most = most_power_shown,
              .floor = 1e-8};
    return plot;
}

Plot anisotropy_plot(const std::vector<NumberedCurve>& curves, LengthUnit unit)
{
    Plot plot{.key = "anisotropy"};
    std::set<double> backgrounds;
    for (const auto& numbered : curves) {
        PlotCurve curve = with_frequencies(numbered, unit);
        for (const auto& bin : numbered.curve->bins) curve.y.push_back(bin.anisotropy_db);
        plot.curves.push_back(std::move(curve));
        backgrounds.insert(numbered.curve->background_db);
    }
    for (const double db : backgrounds) plot.references.push_back({db, "", 0});
    const double low = 5 * std::floor(std::min(0.0, backgrounds.empty() ? 0.0 : *backgrounds.begin()) / 5) - 5;
    const double high = std::clamp(5 * std::ceil(highest(plot.curves, -100) / 5), low + 15, most_db_shown);
    plot.x = {.label = frequency_words(unit)};
    plot.y = {.label = "anisotropy (dB)", .low = low, .high = high, .step = 5, .most = most_db_shown};
    return plot;
}

Plot anisotropy_comparison(const std::vector<NumberedCurve>& curves, LengthUnit unit)
{
    Plot plot = anisotropy_plot(curves, unit);
    if (plot.references.size() < 2) return plot;
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (double& db : plot.curves[i].y) db -= curves[i].curve->background_db;
    plot.references = {{0, "", 0}};
    const double high = std::clamp(5 * std::ceil(highest(plot.curves, 0) / 5), 10.0, most_db_shown);
    plot.y = {.label = "anisotropy above chance (dB)", .low = -5, .high = high, .step = 5, .most = most_db_shown};
    return plot;
}

Plot structure_factor_plot(const std::vector<NumberedCurve>& curves, LengthUnit unit)
{
    Plot plot = power_plot(curves, unit);
    plot.key = "";
    plot.y = power_decades(plot.curves);
    plot.left_margin = 9;
    plot.x.logarithmic = true;
    plot.x.step = 10;
    plot.x.low = std::numeric_limits<double>::infinity();
    const double below = plot.y.low / 1000;
    for (auto& curve : plot.curves) {
        if (!curve.x.empty()) plot.x.low = std::min(plot.x.low, curve.x.front());
        for (auto* values : {&curve.y, &curve.low, &curve.high})
            for (double& value : *values) value = std::max(value, below);
    }
    double spacing = 0; // the lowest frequency of one cycle per mean spacing
    for (const auto& numbered : curves) {
        const double one =
            frequency_factor(*numbered.curve, unit) / frequency_factor(*numbered.curve, LengthUnit::spacing);
        spacing = spacing == 0 ? one : std::min(spacing, one);
    }
    plot.slopes = power_laws(plot, spacing);
    return plot;
}

Plot structure_factor_alone(const Plot& all, std::size_t index, const Curve& curve,
                            const std::optional<LowFrequencyPower>& fit)
{
    Plot plot = alone(all, index);
    plot.slopes.clear();
    if (!fit) return plot;
    if (const auto line = fitted_line(curve.bins, *fit))
        if (const auto part = above(plot.y.low, *line)) plot.slopes.push_back(*part);
    return plot;
}

Plot power_alone(const Plot& all, std::size_t index, const Curve& curve)
{
    return with_principal_frequency(alone(all, index), curve);
}

Plot anisotropy_alone(const Plot& all, std::size_t index, const Curve& curve)
{
    Plot plot = with_principal_frequency(alone(all, index), curve);
    plot.references = {
        {curve.background_db,
         fmt::format("−10 log_{{10}} {} = {} dB", curve.periodograms, format_fixed(curve.background_db, 1)), -1.2}};
    return plot;
}

std::string label_with_points(const std::string& label, std::size_t points)
{
    if ((label + ", ").find(fmt::format("N = {}, ", format_count(points))) != std::string::npos) return label;
    return fmt::format("{} ({} points)", label, format_count(points));
}

std::string label_without_points(const std::string& label, std::size_t points)
{
    const auto text = fmt::format("N = {}", format_count(points));
    const auto padded = label + ", ";
    const auto at = padded.find(text + ", ");
    if (at == std::string::npos) return label;
    const auto rest = padded.substr(0, at) + padded.substr(at + text.size() + 2);
    return rest.substr(0, rest.size() - std::min<std::size_t>(rest.size(), 2));
}

}
