// A plot as a value. gnuplot's text, the thumbnails of tables and the data of the compare page are all made from it.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// A line of a plot. y, and the other lists that are not empty, have a value for each x; NaN is a gap.
struct PlotCurve
{
    std::size_t index = 0; ///< number of the series, for its colour and dashes
    std::string label = {};
    std::vector<double> x = {};
    std::vector<double> y = {};
    std::vector<double> low = {},
                        high = {}; ///< one standard error or the range around y: a band, drawn where a curve is alone
    std::vector<double> dots = {}; ///< values that are drawn as dots beside the line
    bool has_bars = false;         ///< low and high are bars, in every plot
    double end = 0;                ///< where an axis that shows this curve ends
    std::string color = {};        ///< "#rrggbb", of what is no series; empty: that of its number
};

struct PlotAxis
{
    std::string label = {};
    double low = 0;
    double high = 1;
    double step = 0; ///< between ticks, a factor on a logarithmic axis; 0: gnuplot chooses
    bool logarithmic = false;
    std::vector<std::pair<double, std::string>> ticks = {}; ///< the only ones, where there are some
    double most =
        std::numeric_limits<double>::infinity(); ///< `high` is this at most, so that peaks flatten nothing else
    double floor = 0;                            ///< where a logarithmic axis of the compare page may begin
};

/// A second horizontal axis along the top, from 0 on.
struct TopAxis
{
    std::string label;
    double high = 1;
};

/// A dashed line across the plot; `text` stands at its right end, `text_shift` lines above it.
struct ReferenceLine
{
    double height = 0;
    std::string text = {};
    double text_shift = 0;
};

/// A dotted upright line, behind the curves, with its name left or right of it.
struct UprightMark
{
    double x = 0;
    std::string name;
    bool name_on_the_left = false;
    double name_height = 0.97; ///< from 0 (bottom) to 1
};

/// A dashed line, straight as the axes are, from one place to another on its right; its name is at its right end or at
/// its left one.
struct SlopeMark
{
    double left = 0, left_height = 0;
    double right = 0, right_height = 0;
    std::string name;
    bool name_on_the_left = false;
};

struct Plot
{
    std::string key = {}; ///< what the compare page calls the quantity; empty: not on that page
    PlotAxis x = {}, y = {};
    std::optional<TopAxis> top = {};
    std::vector<ReferenceLine> references = {};
    std::vector<UprightMark> marks = {};
    std::vector<SlopeMark> slopes = {};
    std::vector<PlotCurve> curves = {};
    double left_margin = 7, right_margin = 2; ///< in characters

    /// Plots of several curves have a key below; the page shows a legend instead and cuts the key off.
    bool is_overlay = false;
    bool has_key = false; ///< of a plot that is no overlay: below it, for few short names
};

/// Width and height in pixels: of the plot of a series, and of an overlay without its key.
inline constexpr int panel_width = 320;
inline constexpr int panel_height = 340;
inline constexpr int overlay_width = 540;
inline constexpr int overlay_height = 328;

/// True if the plot has a curve of the series with that number.
bool has_curve(const Plot& plot, std::size_t index);

/// The plot of the curve of series `index` alone, with axes that suit all curves of the plot: so plots of series
/// compare.
Plot alone(const Plot& all, std::size_t index);

/// The plot of all curves together, over all that they reach.
Plot together(Plot all);

/// The largest finite y of all curves, at least `least`.
double highest(const std::vector<PlotCurve>& curves, double least);

/// A colour of curves on white and on dark pages, as "#rrggbb".
struct CurveColor
{
    const char* light;
    const char* dark;
};

/// The colours in their order; the first of few are told apart by everyone.
const std::vector<CurveColor>& palette();

/// Dash patterns as SVG has them; colours repeat, then with the next pattern.
const std::vector<std::string>& dash_patterns();

/// The colour and the dashes of the series with that number.
std::string curve_color(std::size_t index);
const std::string& curve_dashes(std::size_t index);

/// Style rules that define --curve-0, --curve-1, ... for white pages, dark pages and paper.
std::string palette_css();

/// A label of an axis or a mark, which may have gnuplot's subscripts, as plain text: "1/d_{min}" is "1/d_min".
std::string plain_words(const std::string& label);

}
