// The looks that the plots of a report share: colours, axes, keys and sizes.
#pragma once

#include "reports/plots/gnuplot.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Width and height of a series' own plot.
inline constexpr int panel_width = 320;
inline constexpr int panel_height = 340;

/// The colour of lines and words that mark something in a plot.
inline constexpr auto mark_color = "#33373d";

/// The colour of the series with that number, as "#rrggbb"; the first of few are told apart by everyone.
std::string curve_color(std::size_t index);

/// Width, colour and dash pattern of that series' lines: colours repeat, then with another dash pattern.
std::string line_style(std::size_t index);

/// The vertical axis of a plot.
struct ValueAxis
{
    std::string label;
    double low = 0;
    double high = 1;
    double step = 1;
    double label_offset = 0; ///< how far the label moves towards the axis, in characters; minus signs need room
};

/// The commands for both axes, without a key.
std::string axes(const std::string& label, double low, double high, const ValueAxis& value);

/// A dashed line across the plot, in front of the curves: a curve that lies on it must be seen to.
std::string reference_line(double height);

/// A dotted upright line at x, behind the curves, with its name at the top, left or right of it.
std::string upright_mark(double x, const std::string& name, bool name_on_the_left);

/// A second horizontal axis along the top from 0 to `high`, with its label.
std::string top_axis(const std::string& label, double high);

/// A series in a plot of several.
struct KeyEntry
{
    std::size_t index = 0; ///< number of the series
    std::string text;
};

/// The picture of a plot with a key below it, a line an entry or two where it is long. `commands` hold all
/// but the key; `plot` is the plot command for the curves, without titles.
GnuplotPicture with_key(const std::string& commands, const std::string& plot, const std::vector<KeyEntry>& key,
                        const std::filesystem::path& stem);

}
