#include "base/regions/formats/typed_region.hpp"

#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"
#include "base/files/json_file.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "base/regions/region_raster.hpp"
#include "base/regions/region_text.hpp"
#include "base/regions/region_words.hpp"
#include "base/regions/space_region.hpp"
#include "base/text/decimal_commas.hpp"
#include "base/text/plain_text.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>
#include <system_error>

namespace poissonlab {
namespace {

/// The numbers after the first word, if there are so many and no others, and if none can have a decimal comma.
std::optional<std::vector<double>> numbers_after_word(std::string_view text, std::size_t count)
{
    std::vector<double> numbers;
    if (mixes_separators(text.substr(std::min(text.size(), text.find(' '))), count, 2)) return {};
    WordReader words(text);
    for (words.next(); words.next();) {
        double number = 0;
        if (!parse_number(words.word(), number) || !std::isfinite(number)) return {};
        numbers.push_back(number);
    }
    if (numbers.size() != count) return {};
    return numbers;
}

PlaneRegion rectangle_of(const std::string& text)
{
    const auto n = numbers_after_word(text, 4);
    if (!n || !((*n)[0] < (*n)[2]) || !((*n)[1] < (*n)[3]))
        throw InputError(shortened(printable(text)) + ": must be rectangle X0 Y0 X1 Y1 with X0 < X1 and Y0 < Y1" +
                         decimal_comma_words(text));
    const double x0 = (*n)[0], y0 = (*n)[1], x1 = (*n)[2], y1 = (*n)[3];
    PlaneRegion region;
    region.polygons.emplace_back().outline = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    return region;
}

PlaneRegion disk_of(const std::string& text)
{
    const auto n = numbers_after_word(text, 3);
    if (!n || !((*n)[2] > 0))
        throw InputError(shortened(printable(text)) + ": must be disk X Y RADIUS with RADIUS > 0" +
                         decimal_comma_words(text));
    PlaneRegion region;
    RegionRing& ring = region.polygons.emplace_back().outline;
    for (int i = 0; i < disk_corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / disk_corners;
        ring.push_back({(*n)[0] + (*n)[2] * std::cos(angle), (*n)[1] + (*n)[2] * std::sin(angle)});
    }
    return region;
}

/// Four numbers and an expression.
PlaneRegion formula_region_of(const std::string& text)
{
    std::array<double, 4> n{};
    WordReader words(text);
    bool is_right = words.next() && !mixes_separators(std::string_view(text).substr(text.find(' ')), n.size(), 2);
    for (double& number : n)
        is_right = is_right && words.next() && parse_number(words.word(), number) && std::isfinite(number);
    is_right = is_right && words.next() && n[0] < n[2] && n[1] < n[3];
    if (!is_right)
        throw InputError(shortened(printable(text)) +
                         ": must be formula X0 Y0 X1 Y1 EXPRESSION with X0 < X1, Y0 < Y1 and an expression in x and y" +
                         decimal_comma_words(text));
    const auto begin = static_cast<std::size_t>(words.word().data() - text.data());
    return region_of_formula(text.substr(begin), {n[0], n[1]}, {n[2], n[3]});
}

PlaneRegion shape_of(const std::string& text)
{
    if (begins_with(text, "formula ")) return formula_region_of(text);
    if (begins_with(text, "path ")) return region_of_svg_path(text, shortened(printable(text), 40));
    return begins_with(text, "disk ") ? disk_of(text) : rectangle_of(text);
}

bool has_drawing_name(std::string_view file)
{
    return file.size() > 4 && begins_with(file.substr(file.size() - 4), ".svg");
}

}

/// A longer text that is no file was meant to say a region, and is not shown as a whole.
constexpr std::size_t longest_absent_name = 250;

const char* const no_region =
    "is neither GeoJSON nor WKT, nor a picture or drawing, nor rectangle X0 Y0 X1 Y1, disk X Y RADIUS, "
    "formula X0 Y0 X1 Y1 EXPRESSION or path M... of SVG";

TypedRegion::TypedRegion(const std::string& text, bool is_along)
{
    std::error_code unknown;
    const bool may_be_name =
        text.size() <= longest_absent_name ||
        (text.find('/') != text.npos && text.find_first_of("({<") == text.npos && printable(text) == text);
    const bool is_file = !is_region_text(text) && (may_be_name || std::filesystem::exists(text, unknown));
    name = is_file ? printable(text) : shortened(printable(text), 40);
    if (is_file && is_mesh_name(text))
        throw InputError(name + ": is a mesh, whose inside is a region of space; this takes regions of the plane");
    if (is_file && has_drawing_name(text)) {
        kind = TypedKind::shape;
        const std::string drawing = read_whole_file(text);
        if (is_along)
            shapes.shapes.lines = lines_of_svg_drawing(drawing, name);
        else
            shapes.shapes.polygons = region_of_svg_drawing(drawing, name).polygons;
        return;
    }
    if (is_file && has_picture_name(text)) {
        kind = TypedKind::shape;
        shapes.shapes.polygons = region_of_picture(text).polygons;
        return;
    }
    const std::string file = is_file ? read_whole_file(text) : "";
    const std::string content(without_blanks_around(is_file ? plain_text(name, file) : text));
    if (is_file && content.empty()) throw InputError(name + ": is empty");
    if (is_space_region_text(content))
        throw InputError(name + ": is a region of space; this takes regions of the plane");
    if (begins_as_geojson(content)) {
        kind = TypedKind::json;
        shapes = shapes_of_geojson(content, name);
    } else if (is_wkt_text(content)) {
        kind = TypedKind::wkt;
        shapes = shapes_of_wkt(content, name);
    } else if (is_along && begins_with(content, "path ")) {
        kind = TypedKind::shape;
        shapes.shapes.lines = lines_of_svg_path(content, is_file ? name : shortened(printable(content), 40));
    } else if (is_region_text(content)) {
        kind = TypedKind::shape;
        try {
            shapes.shapes.polygons = shape_of(content).polygons;
        } catch (const InputError& error) {
            if (!is_file) throw;
            throw InputError(name + ": " + error.what());
        }
    }
}

/// Lines and points are looked at as if they were outlines.
RegionBox box_of_all(const Obstacles& shapes)
{
    PlaneRegion all{shapes.polygons};
    for (const RegionRing& line : shapes.lines) all.polygons.push_back({line});
    all.polygons.push_back({shapes.points});
    return box_of(all);
}

}
