// Elements and attributes of SVG 1.1: https://www.w3.org/TR/SVG11/shapes.html and coords.html.
#include "base/errors/errors.hpp"
#include "base/files/text_lines.hpp"
#include "base/regions/svg/path_lines.hpp"
#include "base/regions/svg/svg_drawing.hpp"

#include <2geom/svg-path-parser.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr std::string_view svg_separators = " \t\r\n,";

void skip(std::string_view& text, std::string_view characters)
{
    text.remove_prefix(std::min(text.size(), text.find_first_not_of(characters)));
}

InputError attribute_error(const std::string& key, const std::string& value, const char* allowed)
{
    return InputError(fmt::format("{} \"{}\": {}", key, shortened(printable(value)), allowed));
}

/// The length that an attribute says, or `otherwise`.
double length_of(const SvgAttributes& attributes, const std::string& key, double otherwise = 0)
{
    const auto found = attributes.find(key);
    if (found == attributes.end() || (found->second == "auto" && key.starts_with('r'))) return otherwise;
    const auto length = svg_length(found->second);
    if (!length) throw attribute_error(key, found->second, "must be a length, in px, mm, cm, in, pt, pc or no unit");
    return *length;
}

/// Draws lines from corner to corner and, where `is_closed`, back to the first one.
Geom::PathVector polygon_of(const SvgAttributes& attributes, bool is_closed)
{
    const std::size_t least = is_closed ? 3 : 2;
    const auto found = attributes.find("points");
    const std::string text = found == attributes.end() ? "" : found->second;
    const auto numbers = svg_numbers(text);
    if (!numbers || numbers->size() < 2 * least || numbers->size() % 2 != 0)
        throw attribute_error("points", text,
                              is_closed ? "must be pairs of numbers, three at least"
                                        : "must be pairs of numbers, two at least");
    Geom::PathBuilder path;
    path.moveTo({(*numbers)[0], (*numbers)[1]});
    for (std::size_t i = 2; i < numbers->size(); i += 2) path.lineTo({(*numbers)[i], (*numbers)[i + 1]});
    if (is_closed) path.closePath();
    path.flush();
    return path.peek();
}

Geom::PathVector line_of(const SvgAttributes& attributes)
{
    Geom::PathBuilder path;
    path.moveTo({length_of(attributes, "x1"), length_of(attributes, "y1")});
    path.lineTo({length_of(attributes, "x2"), length_of(attributes, "y2")});
    path.flush();
    return path.peek();
}

Geom::PathVector ellipse_of(const SvgAttributes& attributes, double rx, double ry)
{
    if (!(rx > 0 && ry > 0)) throw InputError("its radius must be above 0");
    const double x = length_of(attributes, "cx"), y = length_of(attributes, "cy");
    Geom::PathBuilder path;
    path.moveTo({x + rx, y});
    path.arcTo(rx, ry, 0, false, true, {x - rx, y});
    path.arcTo(rx, ry, 0, false, true, {x + rx, y});
    path.closePath();
    path.flush();
    return path.peek();
}

/// If only one radius is given, the other one is as large.
Geom::PathVector rectangle_of_svg(const SvgAttributes& attributes)
{
    const double x = length_of(attributes, "x"), y = length_of(attributes, "y");
    const double width = length_of(attributes, "width"), height = length_of(attributes, "height");
    if (!(width > 0 && height > 0)) throw InputError("its width and height must be above 0");
    const double said_x = length_of(attributes, "rx", -1), said_y = length_of(attributes, "ry", -1);
    const double rx = std::clamp(said_x < 0 ? said_y : said_x, 0.0, width / 2);
    const double ry = std::clamp(said_y < 0 ? said_x : said_y, 0.0, height / 2);
    const bool is_round = rx > 0 && ry > 0;
    const double a = is_round ? rx : 0, b = is_round ? ry : 0;
    Geom::PathBuilder path;
    const auto corner = [&](const Geom::Point& from, const Geom::Point& to) {
        path.lineTo(from);
        if (is_round) path.arcTo(rx, ry, 0, false, true, to);
    };
    path.moveTo({x + a, y});
    corner({x + width - a, y}, {x + width, y + b});
    corner({x + width, y + height - b}, {x + width - a, y + height});
    corner({x + a, y + height}, {x, y + height - b});
    corner({x, y + b}, {x + a, y});
    path.closePath();
    path.flush();
    return path.peek();
}

