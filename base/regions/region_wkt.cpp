// WKT, read by Boost.Geometry.
#include "base/errors/errors.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/region_text.hpp"

#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/multi_linestring.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/io/wkt/read.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace poissonlab {
namespace {

using WktPoint = boost::geometry::model::d2::point_xy<double>;
using WktPoints = boost::geometry::model::multi_point<WktPoint>;
using WktLine = boost::geometry::model::linestring<WktPoint>;
using WktLines = boost::geometry::model::multi_linestring<WktLine>;
using WktPolygon = boost::geometry::model::polygon<WktPoint>;
using WktPolygons = boost::geometry::model::multi_polygon<WktPolygon>;

RegionRing ring_of_wkt(const WktPolygon::ring_type& positions, const std::string& name)
{
    RegionRing ring;
    for (const auto& position : positions) ring.push_back({position.x(), position.y()});
    if (ring.size() < 4 || ring.front() != ring.back())
        throw InputError(name + ": a ring is not closed: its last position must be its first, of four or more");
    ring.pop_back();
    return ring;
}

/// Boost takes coordinates that lack for 0.
void check_positions(const std::string& text, const std::string& name)
{
    constexpr const char *bounds = "(,)", *blanks = " \t\r\n";
    std::size_t begin = text.find('(');
    while (begin != std::string::npos) {
        const std::size_t first = text.find_first_not_of(blanks, begin + 1);
        begin = text.find_first_of(bounds, begin + 1);
        if (begin == std::string::npos || first == begin) continue;
        const std::string position = text.substr(first, text.find_last_not_of(blanks, begin - 1) + 1 - first);
        if (position.find_first_of(blanks) == std::string::npos)
            throw InputError(
                fmt::format("{}: is not WKT: {}: must be two numbers", name, shortened(printable(position))));
    }
}

/// Reads one or several of a kind: `text` begins with the word of either.
template <typename Several>
Several read_several(const std::string& text, const std::string& name)
{
    check_positions(text, name);
    Several several;
    try {
        const std::size_t first = text.find_first_not_of(" \t\r\n");
        if (first != std::string::npos && (text[first] == 'M' || text[first] == 'm'))
            boost::geometry::read_wkt(text, several);
        else
            boost::geometry::read_wkt(text, several.emplace_back());
    } catch (const boost::geometry::read_wkt_exception& error) {
        std::string what = error.what();
        throw InputError(
            fmt::format("{}: is not WKT: {}", name, shortened(printable(what.substr(0, what.find(" in '"))), 120)));
    }
    return several;
}

/// Does the text have this word, whatever its case, before its first bracket?
bool begins_as(const std::string& text, const std::string& word)
{
    std::string begin = text.substr(0, text.find('('));
    std::ranges::transform(begin, begin.begin(), [](char c) { return std::toupper(static_cast<unsigned char>(c)); });
    return begin.find(word) != std::string::npos;
}

}

PlaneRegion region_of_wkt(const std::string& text, const std::string& name)
{
    const auto polygons = read_several<WktPolygons>(text, name);
    PlaneRegion region;
    for (const WktPolygon& polygon : polygons) {
        RegionPolygon& added = region.polygons.emplace_back();
        added.outline = ring_of_wkt(polygon.outer(), name);
        for (const auto& hole : polygon.inners()) added.holes.push_back(ring_of_wkt(hole, name));
    }
    return region;
}

Obstacles obstacles_of_wkt(const std::string& text, const std::string& name)
{
    Obstacles obstacles;
    if (begins_as(text, "POINT")) {
        for (const WktPoint& point : read_several<WktPoints>(text, name))
            obstacles.points.push_back({point.x(), point.y()});
    } else if (begins_as(text, "LINESTRING")) {
        for (const WktLine& line : read_several<WktLines>(text, name)) {
            if (line.size() < 2) throw InputError(name + ": a line must have two positions or more");
            RegionRing& added = obstacles.lines.emplace_back();
            for (const WktPoint& corner : line) added.push_back({corner.x(), corner.y()});
        }
    } else {
        obstacles.polygons = region_of_wkt(text, name).polygons;
    }
    return obstacles;
}

}
