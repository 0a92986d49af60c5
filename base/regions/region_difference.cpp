// A region without polygons, by CGAL's Boolean operations with exact numbers.
#include "base/regions/obstacles.hpp"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>

#include <algorithm>
#include <iterator>

namespace poissonlab {
namespace {

using SetKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using SetRing = CGAL::Polygon_2<SetKernel>;
using SetPolygon = CGAL::Polygon_with_holes_2<SetKernel>;
using PolygonSet = CGAL::Polygon_set_2<SetKernel>;

SetRing set_ring(const RegionRing& ring, CGAL::Orientation orientation)
{
    SetRing result;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (ring[i] != ring[(i + 1) % ring.size()]) result.push_back({ring[i][0], ring[i][1]});
    if (result.orientation() != orientation) result.reverse_orientation();
    return result;
}

SetPolygon set_polygon(const RegionPolygon& polygon)
{
    SetPolygon result(set_ring(polygon.outline, CGAL::COUNTERCLOCKWISE));
    for (const RegionRing& hole : polygon.holes) result.add_hole(set_ring(hole, CGAL::CLOCKWISE));
    return result;
}

RegionRing ring_of_set(const SetRing& ring)
{
    RegionRing result;
    for (auto corner = ring.vertices_begin(); corner != ring.vertices_end(); ++corner)
        result.push_back({CGAL::to_double(corner->x()), CGAL::to_double(corner->y())});
    return result;
}

bool do_boxes_meet(const RegionBox& a, const RegionBox& b)
{
    return a.low[0] <= b.high[0] && b.low[0] <= a.high[0] && a.low[1] <= b.high[1] && b.low[1] <= a.high[1];
}

}

PlaneRegion without_polygons(const PlaneRegion& region, const std::vector<RegionPolygon>& polygons)
{
    const RegionBox box = box_of(region);
    std::vector<SetPolygon> taken;
    for (const RegionPolygon& polygon : polygons)
        if (do_boxes_meet(box, box_of({{polygon}}))) taken.push_back(set_polygon(polygon));
    if (taken.empty()) return region;
    std::vector<SetPolygon> whole;
    for (const RegionPolygon& polygon : region.polygons) whole.push_back(set_polygon(polygon));
    PolygonSet rest, gone;
    rest.join(whole.begin(), whole.end());
    gone.join(taken.begin(), taken.end());
    rest.difference(gone);
    std::vector<SetPolygon> left;
    rest.polygons_with_holes(std::back_inserter(left));
    PlaneRegion result;
    for (const SetPolygon& polygon : left) {
        RegionPolygon& added = result.polygons.emplace_back();
        added.outline = ring_of_set(polygon.outer_boundary());
        for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
            added.holes.push_back(ring_of_set(*hole));
    }
    return result;
}

}
