#include "reports/plots/curves.hpp"

#include "reports/plots/plot_style.hpp"
#include "reports/words/number_format.hpp"
#include "results/radial_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

namespace poissonlab {

namespace {

constexpr double most_power_shown = 5;
constexpr double most_db_shown = 30;
constexpr auto unit_frequency = "frequency (cycles per unit length)";
constexpr auto spacing_frequency = "frequency (cycles per mean spacing of the points)";
constexpr auto principal_unit = "frequency (in units of the principal frequency 1/d_{min})";
constexpr double principal_units_shown = 4;

// Where the principal frequency is, and an axis in units of it.
std::string principal_frequency_marks(const Curve& curve)
{
    if (!curve.principal_frequency || *curve.principal_frequency > curve.max_frequency) return {};
    const double principal = *curve.principal_frequency;
    return top_axis("in units of the principal frequency 1/d_{min}", curve.max_frequency / principal) +
           upright_mark(principal, "1/d_{min}", principal >= 0.7 * curve.max_frequency);
}

std::string data_block(const Curve& curve)
{
    std::string block = fmt::format("$series{} << END\n", curve.index);
    for (const auto& bin : curve.bins) {
        const auto finite = [](double v) { return std::isfinite(v) ? fmt::format("{:.6g}", v) : "NaN"; };
        fmt::format_to(std::back_inserter(block), "{:.6g} {} {} {} {}\n", bin.frequency, finite(bin.power),
                       finite(bin.anisotropy_db), finite(bin.power - bin.power_error),
                       finite(bin.power + bin.power_error));
    }
    return block + "END\n";
}

std::string power_axes(double max_frequency, const CurveScales& scales,
                       const std::string& frequency_label = unit_frequency)
{
    const ValueAxis power{"radially averaged power", 0, scales.max_power, scales.max_power > 2.5 ? 1 : 0.5, 1.4};
    return axes(frequency_label, 0, max_frequency, power) + reference_line(1);
}

std::string anisotropy_axes(double max_frequency, const CurveScales& scales,
                            const std::string& frequency_label = unit_frequency)
{
    return axes(frequency_label, 0, max_frequency, {"anisotropy (dB)", scales.min_db, scales.max_db, 5, 0.4});
}

double max_frequency(const std::vector<Curve>& curves)
{
    return std::ranges::max_element(curves, {}, &Curve::max_frequency)->max_frequency;
}

// The curves of a plot of all series, and what its frequencies are.
struct Overlaid
{
    std::vector<Curve> curves;
    std::string frequency_label = unit_frequency;
};

Overlaid on_one_axis(const std::vector<Curve>& curves)
{
    Overlaid result{curves};
    if (!sizes_differ(curves)) return result;
    result.frequency_label = spacing_frequency;
    for (auto& curve : result.curves) {
        const double spacing = std::pow(static_cast<double>(curve.points), -1.0 / curve.dimension);
        for (auto& bin : curve.bins) bin.frequency *= spacing;
        curve.max_frequency *= spacing;
        curve.label = label_with_points(curve.label, curve.points);
    }
    return result;
}

// Column 2 is power, column 3 anisotropy; columns 4 and 5 are the power one standard error lower and higher.
std::string plot_alone(const Curve& curve, int column)
{
    return data_block(curve) +
           fmt::format("plot $series{0} using 1:{1} with lines {2}", curve.index, column, line_style(curve.index));
}

// The roughness of a curve: how much it goes up and down.
double roughness(const Curve& curve)
{
    double sum = 0;
    for (std::size_t i = 1; i < curve.bins.size(); ++i) sum += std::fabs(curve.bins[i].power - curve.bins[i - 1].power);
    return sum;
}

// Rough curves first, so that they do not bury the smooth ones; the key in the order of the series, one line
// each, in room below the plot.
GnuplotPicture overlay(const std::vector<Curve>& curves, std::string commands, int column,
                       const std::filesystem::path& stem)
{
    std::vector<const Curve*> order;
    std::vector<KeyEntry> key;
    for (const auto& curve : curves) {
        order.push_back(&curve);
        commands += data_block(curve);
        key.push_back({curve.index, curve.label});
    }
    std::ranges::stable_sort(order, std::greater{}, [](const Curve* curve) { return roughness(*curve); });
    std::string plot;
    for (const Curve* curve : order)
        plot += fmt::format("{}$series{} using 1:{} with lines {} notitle", plot.empty() ? "plot " : ", ", curve->index,
                            column, line_style(curve->index));
    return with_key(commands, plot, key, stem);
}

}

bool sizes_differ(const std::vector<Curve>& curves)
{
    if (curves.empty()) return false;
    const auto [fewest, most] = std::ranges::minmax(curves, {}, &Curve::points);
    const auto [flattest, deepest] = std::ranges::minmax(curves, {}, &Curve::dimension);
    return flattest.dimension != deepest.dimension || 10 * most.points > 11 * fewest.points;
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

CurveScales common_scales(const std::vector<Curve>& curves)
{
    double power = 0;
    double low = 0;
    double high = -100;
    for (const auto& curve : curves) {
        power = std::max(power, peak_power(curve.bins).power);
        low = std::min(low, curve.background_db);
        for (const auto& bin : curve.bins)
            if (std::isfinite(bin.anisotropy_db)) high = std::max(high, bin.anisotropy_db);
    }
    CurveScales scales;
    scales.max_power = std::clamp(std::ceil(2.2 * power) / 2, 1.5, most_power_shown);
    scales.min_db = 5 * std::floor(low / 5) - 5;
    scales.max_db = std::clamp(5 * std::ceil(high / 5), scales.min_db + 15, most_db_shown);
    return scales;
}

GnuplotPicture plot_radial_power(const Curve& curve, const CurveScales& scales, const std::filesystem::path& stem)
{
    const auto band = fmt::format(", $series{0} using 1:4:5 with filledcurves fc rgb '{1}' fs transparent solid 0.25 "
                                  "noborder",
                                  curve.index, curve_color(curve.index));
    return {power_axes(curve.max_frequency, scales) + principal_frequency_marks(curve) + plot_alone(curve, 2) + band,
            panel_width, panel_height, stem};
}

GnuplotPicture plot_anisotropy(const Curve& curve, const CurveScales& scales, const std::filesystem::path& stem)
{
    const auto text =
        fmt::format("set label '−10 log_{{10}} {} = {} dB' at graph 1, first {:.6g} right "
                    "offset 0,-1.2 textcolor rgb '{}'\n",
                    curve.realizations, format_fixed(curve.background_db, 1), curve.background_db, mark_color);
    return {anisotropy_axes(curve.max_frequency, scales) + reference_line(curve.background_db) + text +
                principal_frequency_marks(curve) + plot_alone(curve, 3),
            panel_width, panel_height, stem};
}

GnuplotPicture overlay_radial_power(const std::vector<Curve>& curves, const CurveScales& scales,
                                    const std::filesystem::path& stem)
{
    const auto [shown, label] = on_one_axis(curves);
    return overlay(shown, power_axes(max_frequency(shown), scales, label), 2, stem);
}

GnuplotPicture overlay_anisotropy(const std::vector<Curve>& curves, const CurveScales& scales,
                                  const std::filesystem::path& stem)
{
    const auto [shown, label] = on_one_axis(curves);
    auto commands = anisotropy_axes(max_frequency(shown), scales, label);
    std::set<double> backgrounds;
    for (const auto& curve : curves) backgrounds.insert(curve.background_db);
    for (const double db : backgrounds) commands += reference_line(db);
    return overlay(shown, commands, 3, stem);
}

std::vector<Curve> principal_curves(const std::vector<Curve>& curves)
{
    std::vector<Curve> result;
    for (auto curve : curves) {
        if (!curve.principal_frequency || *curve.principal_frequency > curve.max_frequency) continue;
        for (auto& bin : curve.bins) bin.frequency /= *curve.principal_frequency;
        curve.max_frequency = std::min(curve.max_frequency / *curve.principal_frequency, principal_units_shown);
        result.push_back(std::move(curve));
    }
    return result;
}

GnuplotPicture overlay_principal_power(const std::vector<Curve>& curves, const CurveScales& scales,
                                       const std::filesystem::path& stem)
{
    return overlay(curves, power_axes(max_frequency(curves), scales, principal_unit), 2, stem);
}

}
