#include "reports/curves.hpp"

#include "reports/number_format.hpp"
#include "reports/radial_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <set>

namespace poissonlab {

namespace {

constexpr double most_power_shown = 5;
constexpr double most_db_shown = 30;
constexpr int panel_width = 320;
constexpr int panel_height = 340;
constexpr int overlay_width = 540;
constexpr int overlay_plot_height = 328;
constexpr int key_line_height = 19;
constexpr std::size_t longest_key_text = 64; // without the number of points

// After Okabe and Ito, whose colours people with colour deficiencies tell apart.
constexpr std::array<const char*, 7> palette = {"#0072b2", "#d55e00", "#009e73", "#c4569a",
                                                "#b88600", "#3aa0dc", "#555555"};
constexpr auto frame_color = "#555a61";
constexpr auto grid_color = "#e3e5e8";
constexpr auto mark_color = "#33373d";

// Colours repeat after the palette's end, then with another dash pattern.
std::string line_style(std::size_t index)
{
    constexpr std::array<const char*, 4> dashes = {"1", "(8,4)", "(2,3)", "(10,3,2,3)"};
    return fmt::format("lw 1.3 lc rgb '{}' dt {}", curve_color(index),
                       dashes[index / palette.size() % dashes.size()]);
}

constexpr auto unit_frequency = "frequency (cycles per unit length)";
constexpr auto spacing_frequency = "frequency (cycles per mean spacing of the points)";

// `label_offset`: how far the value label moves towards the axis, in characters; minus signs need room.
std::string axes(double max_frequency, const std::string& frequency_label, const std::string& value_label,
                 double low, double high, double step, double label_offset)
{
    return fmt::format("set border 3 lw 0.8 lc rgb '{}'\n"
                       "set tics nomirror out scale 0.6\n"
                       "set minussign\n"
                       "set grid ytics lw 0.6 lt 1 lc rgb '{}'\n"
                       "set xrange [0:{:g}]\nset yrange [{:g}:{:g}]\nset ytics {:g}\n"
                       "set xlabel '{}' offset 0,0.4\n"
                       "set ylabel '{}' offset {:g},0\n"
                       "set lmargin 7\nset rmargin 2\nset tmargin 0.7\nunset key\n",
                       frame_color, grid_color, max_frequency, low, high, step, frequency_label, value_label,
                       label_offset);
}

// In front of the curves: a curve that lies on it is the best that can happen, and must be seen to.
std::string reference_line(double height)
{
    return fmt::format("set arrow from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead front "
                       "lw 0.8 dt (6,4) lc rgb '{1}'\n",
                       height, mark_color);
}

// A dotted upright line with its name at the top, on the side that has room.
std::string principal_frequency_mark(const Curve& curve)
{
    if (!curve.principal_frequency || *curve.principal_frequency > curve.max_frequency) return {};
    const bool left_half = *curve.principal_frequency < 0.7 * curve.max_frequency;
    return fmt::format(
        "set arrow from first {0:.6g}, graph 0 to first {0:.6g}, graph 1 nohead back lw 1 dt (2,3) "
        "lc rgb '{1}'\n"
        "set label '1/d_{{min}}' at first {0:.6g}, graph 0.97 {2} textcolor rgb '{1}'\n",
        *curve.principal_frequency, mark_color, left_half ? "left offset 0.5,0" : "right offset -0.5,0");
}

std::string data_block(std::size_t index, const Curve& curve)
{
    std::string block = fmt::format("$series{} << END\n", index);
    for (const auto& bin : curve.bins) {
        const auto finite = [](double v) { return std::isfinite(v) ? fmt::format("{:.6g}", v) : "NaN"; };
        fmt::format_to(std::back_inserter(block), "{:.6g} {} {}\n", bin.frequency, finite(bin.power),
                       finite(bin.anisotropy_db));
    }
    return block + "END\n";
}

std::string key_text(const std::string& label)
{
    if (label.size() <= longest_key_text) return label;
    // Cut between characters, not inside one.
    auto end = longest_key_text;
    while (end > 0 && (static_cast<unsigned char>(label[end]) & 0xc0U) == 0x80U) --end;
    return label.substr(0, end) + "…";
}

std::string power_axes(double max_frequency, const CurveScales& scales,
                       const std::string& frequency_label = unit_frequency)
{
    return axes(max_frequency, frequency_label, "radially averaged power", 0, scales.max_power,
                scales.max_power > 2.5 ? 1 : 0.5, 1.4) +
           reference_line(1);
}

std::string anisotropy_axes(double max_frequency, const CurveScales& scales,
                            const std::string& frequency_label = unit_frequency)
{
    return axes(max_frequency, frequency_label, "anisotropy (dB)", scales.min_db, scales.max_db, 5, 0.4);
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
    for (auto& curve : result.curves) curve.label = key_text(curve.label);
    if (!sizes_differ(curves)) return result;
    result.frequency_label = spacing_frequency;
    for (auto& curve : result.curves) {
        const double spacing = std::pow(static_cast<double>(curve.points), -1.0 / curve.dimension);
        for (auto& bin : curve.bins) bin.frequency *= spacing;
        curve.max_frequency *= spacing;
        curve.label = fmt::format("{} ({} points)", curve.label, format_count(curve.points));
    }
    return result;
}

// Column 2 is power, column 3 anisotropy.
std::string plot_alone(const Curve& curve, std::size_t index, int column)
{
    return data_block(index, curve) +
           fmt::format("plot $series{0} using 1:{1} with lines {2}", index, column, line_style(index));
}

// The roughness of a curve: how much it goes up and down.
double roughness(const Curve& curve)
{
    double sum = 0;
    for (std::size_t i = 1; i < curve.bins.size(); ++i)
        sum += std::fabs(curve.bins[i].power - curve.bins[i - 1].power);
    return sum;
}

// Rough curves first, so that they do not bury the smooth ones; the key in the order of the series, one line
// each, in room below the plot.
GnuplotPicture overlay(const std::vector<Curve>& curves, std::string commands, int column,
                       const std::filesystem::path& stem)
{
    std::vector<std::size_t> order(curves.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return roughness(curves[i]); });

