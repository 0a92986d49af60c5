#include "reports/plots/gnuplot_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace poissonlab {

namespace {

constexpr auto mark_color = "#33373d"; // of lines and words that mark something
constexpr auto frame_color = "#555a61";
constexpr auto grid_color = "#e3e5e8";

constexpr int key_line_height = 16;
constexpr int room_below_axis = 56; // for the numbers and the words of the horizontal axis
constexpr std::size_t most_key_characters = 68;

std::string color_of(const PlotCurve& curve) { return curve.color.empty() ? curve_color(curve.index) : curve.color; }

std::string line_style(const PlotCurve& curve)
{
    std::string dashes = curve_dashes(curve.index);
    std::ranges::replace(dashes, ' ', ',');
    return fmt::format("lw 1.3 lc rgb '{}' dt {}", color_of(curve), dashes.empty() ? "1" : "(" + dashes + ")");
}

/// The step between ticks of a linear axis, 1, 2 or 5 times a power of ten, at which numbers of four digits or more do
/// not overlap. 0 leaves the choice to gnuplot, whose steps suit shorter numbers.
double step_for_long_numbers(const PlotAxis& axis)
{
    if (axis.logarithmic || axis.step > 0 || !(axis.high >= 1000)) return axis.step;
    constexpr double characters = 46; // an axis is this many characters long
    const double digits = std::floor(std::log10(axis.high)) + 1;
    const double least = (axis.high - axis.low) * (digits + 2) / characters;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {power, 2 * power, 5 * power})
        if (step >= least) return step;
    return 10 * power;
}

std::string axis_text(const char* name, const PlotAxis& axis, double step)
{
    auto text = fmt::format("set {}range [{:g}:{:.10g}]\n", name, axis.low, axis.high);
    if (axis.logarithmic) text += fmt::format("set logscale {}\n", name);
    if (step > 0) text += fmt::format("set {}tics {:g}\n", name, step);
    std::string ticks;
    for (const auto& [place, words] : axis.ticks)
        ticks += fmt::format("{}{} {:g}", ticks.empty() ? "" : ", ", gnuplot_quoted(words), place);
    return ticks.empty() ? text : text + fmt::format("set {}tics ({})\n", name, ticks);
}

std::string axes(const Plot& plot)
{
    // Minus signs and exponents need room between the numbers and the words.
    const double toward_axis = plot.y.logarithmic ? 0 : plot.y.low < 0 ? 0.4 : 1.4;
    auto text = fmt::format("set border 3 lw 0.8 lc rgb '{}'\nset tics nomirror out scale 0.6\nset minussign\n"
                            "set grid ytics lw 0.6 lt 1 lc rgb '{}'\n"
                            "set xlabel '{}' offset 0,0.4\nset ylabel '{}' offset {:g},0\n"
                            "set lmargin {:g}\nset rmargin {:g}\nset tmargin 0.7\nunset key\n",
                            frame_color, grid_color, plot.x.label, plot.y.label, toward_axis, plot.left_margin,
                            plot.right_margin) +
                axis_text("x", plot.x, step_for_long_numbers(plot.x)) + axis_text("y", plot.y, plot.y.step);
    return plot.y.logarithmic ? text + "set format y '10^{%L}'\n" : text;
}

std::string top_axis(const TopAxis& axis)
{
    const double step = axis.high > 30 ? 10 : axis.high > 12 ? 5 : axis.high > 5 ? 2 : axis.high > 2.5 ? 1 : 0.5;
    return fmt::format("set border 7\nset x2range [0:{:.10g}]\nset x2tics {:g} out scale 0.6\n"
                       "set x2label '{}' offset 0,-0.5\nset tmargin 3\n",
                       axis.high, step, axis.label);
}

/// Draws the line in front of the curves: one must see that a curve lies on it.
std::string reference_line(const ReferenceLine& line)
{
    auto text = fmt::format("set arrow from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead front "
                            "lw 0.8 dt (6,4) lc rgb '{1}'\n",
                            line.height, mark_color);
    if (line.text.empty()) return text;
    return text + fmt::format("set label '{}' at graph 1, first {:.6g} right offset 0,{:g} textcolor rgb '{}'\n",
                              line.text, line.height, line.text_shift, mark_color);
}

std::string upright_mark(const UprightMark& mark)
{
    return fmt::format("set arrow from first {0:.6g}, graph 0 to first {0:.6g}, graph 1 nohead back lw 1 dt (2,3) "
                       "lc rgb '{1}'\n"
                       "set label '{2}' at first {0:.6g}, graph {3:g} {4} textcolor rgb '{1}'\n",
                       mark.x, mark_color, mark.name, mark.name_height,
                       mark.name_on_the_left ? "right offset -0.5,0" : "left offset 0.5,0");
}

