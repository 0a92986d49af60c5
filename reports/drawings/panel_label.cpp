#include "reports/drawings/panel_label.hpp"

#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

const std::string label_color = "#202020";
constexpr double stroke_width = 1.4;
constexpr int arc_steps = 14;

/// In units of the height of a small letter: x to the right, y upwards from the line, 0 in the letter's
/// middle.
using Line = std::vector<DrawingPoint>;

/// Part of an ellipse; angles in degrees, counterclockwise from the right.
Line arc(DrawingPoint middle, double wide, double high, double from, double to)
{
    Line line;
    for (int i = 0; i <= arc_steps; ++i) {
        const double angle = (from + (to - from) * i / arc_steps) * std::numbers::pi / 180;
        line.push_back({middle[0] + wide * std::cos(angle), middle[1] + high * std::sin(angle)});
    }
    return line;
}

std::vector<Line> letter(std::size_t number)
{
    const Line bowl = arc({0, 0.5}, 0.42, 0.5, 0, 360);
    switch (number) {
    case 0:
        return {bowl, {{0.42, 1}, {0.42, 0}}};
    case 1:
        return {bowl, {{-0.42, 1.5}, {-0.42, 0}}};
    case 2:
        return {arc({0, 0.5}, 0.42, 0.5, 50, 310)};
    case 3:
        return {bowl, {{0.42, 1.5}, {0.42, 0}}};
    case 4:
        return {{{-0.42, 0.5}, {0.42, 0.5}}, arc({0, 0.5}, 0.42, 0.5, 0, 310)};
    default:
        return {arc({0.3, 1.15}, 0.3, 0.35, 60, 180), {{0, 1.15}, {0, 0}}, {{-0.28, 0.95}, {0.32, 0.95}}};
    }
}

}

void add_panel_label(std::vector<Shape>& shapes, std::size_t panel, const DrawingPoint& middle)
{
    if (panel >= most_panel_letters) return;
    std::vector<Line> lines = letter(panel);
    lines.push_back(arc({-0.55, 0.6}, 0.5, 1.05, 125, 235));
    lines.push_back(arc({0.55, 0.6}, 0.5, 1.05, -55, 55));
    const double unit = panel_label_height / 2;
    const auto place = [&](const DrawingPoint& p) {
        return DrawingPoint{middle[0] + p[0] * unit, middle[1] - (p[1] - 0.6) * unit};
    };
    for (const Line& line : lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            shapes.push_back({{place(line[i]), place(line[i + 1])}, {}, label_color, stroke_width});
}

}
