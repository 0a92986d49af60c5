#include "host/distribution/charts/curve_marks.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

// These lengths are in units of the picture.
constexpr double chart_width = 800, chart_height = 525, left_edge = 80, right_edge = 640, bottom_edge = 70,
                 top_edge = 480, font_size = 15;

class CurveChart
{
public:
    CurveChart(const CurveAxis& x, const CurveAxis& y) : x_(x), y_(y) {}

    std::array<double, 2> at(double x, double y) const
    {
        return {left_edge + (right_edge - left_edge) * (x - x_.low) / (x_.high - x_.low),
                bottom_edge + (top_edge - bottom_edge) * (y - y_.low) / (y_.high - y_.low)};
    }

    bool contains(const std::array<double, 2>& place) const
    {
        return place[0] >= x_.low && place[0] <= x_.high && place[1] >= y_.low && place[1] <= y_.high;
    }

    static void add_line(MarkGroup& to, const std::array<double, 2>& a, const std::array<double, 2>& b, double width)
    {
        to.strokes.push_back({a[0], a[1], b[0], b[1], width});
    }

    void add_frame(MarkPicture& picture, double level) const
    {
        MarkGroup thin{"#c9cdd3"}, frame{"#6b7280"};
        add_line(thin, at(x_.low, level), at(x_.high, level), 1.5);
        for (double x = std::ceil(x_.low / x_.step) * x_.step; x <= x_.high * (1 + 1e-9); x += x_.step) {
            add_line(thin, at(x, y_.low), at(x, y_.high), 0.7);
            const auto [left, low] = at(x, y_.low);
            picture.words.push_back({{left, low - 18}, font_size, fmt::format("{:.4g}", x)});
        }
        for (double y = std::ceil(y_.low / y_.step) * y_.step; y <= y_.high * (1 + 1e-9); y += y_.step) {
            add_line(thin, at(x_.low, y), at(x_.high, y), 0.7);
            const auto [left, low] = at(x_.low, y);
            picture.words.push_back({{left - 26, low}, font_size, fmt::format("{:.4g}", std::abs(y) < 1e-12 ? 0 : y)});
        }
        add_line(frame, at(x_.low, y_.low), at(x_.high, y_.low), 1.5);
        add_line(frame, at(x_.low, y_.low), at(x_.low, y_.high), 1.5);
        picture.groups.push_back(std::move(thin));
        picture.groups.push_back(std::move(frame));
        picture.words.push_back({{(left_edge + right_edge) / 2, 22}, font_size, x_.name});
        picture.words.push_back({{(left_edge + right_edge) / 2, chart_height - 20}, font_size, y_.name});
    }

private:
    CurveAxis x_, y_;
};

}

MarkPicture curve_marks(const CurveAxis& x, const CurveAxis& y, double level, const std::vector<MarkCurve>& curves)
{
    const CurveChart chart(x, y);
    MarkPicture picture{chart_width, chart_height};
    picture.pixels = static_cast<int>(chart_width);
    chart.add_frame(picture, level);
    double name_height = top_edge;
    for (const MarkCurve& curve : curves) {
        MarkGroup line{curve.color};
        for (std::size_t i = 0; i + 1 < curve.places.size(); ++i) {
            const auto &from = curve.places[i], &to = curve.places[i + 1];
            if (chart.contains(from) && chart.contains(to))
                CurveChart::add_line(line, chart.at(from[0], from[1]), chart.at(to[0], to[1]), 2);
        }
        CurveChart::add_line(line, {right_edge + 12, name_height}, {right_edge + 36, name_height}, 3);
        picture.groups.push_back(std::move(line));
        picture.words.push_back({{right_edge + 92, name_height}, font_size, curve.name});
        name_height -= 1.5 * font_size;
    }
    return picture;
}

std::string class_color(std::size_t index)
{
    static constexpr std::array colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                       "#e69f00", "#56b4e9", "#a89b00", "#4d4d4d"};
    return colors[index % colors.size()];
}

}
