// Drawings as SVG: as few paths and as short numbers as show the same picture.
#include "reports/drawings/drawing.hpp"

#include <cmath>
#include <cstdint>

namespace poissonlab {
namespace {

/// Hundredths of a unit: "12", "-.5", "3.25".
std::string number(std::int64_t hundredths)
{
    std::string text = hundredths < 0 ? "-" : "";
    const std::int64_t size = std::abs(hundredths);
    const std::int64_t fraction = size % 100;
    if (size >= 100 || fraction == 0) text += std::to_string(size / 100);
    if (fraction != 0) {
        text += '.';
        text += static_cast<char>('0' + fraction / 10);
        if (fraction % 10 != 0) text += static_cast<char>('0' + fraction % 10);
    }
    return text;
}

std::int64_t hundredths(double coordinate) { return std::llround(coordinate * 100); }

/// Two numbers; a minus sign separates as well as a blank.
std::string pair(std::int64_t x, std::int64_t y) { return number(x) + (y < 0 ? "" : " ") + number(y); }

double twice_area(const std::vector<DrawingPoint>& outline)
{
    double sum = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& [x0, y0] = outline[i];
        const auto& [x1, y1] = outline[(i + 1) % outline.size()];
        sum += x0 * y1 - x1 * y0;
    }
    return sum;
}

/// All outlines run the same way round, so that a path of several covers what each of them covers. Steps are
/// between rounded points: rounding does not add up.
std::string path_data(const std::vector<DrawingPoint>& outline)
{
    const bool backwards = twice_area(outline) < 0;
    std::string data;
    std::int64_t x = 0, y = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const DrawingPoint& point = outline[backwards ? (outline.size() - i) % outline.size() : i];
        const std::int64_t dx = hundredths(point[0]) - x, dy = hundredths(point[1]) - y;
        if (i == 0)
            data += "M" + pair(dx, dy);
        else if (dx != 0 && dy != 0)
            data += "l" + pair(dx, dy);
        else if (dx != 0)
            data += "h" + number(dx);
        else if (dy != 0)
            data += "v" + number(dy);
        x += dx;
        y += dy;
    }
    return data.empty() ? data : data + "z";
}

std::string path_attributes(const Shape& shape)
{
    const bool stroked = !shape.stroke.empty();
    std::string text = "fill=\"" + (shape.fill.empty() ? "none" : shape.fill) + "\"";
    text += " stroke=\"" + (stroked ? shape.stroke : shape.fill) + "\"";
    if (stroked) return text + " stroke-width=\"" + number(hundredths(shape.stroke_width)) + "\"";
    return text + " stroke-width=\"1\" vector-effect=\"non-scaling-stroke\"";
}

/// With fill and stroke, the fill of the later has to cover the stroke of the earlier.
bool can_share_path(const Shape& a, const Shape& b)
{
    return a.fill == b.fill && a.stroke == b.stroke && a.fill.empty() != a.stroke.empty() &&
           (a.stroke.empty() || a.stroke_width == b.stroke_width);
}

}

std::string drawing_svg(const Drawing& drawing)
{
    check_drawing(drawing);
    const std::string width = number(hundredths(drawing.width));
    const std::string height = number(hundredths(drawing.height));
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + width + " " + height +
                      "\" stroke-linejoin=\"round\">\n<rect width=\"" + width + "\" height=\"" + height +
                      "\" fill=\"#ffffff\"/>\n";
    const Shape* open = nullptr;
    for (const Shape& shape : drawing.shapes) {
        if (shape.fill.empty() && shape.stroke.empty()) continue;
        if (open == nullptr || !can_share_path(*open, shape)) {
            if (open != nullptr) svg += "\"/>\n";
            svg += "<path " + path_attributes(shape) + " d=\"";
            open = &shape;
        }
        svg += path_data(shape.outline);
    }
    if (open != nullptr) svg += "\"/>\n";
    return svg + "</svg>\n";
}

}
