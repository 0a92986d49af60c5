// Unions of polygons, what is left of them, and polygons around things, by GEOS.
//
// Corners that result are rounded to doubles; where nothing meets, corners stay as they were.
#pragma once

#include "base/regions/obstacles.hpp"

namespace poissonlab {

/// The union of polygons that are valid each by itself. Parts that share an edge, or a piece of one, become one
/// polygon.
std::vector<RegionPolygon> united(const std::vector<RegionPolygon>& polygons);

/// Returns the parts of lines outside of polygons; `lines_of` has the number of the line that each part belongs to.
std::vector<RegionRing> lines_without(const std::vector<RegionRing>& lines, const std::vector<RegionPolygon>& polygons,
                                      std::vector<std::size_t>& lines_of);

/// Polygons of all places within `distance` of points, lines or polygons. Arcs have 90 edges in a quarter, whose
/// middles are nearer by 3.8e-5 of the distance.
std::vector<RegionPolygon> grown(const Obstacles& things, double distance);

}