Geom::PathVector path_of(const SvgAttributes& attributes)
{
    const auto found = attributes.find("d");
    if (found == attributes.end()) throw InputError("has no d");
    try {
        return Geom::parse_svg_path(found->second.c_str());
    } catch (const std::exception& error) {
        throw InputError(fmt::format("d: is not a path of SVG: {}", printable(error.what())));
    }
}

SvgShape shape_of_path(const std::string& data, const std::string& name)
{
    PathLines path;
    try {
        Geom::parse_svg_path(data.c_str(), path);
    } catch (const std::exception& error) {
        throw InputError(fmt::format("{}: is not a path of SVG: {}", name, printable(error.what())));
    }
    return shape_of(std::move(path), name, false);
}

std::optional<Geom::Affine> step_of(std::string_view word, const std::vector<double>& n)
{
    const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
    const std::size_t count = n.size();
    if (word == "matrix" && count == 6) return Geom::Affine(n[0], n[1], n[2], n[3], n[4], n[5]);
    if (word == "translate" && (count == 1 || count == 2)) return Geom::Affine(1, 0, 0, 1, n[0], count == 2 ? n[1] : 0);
    if (word == "scale" && (count == 1 || count == 2)) return Geom::Affine(n[0], 0, 0, n[count - 1], 0, 0);
    if (word == "skewX" && count == 1) return Geom::Affine(1, 0, std::tan(radians(n[0])), 1, 0, 0);
    if (word == "skewY" && count == 1) return Geom::Affine(1, std::tan(radians(n[0])), 0, 1, 0, 0);
    if (word != "rotate" || (count != 1 && count != 3)) return {};
    const double cosine = std::cos(radians(n[0])), sine = std::sin(radians(n[0]));
    const double x = count == 3 ? n[1] : 0, y = count == 3 ? n[2] : 0;
    return Geom::Affine(cosine, sine, -sine, cosine, x - cosine * x + sine * y, y - sine * x - cosine * y);
}

}

std::optional<std::vector<double>> svg_numbers(std::string_view text)
{
    std::vector<double> numbers;
    for (skip(text, svg_separators); !text.empty(); skip(text, svg_separators)) {
        if (text.starts_with('+')) text.remove_prefix(1);
        double number = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (error != std::errc() || !std::isfinite(number)) return {};
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        numbers.push_back(number);
    }
    return numbers;
}

std::optional<double> svg_length(std::string_view text)
{
    constexpr double units_an_inch = 96;
    text = trimmed(text);
    const std::size_t end = text.find_last_of("0123456789.");
    if (end == std::string_view::npos) return {};
    const auto numbers = svg_numbers(text.substr(0, end + 1));
    if (!numbers || numbers->size() != 1) return {};
    const std::string_view unit = text.substr(end + 1);
    if (unit.empty() || unit == "px") return numbers->front();
    const double inches = unit == "in"   ? 1
                          : unit == "mm" ? 1 / 25.4
                          : unit == "cm" ? 1 / 2.54
                          : unit == "pt" ? 1.0 / 72
                          : unit == "pc" ? 1.0 / 6
                                         : 0;
    if (inches == 0) return {};
    return numbers->front() * inches * units_an_inch;
}

std::optional<Geom::Affine> svg_transform(std::string_view text)
{
    Geom::Affine all;
    for (skip(text, svg_separators); !text.empty(); skip(text, svg_separators)) {
        const std::size_t open = text.find('('), close = text.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
        const std::string_view word = trimmed(text.substr(0, open));
        const auto numbers = svg_numbers(text.substr(open + 1, close - open - 1));
        const auto step = numbers ? step_of(word, *numbers) : std::nullopt;
        if (!step) return {};
        all = *step * all; // the last one of the list is nearest to the shape
        text.remove_prefix(close + 1);
    }
    return all;
}

std::optional<Geom::PathVector> svg_outline(const std::string& element, const SvgAttributes& attributes)
{
    if (element == "path") return path_of(attributes);
    if (element == "polygon" || element == "polyline") return polygon_of(attributes, element == "polygon");
    if (element == "line") return line_of(attributes);
    if (element == "rect") return rectangle_of_svg(attributes);
    if (element == "circle") {
        const double radius = length_of(attributes, "r");
        return ellipse_of(attributes, radius, radius);
    }
    if (element == "ellipse") return ellipse_of(attributes, length_of(attributes, "rx"), length_of(attributes, "ry"));
    return {};
}

}

extern "C" __attribute__((visibility("default"))) const poissonlab::DrawingFunctions* poissonlab_drawing_functions()
{
    static constexpr poissonlab::DrawingFunctions functions{poissonlab::read_svg_drawing, poissonlab::shape_of_path};
    return &functions;
}
