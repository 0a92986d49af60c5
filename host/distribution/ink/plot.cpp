#include "host/distribution/ink/plot.hpp"

#include "base/files/text_lines.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/programs/interrupt.hpp"
#include "base/text/noun.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace poissonlab {
namespace {

using Stroke = std::array<double, 5>;
using PlotPlace = boost::geometry::model::d2::point_xy<double>;
using PlotEnd = std::pair<PlotPlace, std::size_t>; ///< of mark i / 2; odd: its second end
using EndTree = boost::geometry::index::rtree<PlotEnd, boost::geometry::index::quadratic<16>>;

constexpr double stroke_of_a_dot = 0.01; ///< the length, in units
constexpr double least_radius = 0.005;   ///< of circles: what has none is not drawn

double way_between(const Stroke& from, const Stroke& to) { return std::hypot(to[0] - from[2], to[1] - from[3]); }

double way_of(const std::vector<Stroke>& marks)
{
    double way = 0;
    for (std::size_t i = 0; i + 1 < marks.size(); ++i) way += way_between(marks[i], marks[i + 1]);
    return way;
}

bool is_dot(const Stroke& mark) { return mark[0] == mark[2] && mark[1] == mark[3]; }

Stroke turned(const Stroke& mark) { return {mark[2], mark[3], mark[0], mark[1], mark[4]}; }

PlotEnd end_of(const Stroke& mark, std::size_t number)
{
    const bool is_second = number % 2 == 1;
    return {PlotPlace(mark[is_second ? 2 : 0], mark[is_second ? 3 : 1]), number};
}

EndTree ends_of(const std::vector<Stroke>& marks)
{
    std::vector<PlotEnd> ends;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        ends.push_back(end_of(marks[i], 2 * i));
        if (!is_dot(marks[i])) ends.push_back(end_of(marks[i], 2 * i + 1));
    }
    return EndTree(ends);
}

/// Marks in the order of the nearest end that is left, turned round where that is the second one.
std::vector<Stroke> nearest_first(const std::vector<Stroke>& marks)
{
    EndTree left = ends_of(marks);
    std::vector<Stroke> order;
    PlotPlace pen(0, 0);
    while (!left.empty()) {
        if (order.size() % 4096 == 0) stop_if_interrupted();
        const std::size_t number = left.qbegin(boost::geometry::index::nearest(pen, 1))->second;
        const Stroke& mark = marks[number / 2];
        left.remove(end_of(mark, number));
        if (!is_dot(mark)) left.remove(end_of(mark, number ^ 1));
        order.push_back(number % 2 == 0 ? mark : turned(mark));
        pen = PlotPlace(order.back()[2], order.back()[3]);
    }
    return order;
}

/// A stroke whose round ends reach as far with another pen.
Stroke with_pen(Stroke mark, double pen)
{
    const double length = std::hypot(mark[2] - mark[0], mark[3] - mark[1]);
    if (length > 0) {
        const double more = std::max((mark[4] - pen) / 2, -length / 2) / length;
        const double dx = (mark[2] - mark[0]) * more, dy = (mark[3] - mark[1]) * more;
        mark = {mark[0] - dx, mark[1] - dy, mark[2] + dx, mark[3] + dy, pen};
    }
    return mark;
}

/// All marks on the sheet as strokes; those of dots have no length.
std::vector<Stroke> strokes_on(const MarkGroup& marks, double height, double margin, double scale)
{
    std::vector<Stroke> strokes;
    const auto across = [&](double x) { return (margin + x) * scale; };
    const auto down = [&](double y) { return (margin + height - y) * scale; };
    for (const auto& [x, y, radius] : marks.disks)
        strokes.push_back({across(x), down(y), across(x), down(y), 2 * radius * scale});
    for (const auto& [x0, y0, x1, y1, wide] : marks.strokes)
        strokes.push_back({across(x0), down(y0), across(x1), down(y1), wide * scale});
    return strokes;
}

/// A thousandth of a unit is a micrometre.
double rounded(double value) { return std::round(value * 1000) / 1000 + 0.0; }

double circle_radius(const Plot& plot, double dot)
{
    const double radius = plot.sheet.pen > 0 ? (dot - plot.sheet.pen) / 2 : dot / 2;
    return std::max(radius, least_radius);
}

void append_line(std::string& svg, const Stroke& stroke)
{
    fmt::format_to(std::back_inserter(svg), "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", rounded(stroke[0]),
                   rounded(stroke[1]), rounded(stroke[2]), rounded(stroke[3]));
}

/// Begins the group of all marks, which are outlines by a pen, or as wide as they are.
std::string group_begin(const Plot& plot, double mark_width)
{
    const bool are_lines = !plot.marks.strokes.empty() || plot.sheet.dots == DotForm::strokes;
    if (!are_lines && plot.sheet.pen == 0) return "<g fill=\"#000000\" stroke=\"none\">\n";
    return fmt::format("<g fill=\"none\" stroke=\"#000000\" stroke-width=\"{}\" stroke-linecap=\"round\">\n",
                       rounded(plot.sheet.pen > 0 ? plot.sheet.pen : mark_width));
}

/// Says which pen draws the dots. Short strokes are as wide as the pen, whatever the diameter of the dots.
std::string pen_words(const Plot& plot)
{
    const double wide = 2 * plot.marks.disks.front()[2], pen = plot.sheet.pen;
    if (plot.sheet.dots == DotForm::circles) return ", which a pen of up to that width draws";
    if (!(pen > 0)) return ", as wide as the pen has to be";
    if (pen > 0.95 * wide) return "";
    const double times = wide * wide / (pen * pen);
    return fmt::format(", but strokes of the pen are {:.3g} mm wide and draw {:.2g} % of the ink: circles draw more of "
                       "it, and with {:.0f} dots each dot would be as wide as the pen",
                       pen, 100 / times, static_cast<double>(plot.marks.disks.size()) * times);
}

}

