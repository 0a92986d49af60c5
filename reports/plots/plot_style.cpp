#include "reports/plots/plot_style.hpp"

#include "reports/plots/key_layout.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace poissonlab {

namespace {

constexpr int overlay_width = 540;
constexpr int overlay_plot_height = 328;
constexpr int key_line_height = 19;

// Letters are larger in the PNG: 12 points are 16 pixels of the SVG, and a little more where the width of
// each letter is rounded to whole pixels. Keys begin where the axis does.
constexpr double gnuplot_font_size = 12;
constexpr KeyRoom key_room{16.5, overlay_width - 102.0, 44};

// After Okabe and Ito, whose colours people with colour deficiencies tell apart.
constexpr std::array<const char*, 7> palette = {"#0072b2", "#d55e00", "#009e73", "#c4569a",
                                                "#b88600", "#3aa0dc", "#555555"};
constexpr auto frame_color = "#555a61";
constexpr auto grid_color = "#e3e5e8";

}

std::string curve_color(std::size_t index) { return palette[index % palette.size()]; }

std::string line_style(std::size_t index)
{
    constexpr std::array<const char*, 4> dashes = {"1", "(8,4)", "(2,3)", "(10,3,2,3)"};
    return fmt::format("lw 1.3 lc rgb '{}' dt {}", curve_color(index), dashes[index / palette.size() % dashes.size()]);
}

std::string axes(const std::string& label, double low, double high, const ValueAxis& value)
{
    return fmt::format("set border 3 lw 0.8 lc rgb '{}'\n"
                       "set tics nomirror out scale 0.6\n"
                       "set minussign\n"
                       "set grid ytics lw 0.6 lt 1 lc rgb '{}'\n"
                       "set xrange [{:g}:{:g}]\nset yrange [{:g}:{:g}]\nset ytics {:g}\n"
                       "set xlabel '{}' offset 0,0.4\n"
                       "set ylabel '{}' offset {:g},0\n"
                       "set lmargin 7\nset rmargin 2\nset tmargin 0.7\nunset key\n",
                       frame_color, grid_color, low, high, value.low, value.high, value.step, label, value.label,
                       value.label_offset);
}

std::string reference_line(double height)
{
    return fmt::format("set arrow from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead front "
                       "lw 0.8 dt (6,4) lc rgb '{1}'\n",
                       height, mark_color);
}

std::string upright_mark(double x, const std::string& name, bool name_on_the_left)
{
    return fmt::format("set arrow from first {0:.6g}, graph 0 to first {0:.6g}, graph 1 nohead back lw 1 dt (2,3) "
                       "lc rgb '{1}'\n"
                       "set label '{2}' at first {0:.6g}, graph 0.97 {3} textcolor rgb '{1}'\n",
                       x, mark_color, name, name_on_the_left ? "right offset -0.5,0" : "left offset 0.5,0");
}

std::string top_axis(const std::string& label, double high)
{
    const double step = high > 30 ? 10 : high > 12 ? 5 : high > 5 ? 2 : high > 2.5 ? 1 : 0.5;
    return fmt::format("set border 7\nset x2range [0:{:.10g}]\nset x2tics {:g} out scale 0.6\n"
                       "set x2label '{}' offset 0,-0.5\nset tmargin 3\n",
                       high, step, label);
}

GnuplotPicture with_key(const std::string& commands, const std::string& plot, const std::vector<KeyEntry>& key,
                        const std::filesystem::path& stem)
{
    std::vector<std::string> labels;
    for (const auto& entry : key) labels.push_back(entry.text);
    const auto layout = lay_out_key(labels, key_room);

    std::string text = commands +
                       fmt::format("set key below left Left reverse maxcols 1 samplen 2.5 spacing 1.15 "
                                   "height 0.8 font ',{:.2f}'\n",
                                   layout.scale * gnuplot_font_size) +
                       plot;
    std::size_t count = 0;
    for (std::size_t i = 0; i < key.size(); ++i) {
        auto style = line_style(key[i].index);
        for (const auto& line : layout.lines[i]) {
            text += fmt::format(", keyentry with lines {} title {} noenhanced", style, gnuplot_quoted(line));
            style = "lt nodraw"; // for the second line
            ++count;
        }
    }
    const double key_height = layout.scale * key_line_height * static_cast<double>(count);
    return {text, overlay_width, overlay_plot_height + static_cast<int>(std::ceil(key_height)), stem};
}

}
