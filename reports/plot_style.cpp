#include "reports/plot_style.hpp"

#include <fmt/format.h>

#include <array>

namespace poissonlab {

namespace {

constexpr int overlay_width = 540;
constexpr int overlay_plot_height = 328;
constexpr int key_line_height = 19;
constexpr std::size_t longest_key_text = 64; // without the number of points

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
    return fmt::format("lw 1.3 lc rgb '{}' dt {}", curve_color(index),
                       dashes[index / palette.size() % dashes.size()]);
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
                       frame_color, grid_color, low, high, value.low, value.high, value.step, label,
                       value.label, value.label_offset);
}

std::string reference_line(double height)
{
    return fmt::format("set arrow from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead front "
                       "lw 0.8 dt (6,4) lc rgb '{1}'\n",
                       height, mark_color);
}

std::string key_text(const std::string& label)
{
    if (label.size() <= longest_key_text) return label;
    // Cut between characters, not inside one.
    auto end = longest_key_text;
    while (end > 0 && (static_cast<unsigned char>(label[end]) & 0xc0U) == 0x80U) --end;
    return label.substr(0, end) + "…";
}

GnuplotPicture with_key(const std::string& commands, const std::string& plot,
                        const std::vector<KeyEntry>& key, const std::filesystem::path& stem)
{
    std::string text =
        commands + "set key below left Left reverse maxcols 1 samplen 2.5 spacing 1.15 height 0.8\n" + plot;
    for (const auto& entry : key)
        text += fmt::format(", keyentry with lines {} title {} noenhanced", line_style(entry.index),
                            gnuplot_quoted(entry.text));
    const int height = overlay_plot_height + key_line_height * static_cast<int>(key.size());
    return {text, overlay_width, height, stem};
}

}