std::string slope_mark(const SlopeMark& slope)
{
    return fmt::format("set arrow from {0:.6g}, {1:.6g} to {2:.6g}, {3:.6g} nohead back lw 0.8 dt (6,4) lc rgb '{4}'\n"
                       "set label '{5}' at {6:.6g}, {7:.6g} {8} textcolor rgb '{4}'\n",
                       slope.left, slope.left_height, slope.right, slope.right_height, mark_color, slope.name,
                       slope.name_on_the_left ? slope.left : slope.right,
                       slope.name_on_the_left ? slope.left_height : slope.right_height,
                       slope.name_on_the_left ? "left offset 0.8,0.5" : "left offset 0.4,-0.7");
}

std::string frame(const Plot& plot)
{
    std::string text = axes(plot);
    if (plot.top) text += top_axis(*plot.top);
    for (const auto& line : plot.references) text += reference_line(line);
    for (const auto& mark : plot.marks) text += upright_mark(mark);
    for (const auto& slope : plot.slopes) text += slope_mark(slope);
    return text;
}

/// Columns x, y, low, high, dot.
std::string data_block(const PlotCurve& curve, std::size_t place)
{
    const auto number = [](const std::vector<double>& values, std::size_t i) {
        return i < values.size() && std::isfinite(values[i]) ? fmt::format("{:.6g}", values[i]) : "NaN";
    };
    std::string block = fmt::format("$curve{} << END\n", place);
    for (std::size_t i = 0; i < curve.x.size(); ++i)
        fmt::format_to(std::back_inserter(block), "{:.8g} {} {} {} {}\n", curve.x[i], number(curve.y, i),
                       number(curve.low, i), number(curve.high, i), number(curve.dots, i));
    return block + "END\n";
}

/// Gnuplot's elements of a curve: its band or bars, its line (of a single place there is only a dot), its dots.
std::string curve_text(const PlotCurve& curve, std::size_t place)
{
    const auto color = color_of(curve);
    const auto data = fmt::format("$curve{}", place);
    std::string text;
    if (!curve.low.empty() && !curve.has_bars)
        text += fmt::format("{} using 1:3:4 with filledcurves fc rgb '{}' fs transparent solid 0.25 noborder notitle, ",
                            data, color);
    text += fmt::format("{} using 1:2 with {} {} notitle", data,
                        curve.x.size() == 1 ? "linespoints pt 7 ps 0.5" : "lines", line_style(curve));
    if (!curve.dots.empty())
        text += fmt::format(", {} using 1:5 with points pt 7 ps 0.4 lc rgb '{}' notitle", data, color);
    if (curve.has_bars)
        text += fmt::format(", {} using 1:3:(0):($4-$3) with vectors nohead lw 2.5 lc rgb '{}' notitle", data, color);
    return text;
}

/// The length of a curve's way up and down.
double roughness(const PlotCurve& curve)
{
    double sum = 0;
    for (std::size_t i = 1; i < curve.y.size(); ++i)
        if (const double step = std::fabs(curve.y[i] - curve.y[i - 1]); std::isfinite(step)) sum += step;
    return sum;
}

/// Rough curves come first, so that they do not bury the smooth ones.
std::string plot_command(const Plot& plot)
{
    std::vector<std::size_t> order(plot.curves.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return roughness(plot.curves[i]); });
    std::string command;
    for (const std::size_t i : order) command += (command.empty() ? "plot " : ", ") + curve_text(plot.curves[i], i);
    return command;
}

/// A key at the foot of a picture of that height, below a plot of this one, which keeps its place and its size.
std::string key_place(int height, int plot_height)
{
    const double below = height - plot_height;
    return fmt::format("set bmargin at screen {:.6f}\n"
                       "set key at screen 0.09, screen {:.6f} left top Left reverse maxcols 1 samplen 2.5 spacing 1.15 "
                       "font ',9'\n",
                       (below + room_below_axis) / height, below / height);
}

}

std::string key_label(const std::string& label, std::size_t number)
{
    std::vector<std::size_t> begins; // of characters, which may have several bytes
    for (std::size_t i = 0; i < label.size(); ++i)
        if ((static_cast<unsigned char>(label[i]) & 0xc0U) != 0x80U) begins.push_back(i);
    if (begins.size() <= most_key_characters) return label;
    constexpr std::size_t half = most_key_characters / 2 - 3; // the number needs room
    return fmt::format("{}…{} [{}]", label.substr(0, begins[half]), label.substr(begins[begins.size() - half]), number);
}

GnuplotPicture gnuplot_picture(const Plot& plot, const std::filesystem::path& stem)
{
    auto text = frame(plot);
    for (std::size_t i = 0; i < plot.curves.size(); ++i) text += data_block(plot.curves[i], i);
    const int width = plot.is_overlay ? overlay_width : panel_width;
    const int plot_height = plot.is_overlay ? overlay_height : panel_height;
    if (!plot.is_overlay && !plot.has_key) return {text + plot_command(plot), width, plot_height, stem};
    const int height = plot_height + key_line_height * (static_cast<int>(plot.curves.size()) + 1);
    text += key_place(height, plot_height) + plot_command(plot);
    for (std::size_t i = 0; i < plot.curves.size(); ++i)
        text += fmt::format(", keyentry with lines {} title {} noenhanced", line_style(plot.curves[i]),
                            gnuplot_quoted(key_label(plot.curves[i].label, i + 1)));
    return {text, width, height, stem};
}

}
