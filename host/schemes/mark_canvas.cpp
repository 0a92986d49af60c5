#include "host/schemes/mark_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {

MarkCanvas::MarkCanvas(double width, double height, double pixels_a_unit)
{
    picture_.width = width;
    picture_.height = height;
    picture_.pixels = static_cast<int>(std::lround(width * pixels_a_unit));
}

MarkGroup& MarkCanvas::group(const std::string& color)
{
    if (picture_.groups.empty() || picture_.groups.back().color != color) picture_.groups.push_back({color});
    return picture_.groups.back();
}

void MarkCanvas::polygon(const std::string& color, std::vector<MarkPoint> corners)
{
    group(color).polygons.push_back(std::move(corners));
}

void MarkCanvas::disk(const std::string& color, const MarkPoint& middle, double radius)
{
    group(color).disks.push_back({middle[0], middle[1], radius});
}

void MarkCanvas::line(const std::string& color, const MarkPoint& from, const MarkPoint& to, double width)
{
    group(color).strokes.push_back({from[0], from[1], to[0], to[1], width});
}

void MarkCanvas::dashed_line(const std::string& color, const MarkPoint& from, const MarkPoint& to, double width,
                             double dash)
{
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    const auto place = [&](double along) {
        const double part = std::min(1.0, along / length);
        return MarkPoint{from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])};
    };
    for (double along = 0; along < length; along += 2 * dash) line(color, place(along), place(along + dash), width);
}

void MarkCanvas::outline(const std::string& color, const std::vector<MarkPoint>& corners, double width)
{
    for (std::size_t i = 0; i < corners.size(); ++i) line(color, corners[i], corners[(i + 1) % corners.size()], width);
}

void MarkCanvas::ring(const std::string& color, const MarkPoint& middle, double radius, double width)
{
    constexpr int sides = 48;
    std::vector<MarkPoint> corners;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        corners.push_back({middle[0] + radius * std::cos(angle), middle[1] + radius * std::sin(angle)});
    }
    outline(color, corners, width);
}

void MarkCanvas::words(const MarkPoint& middle, double size, std::string words)
{
    // The place is on the line that letters stand on.
    picture_.words.push_back({{middle[0], middle[1] - 0.35 * size}, size, std::move(words)});
}

void MarkCanvas::dot(const std::string& color, const MarkPoint& middle, double radius)
{
    disk("#000000", middle, radius);
    disk(color, middle, radius * 0.86);
}

}
