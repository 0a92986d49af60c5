// WKT, read by Boost.Geometry.
#include "base/errors/errors.hpp"
#include "base/regions/region_text.hpp"

#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/io/wkt/read.hpp>

#include <fmt/format.h>

namespace poissonlab {
namespace {

using WktPolygon = boost::geometry::model::polygon<boost::geometry::model::d2::point_xy<double>>;
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

}

PlaneRegion region_of_wkt(const std::string& text, const std::string& name)
{
    WktPolygons polygons;
    try {
        const std::size_t first = text.find_first_not_of(" \t\r\n");
        if (first != std::string::npos && (text[first] == 'M' || text[first] == 'm'))
            boost::geometry::read_wkt(text, polygons);
        else
            boost::geometry::read_wkt(text, polygons.emplace_back());
    } catch (const boost::geometry::read_wkt_exception& error) {
        std::string what = error.what();
        throw InputError(
            fmt::format("{}: is not WKT: {}", name, shortened(printable(what.substr(0, what.find(" in '"))), 120)));
    }
    PlaneRegion region;
    for (const WktPolygon& polygon : polygons) {
        RegionPolygon& added = region.polygons.emplace_back();
        added.outline = ring_of_wkt(polygon.outer(), name);
        for (const auto& hole : polygon.inners()) added.holes.push_back(ring_of_wkt(hole, name));
    }
    return region;
}

}
