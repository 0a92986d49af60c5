// Drawings as SVG: as few paths and as short numbers as show the same picture.
#include "reports/drawings/drawing.hpp"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

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

/// Steps from one rounded point to the next: rounding does not add up.
std::string steps(const std::vector<DrawingPoint>& points, bool backwards = false)
{
    std::string data;
    std::int64_t x = 0, y = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const DrawingPoint& point = points[backwards ? (points.size() - i) % points.size() : i];
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
    return data;
}

/// A disk without a stroke is a line of no length with round ends: the shortest way to write many.
bool is_dot(const Shape& shape) { return std::holds_alternative<Disk>(shape.form) && shape.stroke.empty(); }

/// The shapes that a path draws. All polygons run the same way round, so that a path of several covers what each of
/// them covers.
std::string path_data(const Shape& shape)
{
    if (const auto* corners = std::get_if<Polygon>(&shape.form))
        return corners->empty() ? "" : steps(*corners, twice_area(*corners) < 0) + "z";
    if (const auto* line = std::get_if<Line>(&shape.form)) return steps(line->points);
    const Disk& disk = std::get<Disk>(shape.form);
    const std::int64_t x = hundredths(disk.middle[0]), y = hundredths(disk.middle[1]), r = hundredths(disk.radius);
    if (is_dot(shape)) return "M" + pair(x, y) + "h0";
    const std::string half_way = "a" + pair(r, r) + " 0 1 0";
    return "M" + pair(x - r, y) + half_way + " " + number(2 * r) + " 0" + half_way + number(-2 * r) + " 0z";
}

std::string path_attributes(const Shape& shape)
{
    const bool fills = !shape.fill.empty() && !is_dot(shape) && !std::holds_alternative<Line>(shape.form);
    std::string text = "fill=\"" + (fills ? shape.fill : "none") + "\"";
    text += " stroke=\"" + (shape.stroke.empty() ? shape.fill : shape.stroke) + "\" stroke-width=\"";
    if (is_dot(shape)) return text + number(2 * hundredths(std::get<Disk>(shape.form).radius)) + "\"";
    if (!shape.stroke.empty()) return text + number(hundredths(shape.stroke_width)) + "\"";
    return text + "1\" vector-effect=\"non-scaling-stroke\"";
}

std::string text_element(const Text& text, const std::string& color)
{
    if (text.words.find_first_of("<&") != std::string::npos)
        throw std::logic_error("a drawing with the words '" + text.words + "'");
    return "<text x=\"" + number(hundredths(text.start[0])) + "\" y=\"" + number(hundredths(text.start[1])) +
           "\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"" + number(hundredths(text.size)) + "\"" +
           (text.is_centred ? " text-anchor=\"middle\"" : "") + " fill=\"" + color + "\">" + text.words + "</text>\n";
}

/// The paths and texts of a document, one path for as many shapes as look the same in one.
class SvgWriter
{
public:
    explicit SvgWriter(std::string header) : svg_(std::move(header)) {}

    void add(const Shape& shape)
    {
        if (std::holds_alternative<Image>(shape.form)) throw std::logic_error("an SVG document with an image");
        if (shape.fill.empty() && shape.stroke.empty()) return;
        if (const auto* text = std::get_if<Text>(&shape.form)) {
            close();
            svg_ += text_element(*text, shape.fill);
            return;
        }
        const std::string attributes = path_attributes(shape);
        // With fill and stroke, the fill of the later has to cover the stroke of the earlier.
        if (attributes != open_ || (!shape.fill.empty() && !shape.stroke.empty())) {
            close();
            svg_ += "<path " + attributes + " d=\"";
            open_ = attributes;
        }
        svg_ += path_data(shape);
    }

    std::string finish()
    {
        close();
        return std::move(svg_) + "</svg>\n";
    }

private:
    void close()
    {
        if (!open_.empty()) svg_ += "\"/>\n";
        open_.clear();
    }

    std::string svg_;
    std::string open_; ///< the attributes of the path that is not closed yet
};

/// Attributes of the document; nothing for drawings of any size.
std::string size_on_paper(const Drawing& drawing)
{
    if (drawing.millimetres_a_unit <= 0) return {};
    const auto millimetres = [&](double units) {
        return number(hundredths(units * drawing.millimetres_a_unit)) + "mm";
    };
    return " width=\"" + millimetres(drawing.width) + "\" height=\"" + millimetres(drawing.height) + "\"";
}

}

std::string drawing_svg(const Drawing& drawing)
{
    check_drawing(drawing);
    const std::string width = number(hundredths(drawing.width));
    const std::string height = number(hundredths(drawing.height));
    SvgWriter writer("<svg xmlns=\"http://www.w3.org/2000/svg\"" + size_on_paper(drawing) + " viewBox=\"0 0 " + width +
                     " " + height + "\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n" +
                     (drawing.millimetres_a_unit > 0
                          ? ""
                          : "<rect width=\"" + width + "\" height=\"" + height + "\" fill=\"#ffffff\"/>\n"));
    for (const Shape& shape : drawing.shapes) writer.add(shape);
    return writer.finish();
}

}