    commands += "set key below left Left reverse maxcols 1 samplen 2.5 spacing 1.15 height 0.8\n";
    for (std::size_t i = 0; i < curves.size(); ++i) commands += data_block(i, curves[i]);
    std::string plot;
    for (const auto i : order)
        plot += fmt::format("{}$series{} using 1:{} with lines {} notitle", plot.empty() ? "plot " : ", ", i,
                            column, line_style(i));
    for (std::size_t i = 0; i < curves.size(); ++i)
        plot += fmt::format(", keyentry with lines {} title {} noenhanced", line_style(i),
                            gnuplot_quoted(curves[i].label));
    const int height = overlay_plot_height + key_line_height * static_cast<int>(curves.size());
    return {commands + plot, overlay_width, height, stem};
}

}

bool sizes_differ(const std::vector<Curve>& curves)
{
    const auto [fewest, most] = std::ranges::minmax(curves, {}, &Curve::points);
    const auto [flattest, deepest] = std::ranges::minmax(curves, {}, &Curve::dimension);
    return flattest.dimension != deepest.dimension || 10 * most.points > 11 * fewest.points;
}

std::string curve_color(std::size_t index) { return palette[index % palette.size()]; }

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

GnuplotPicture plot_radial_power(const Curve& curve, std::size_t index, const CurveScales& scales,
                                 const std::filesystem::path& stem)
{
    return {power_axes(curve.max_frequency, scales) + principal_frequency_mark(curve) +
                plot_alone(curve, index, 2),
            panel_width, panel_height, stem};
}

GnuplotPicture plot_anisotropy(const Curve& curve, std::size_t index, const CurveScales& scales,
                               const std::filesystem::path& stem)
{
    const auto text = fmt::format("set label '−10 log_{{10}} {} = {} dB' at graph 1, first {:.6g} right "
                                  "offset 0,-1.2 textcolor rgb '{}'\n",
                                  curve.realizations, format_fixed(curve.background_db, 1),
                                  curve.background_db, mark_color);
    return {anisotropy_axes(curve.max_frequency, scales) + reference_line(curve.background_db) + text +
                principal_frequency_mark(curve) + plot_alone(curve, index, 3),
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

}
