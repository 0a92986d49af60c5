#include "base/regions/polygon_sets.hpp"

#include "base/errors/errors.hpp"

#include <geos_c.h>

#include <functional>
#include <memory>
#include <string>

namespace poissonlab {
namespace {

constexpr int edges_in_quarter = 90;

/// Calls GEOS by one context, and keeps the last thing that it complains of.
class Geos
{
public:
    using Shape = std::unique_ptr<GEOSGeometry, std::function<void(GEOSGeometry*)>>;

    Geos() : context_(GEOS_init_r(), GEOS_finish_r)
    {
        GEOSContext_setErrorMessageHandler_r(
            context_.get(), [](const char* message, void* to) { *static_cast<std::string*>(to) = message; },
            &complaint_);
    }

    Shape polygon(const RegionPolygon& polygon) const
    {
        std::vector<GEOSGeometry*> holes;
        for (const RegionRing& hole : polygon.holes) holes.push_back(ring(hole).release());
        return owned(GEOSGeom_createPolygon_r(context_.get(), ring(polygon.outline).release(), holes.data(),
                                              static_cast<unsigned>(holes.size())));
    }

    Shape line(const RegionRing& places) const
    {
        return owned(GEOSGeom_createLineString_r(context_.get(), sequence(places, false)));
    }

    Shape point(const std::array<double, 2>& place) const
    {
        return owned(GEOSGeom_createPointFromXY_r(context_.get(), place[0], place[1]));
    }

    Shape collection(std::vector<Shape> shapes) const
    {
        std::vector<GEOSGeometry*> parts;
        for (Shape& shape : shapes) parts.push_back(shape.release());
        return owned(GEOSGeom_createCollection_r(context_.get(), GEOS_GEOMETRYCOLLECTION, parts.data(),
                                                 static_cast<unsigned>(parts.size())));
    }

    Shape polygons(const std::vector<RegionPolygon>& polygons) const
    {
        std::vector<Shape> shapes;
        for (const RegionPolygon& each : polygons) shapes.push_back(polygon(each));
        return collection(std::move(shapes));
    }

    Shape united(const Shape& shape) const { return owned(GEOSUnaryUnion_r(context_.get(), shape.get())); }

    Shape without(const Shape& shape, const Shape& taken) const
    {
        return owned(GEOSDifference_r(context_.get(), shape.get(), taken.get()));
    }

    /// Appends all lines of a shape, those of collections as well.
    void append_lines(const GEOSGeometry* shape, std::vector<RegionRing>& to) const
    {
        GEOSContextHandle_t context = context_.get();
        const int type = GEOSGeomTypeId_r(context, shape);
        if (type == GEOS_LINESTRING || type == GEOS_LINEARRING) {
            if (GEOSisEmpty_r(context, shape) == 0) to.push_back(positions_of(shape));
            return;
        }
        if (type != GEOS_MULTILINESTRING && type != GEOS_GEOMETRYCOLLECTION) return;
        for (int i = 0; i < GEOSGetNumGeometries_r(context, shape); ++i)
            append_lines(GEOSGetGeometryN_r(context, shape, i), to);
    }

    Shape grown(const Shape& shape, double distance) const
    {
        return owned(GEOSBuffer_r(context_.get(), shape.get(), distance, edges_in_quarter));
    }

    /// All polygons in a shape.
    void append_polygons(const GEOSGeometry* shape, std::vector<RegionPolygon>& to) const
    {
        GEOSContextHandle_t context = context_.get();
        if (GEOSGeomTypeId_r(context, shape) != GEOS_POLYGON) {
            for (int i = 0; is_collection(shape) && i < GEOSGetNumGeometries_r(context, shape); ++i)
                append_polygons(GEOSGetGeometryN_r(context, shape, i), to);
            return;
        }
        if (GEOSisEmpty_r(context, shape) != 0) return;
        RegionPolygon& polygon = to.emplace_back();
        polygon.outline = places_of(GEOSGetExteriorRing_r(context, shape));
        for (int i = 0; i < GEOSGetNumInteriorRings_r(context, shape); ++i)
            polygon.holes.push_back(places_of(GEOSGetInteriorRingN_r(context, shape, i)));
    }

private:
    bool is_collection(const GEOSGeometry* shape) const
    {
        const int type = GEOSGeomTypeId_r(context_.get(), shape);
        return type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION;
    }

