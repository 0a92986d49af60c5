#include "base/regions/region_text.hpp"

#include "base/errors/errors.hpp"
#include "base/files/file_kind.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/region_raster.hpp"
#include "base/regions/region_words.hpp"
#include "base/regions/space_region.hpp"
#include "base/text/decimal_commas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace poissonlab {
namespace {

/// Coordinates that are ten times as far from 0 as they are from each other are places on the globe, where they
/// could be.
constexpr double far_away = 10;

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

/// Could the coordinates be longitudes and latitudes?
bool fits_globe(const RegionBox& box)
{
    return box.low[0] >= -180 && box.high[0] <= 180 && box.low[1] >= -90 && box.high[1] <= 90;
}

bool is_far_away(const RegionBox& box)
{
    double nearest = 0;
    for (std::size_t k = 0; k < 2; ++k)
        if (box.low[k] > 0 || box.high[k] < 0)
            nearest = std::max(nearest, std::min(std::abs(box.low[k]), std::abs(box.high[k])));
    return nearest > far_away * box.longest();
}

void refuse_degrees(const RegionBox& box, const std::string& name, const std::string& why)
{
    throw InputError(
        fmt::format("{}: {}: coordinates from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) look like longitude and latitude, "
                    "whose degrees are no lengths: project them to metres, or say that they are lengths (planar)",
                    name, why, box.low[0], box.low[1], box.high[0], box.high[1]));
}

/// The parts of a WKT text: what stands before the geometry, and the rest.
struct WktBegin
{
    bool says_degrees = false;
    bool says_metres = false;
    std::string text;
};

WktBegin wkt_begin(std::string_view text, const std::string& name)
{
    if (!begins_with(text, "SRID=")) return {false, false, std::string(text)};
    const std::size_t end = text.find(';');
    if (end == std::string_view::npos) throw InputError(name + ": is not WKT: no ; after SRID=");
    const std::string_view system = text.substr(5, end - 5);
    const bool says_degrees = system == "4326" || system == "4269" || system == "4258";
    return {says_degrees, !says_degrees, std::string(without_blanks_around(text.substr(end + 1)))};
}

PlaneRegion read_wkt(std::string_view text, const std::string& name, bool is_planar)
{
    const WktBegin begin = wkt_begin(text, name);
    PlaneRegion region = region_of_wkt(begin.text, name);
    check_region(region, name);
    if (is_planar || begin.says_metres) return region;
    const RegionBox box = box_of(region);
    if (begin.says_degrees) refuse_degrees(box, name, "its SRID is one of degrees");
    if (fits_globe(box) && is_far_away(box)) refuse_degrees(box, name, "it is small and far from 0");
    return region;
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

/// A region's text, what messages call it, and what it holds.
struct TypedRegion
{
    std::string name, content;
    std::optional<PlaneRegion> shape; ///< of what is neither GeoJSON nor WKT

    explicit TypedRegion(const std::string& text)
    {
        const bool is_file = !is_region_text(text);
        name = is_file ? printable(text) : shortened(printable(text), 40);
        if (is_file && has_drawing_name(text)) {
            shape = region_of_svg_drawing(read_whole_file(text), name);
            return;
        }
        if (is_file && has_picture_name(text)) {
            shape = region_of_picture(text);
            return;
        }
        content = without_blanks_around(is_file ? read_whole_file(text) : text);
        if (is_space_region_text(content))
            throw InputError(name + ": is a region of space; this takes regions of the plane");
        if (is_region_text(content) && !is_json() && !is_wkt_text(content)) shape = shape_of(content);
    }

    bool is_json() const { return content.starts_with('{'); }
    bool is_known() const { return shape || is_region_text(content); }
};

constexpr auto no_region =
    "is neither GeoJSON nor WKT, nor a picture or drawing, nor rectangle X0 Y0 X1 Y1, disk X Y RADIUS, "
    "formula X0 Y0 X1 Y1 EXPRESSION or path M... of SVG";

/// The points of a file in one of the formats of points.
std::vector<std::array<double, 2>> points_of_file(const std::string& file)
{
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<std::array<double, 2>> points;
    try {
        for (const PointSet& set : read_points(file, CoordinateRange{-far, far})) {
            if (set.dimension != 2) throw InputError("the points are in space");
            for (std::size_t i = 0; i < set.size(); ++i) points.push_back({set[i][0], set[i][1]});
        }
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}, nor a file of points: {}", printable(file), no_region, error.what()));
    }
    return points;
}

/// Joins polygons, lines and points into one region, as if lines and points were outlines.
PlaneRegion outlines_of(const Obstacles& obstacles)
{
    PlaneRegion all{obstacles.polygons};
    for (const RegionRing& line : obstacles.lines) all.polygons.push_back({line});
    all.polygons.push_back({obstacles.points});
    return all;
}

RegionBox box_of_all(const Obstacles& obstacles) { return box_of(outlines_of(obstacles)); }

void check_obstacles(const Obstacles& obstacles, const std::string& name)
{
    if (obstacles.count() == 0) throw InputError(name + ": has no point, line or polygon to keep away from");
    for (const RegionPolygon& polygon : outlines_of(obstacles).polygons)
        for (const auto& [x, y] : polygon.outline)
            if (!std::isfinite(x) || !std::isfinite(y)) throw InputError(name + ": has a coordinate that is no number");
    for (std::size_t i = 0; i < obstacles.polygons.size(); ++i)
        check_region({{obstacles.polygons[i]}},
                     obstacles.polygons.size() == 1 ? name : fmt::format("{}: polygon {}", name, i + 1));
}

}

PlaneRegion read_region(const std::string& text, bool is_planar)
{
    const TypedRegion typed(text);
    if (!typed.is_known()) throw InputError(fmt::format("{}: {}", typed.name, no_region));
    if (is_wkt_text(typed.content)) return read_wkt(typed.content, typed.name, is_planar);
    bool says_metres = false;
    PlaneRegion region = typed.shape ? *typed.shape : region_of_geojson(typed.content, typed.name, says_metres);
    check_region(region, typed.name);
    if (typed.is_json() && !is_planar && !says_metres && fits_globe(box_of(region)))
        refuse_degrees(box_of(region), typed.name, "GeoJSON without another crs");
    return region;
}

Obstacles read_obstacles(const std::string& text, bool is_planar)
{
    const TypedRegion typed(text);
    Obstacles obstacles;
    std::string degrees; // why coordinates are taken for degrees
    if (!typed.is_known()) {
        obstacles.points = points_of_file(text);
    } else if (typed.shape) {
        obstacles.polygons = typed.shape->polygons;
    } else if (is_wkt_text(typed.content)) {
        const WktBegin begin = wkt_begin(typed.content, typed.name);
        obstacles = obstacles_of_wkt(begin.text, typed.name);
        if (begin.says_degrees) degrees = "its SRID is one of degrees";
    } else {
        bool says_metres = false;
        obstacles = obstacles_of_geojson(typed.content, typed.name, says_metres);
        if (!says_metres && obstacles.count() > 0 && fits_globe(box_of_all(obstacles)))
            degrees = "GeoJSON without another crs";
    }
    check_obstacles(obstacles, typed.name);
    if (!degrees.empty() && !is_planar) refuse_degrees(box_of_all(obstacles), typed.name, degrees);
    return obstacles;
}

}
