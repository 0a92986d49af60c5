// Obstacles, which points of a region keep away from: points, lines and polygons in the region's units.
#pragma once

#include "base/regions/plane_region.hpp"
#include "base/regions/region_reading.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

struct Obstacles
{
    std::vector<std::array<double, 2>> points{};
    std::vector<RegionRing> lines{};       ///< open: the last corner is an end
    std::vector<RegionPolygon> polygons{}; ///< each valid by itself; they may overlap each other
    std::vector<std::string> notes{};      ///< what was made of their file, a sentence each

    std::size_t count() const { return points.size() + lines.size() + polygons.size(); }
};

/// The obstacles that a text describes, or the file of this name: what regions are, see read_region(), and the points
/// and lines of GeoJSON and WKT, in the plane of the region. Those that say no system of coordinates have that of the
/// region's file. Throws InputError as it does.
Obstacles read_obstacles(const std::string& text, const RegionReading& reading = {}, const PlaneRegion& region = {});

/// The part of a region that lies in none of the polygons, which may overlap each other and the boundary: see
/// polygon_sets.hpp. It may be empty.
PlaneRegion without_polygons(const PlaneRegion& region, const std::vector<RegionPolygon>& polygons);

/// Lines and edges of polygons, from x, y to x, y, as far as they lie in a box.
std::vector<std::array<double, 4>> lines_within(const Obstacles& obstacles, const RegionBox& box);

/// The points in a box.
std::vector<std::array<double, 2>> points_within(const Obstacles& obstacles, const RegionBox& box);

}