    Shape owned(GEOSGeometry* shape) const
    {
        if (shape == nullptr) throw InputError("GEOS cannot join or part these polygons: " + complaint_);
        return {shape, [context = context_.get()](GEOSGeometry* old) { GEOSGeom_destroy_r(context, old); }};
    }

    GEOSCoordSequence* sequence(const RegionRing& places, bool is_closed) const
    {
        const auto count = static_cast<unsigned>(places.size() + is_closed);
        GEOSCoordSequence* const sequence = GEOSCoordSeq_create_r(context_.get(), count, 2);
        for (unsigned i = 0; i < count; ++i)
            GEOSCoordSeq_setXY_r(context_.get(), sequence, i, places[i % places.size()][0],
                                 places[i % places.size()][1]);
        return sequence;
    }

    Shape ring(const RegionRing& corners) const
    {
        return owned(GEOSGeom_createLinearRing_r(context_.get(), sequence(corners, true)));
    }

    /// The corners of a closed line, the first one once.
    RegionRing places_of(const GEOSGeometry* line) const
    {
        RegionRing places = positions_of(line);
        if (!places.empty()) places.pop_back();
        return places;
    }

    RegionRing positions_of(const GEOSGeometry* line) const
    {
        const GEOSCoordSequence* const sequence = GEOSGeom_getCoordSeq_r(context_.get(), line);
        unsigned count = 0;
        GEOSCoordSeq_getSize_r(context_.get(), sequence, &count);
        RegionRing places(count);
        for (unsigned i = 0; i < count; ++i)
            GEOSCoordSeq_getXY_r(context_.get(), sequence, i, &places[i][0], &places[i][1]);
        return places;
    }

    std::unique_ptr<GEOSContextHandle_HS, decltype(&GEOS_finish_r)> context_;
    std::string complaint_;
};

std::vector<RegionPolygon> polygons_of(const Geos& geos, const Geos::Shape& shape)
{
    std::vector<RegionPolygon> polygons;
    geos.append_polygons(shape.get(), polygons);
    return polygons;
}

bool do_boxes_meet(const RegionBox& a, const RegionBox& b)
{
    return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] && b.low[1] <= a.high[1];
}

}

std::vector<RegionPolygon> united(const std::vector<RegionPolygon>& polygons)
{
    const Geos geos;
    return polygons_of(geos, geos.united(geos.polygons(polygons)));
}

std::vector<RegionRing> lines_without(const std::vector<RegionRing>& lines, const std::vector<RegionPolygon>& polygons,
                                      std::vector<std::size_t>& lines_of)
{
    const Geos geos;
    const RegionBox box = box_of({polygons});
    const Geos::Shape gone = geos.united(geos.polygons(polygons));
    std::vector<RegionRing> rest;
    lines_of.clear();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (do_boxes_meet(box, box_of({{{lines[i]}}})))
            geos.append_lines(geos.without(geos.line(lines[i]), gone).get(), rest);
        else
            rest.push_back(lines[i]);
        lines_of.resize(rest.size(), i);
    }
    return rest;
}

std::vector<RegionPolygon> grown(const Obstacles& things, double distance)
{
    const Geos geos;
    std::vector<Geos::Shape> shapes;
    for (const auto& place : things.points) shapes.push_back(geos.point(place));
    for (const RegionRing& line : things.lines) shapes.push_back(geos.line(line));
    for (const RegionPolygon& polygon : things.polygons) shapes.push_back(geos.polygon(polygon));
    return polygons_of(geos, geos.united(geos.grown(geos.collection(std::move(shapes)), distance)));
}

PlaneRegion without_polygons(const PlaneRegion& region, const std::vector<RegionPolygon>& polygons)
{
    const RegionBox box = box_of(region);
    std::vector<RegionPolygon> taken;
    for (const RegionPolygon& polygon : polygons)
        if (do_boxes_meet(box, box_of({{polygon}}))) taken.push_back(polygon);
    if (taken.empty()) return region;
    const Geos geos;
    const Geos::Shape whole = geos.united(geos.polygons(region.polygons));
    const Geos::Shape gone = geos.united(geos.polygons(taken));
    PlaneRegion rest = region;
    rest.polygons = polygons_of(geos, geos.without(whole, gone));
    return rest;
}

}
