#include "reports/plots/curves.hpp"

#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace poissonlab {

namespace {

constexpr double most_power_shown = 5;
constexpr double most_db_shown = 30;

/// What frequencies are multiplied by.
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

/// Where the principal frequency is, and an axis in units of it.
Plot with_principal_frequency(Plot plot, const Curve& curve)
{
    if (!curve.has_principal_in_sight()) return plot;
    const double principal = *curve.principal_frequency;
    plot.top = {"in units of the principal frequency 1/d_{min}", curve.max_frequency / principal};
    plot.marks.push_back({principal, "1/d_{min}", principal >= 0.7 * curve.max_frequency});
    return plot;
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
              .floor = 1e-3};
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

Plot power_alone(const Plot& all, std::size_t index, const Curve& curve)
{
    return with_principal_frequency(alone(all, index), curve);
}

Plot anisotropy_alone(const Plot& all, std::size_t index, const Curve& curve)
{
    Plot plot = with_principal_frequency(alone(all, index), curve);
    plot.references = {
        {curve.background_db,
         fmt::format("−10 log_{{10}} {} = {} dB", curve.realizations, format_fixed(curve.background_db, 1)), -1.2}};
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