std::optional<double> millimetres_of(std::string_view text)
{
    constexpr double millimetres_an_inch = 25.4;
    const std::size_t end = text.find_last_of("0123456789.");
    double number = 0;
    if (end == std::string_view::npos || !parse_number(text.substr(0, end + 1), number)) return {};
    const std::string_view unit = trimmed(text.substr(end + 1));
    const double scale = unit == "mm" ? 1 : unit == "cm" ? 10 : unit == "in" ? millimetres_an_inch : 0;
    if (!(number > 0) || scale == 0 || !std::isfinite(number * scale)) return {};
    return number * scale;
}

Plot plot_of(const MarkGroup& marks, double width, double height, double margin, const PlotSheet& sheet)
{
    const double scale = sheet.width > 0 ? sheet.width / width : 1;
    Plot plot{(width + 2 * margin) * scale, (height + 2 * margin) * scale, sheet, {}};
    std::vector<Stroke> strokes = strokes_on(marks, height, margin, scale);
    plot.way_as_made = way_of(strokes);
    if (sheet.travel == PenTravel::nearest) strokes = nearest_first(strokes);
    plot.way = way_of(strokes);
    for (const Stroke& stroke : strokes) {
        if (sheet.pen > stroke[4] * (1 + 1e-9)) ++plot.narrow;
        if (!is_dot(stroke)) {
            plot.marks.strokes.push_back(sheet.pen > 0 ? with_pen(stroke, sheet.pen) : stroke);
            continue;
        }
        plot.marks.disks.push_back({stroke[0], stroke[1], stroke[4] / 2});
        if (sheet.pen > 0) plot.widest_hole = std::max(plot.widest_hole, stroke[4] - 2 * sheet.pen);
    }
    return plot;
}

std::string plot_words(const Plot& plot)
{
    const std::string unit = plot.sheet.width > 0 ? "mm" : "pixels";
    const bool is_on_paper = plot.sheet.width > 0;
    const auto way_text = [&](double way) {
        return is_on_paper && way >= 1000 ? fmt::format("{:.1f} m", way / 1000) : fmt::format("{:.4g} {}", way, unit);
    };
    std::string words =
        fmt::format("the sheet is {:.4g} x {:.4g} {}{}; the pen's way between marks is {}", plot.width, plot.height,
                    unit, is_on_paper ? ", wider than --width for dots at the edges" : "", way_text(plot.way));
    if (plot.sheet.travel == PenTravel::nearest) words += fmt::format(" ({} as made)", way_text(plot.way_as_made));
    if (is_on_paper && !plot.marks.disks.empty())
        words += fmt::format("; dots are {:.3g} mm in diameter{}", 2 * plot.marks.disks.front()[2], pen_words(plot));
    if (plot.widest_hole > 0 && plot.sheet.dots == DotForm::circles)
        words += fmt::format("; circles leave holes of {:.2g} mm in dots: a wider pen or more dots fill them",
                             plot.widest_hole);
    if (plot.narrow > 0)
        words += fmt::format("; the pen is wider than {} {}, which become too dark: use a thinner pen or fewer dots",
                             plot.narrow, noun(plot.narrow, "mark"));
    return words;
}

std::string plot_svg(const Plot& plot)
{
    const std::string size =
        plot.sheet.width > 0 ? fmt::format(" width=\"{}mm\" height=\"{}mm\"", rounded(plot.width), rounded(plot.height))
                             : "";
    const double mark_width = plot.marks.disks.empty() ? plot.marks.strokes.empty() ? 1 : plot.marks.strokes.front()[4]
                                                       : 2 * plot.marks.disks.front()[2];
    std::string svg = fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\"{} viewBox=\"0 0 {} {}\">\n{}", size,
                                  rounded(plot.width), rounded(plot.height), group_begin(plot, mark_width));
    for (const auto& [x, y, radius] : plot.marks.disks)
        if (plot.sheet.dots == DotForm::strokes)
            append_line(svg, {x - stroke_of_a_dot / 2, y, x + stroke_of_a_dot / 2, y, 0});
        else
            fmt::format_to(std::back_inserter(svg), "<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", rounded(x), rounded(y),
                           rounded(circle_radius(plot, 2 * radius)));
    for (const Stroke& stroke : plot.marks.strokes) append_line(svg, stroke);
    return svg + "</g>\n</svg>\n";
}

std::string plot_dxf(const Plot& plot, const std::string& comment)
{
    std::string dxf = dxf_begin(comment);
    const auto up = [&](double y) { return rounded(plot.height - y); };
    for (const auto& [x, y, radius] : plot.marks.disks)
        fmt::format_to(std::back_inserter(dxf), "0\nCIRCLE\n8\n0\n10\n{}\n20\n{}\n30\n0\n40\n{}\n", rounded(x), up(y),
                       rounded(circle_radius(plot, 2 * radius)));
    for (const auto& [x0, y0, x1, y1, wide] : plot.marks.strokes)
        fmt::format_to(std::back_inserter(dxf), "0\nLINE\n8\n0\n10\n{}\n20\n{}\n30\n0\n11\n{}\n21\n{}\n31\n0\n",
                       rounded(x0), up(y0), rounded(x1), up(y1));
    return dxf.append(dxf_end);
}

}
