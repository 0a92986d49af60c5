// Regions as they are typed, or as files hold them: GeoJSON, WKT, rectangles and disks.
#pragma once

#include "base/regions/plane_region.hpp"
#include "base/regions/region_reading.hpp"

#include <string>

namespace poissonlab {

/// Corners of the polygon that stands for a disk; its area is 6.3e-6 of the disk's less.
inline constexpr int disk_corners = 1024;

/// The region that a text describes, or the file of this name:
///   rectangle X0 Y0 X1 Y1
///   disk X Y RADIUS
///   formula X0 Y0 X1 Y1 EXPRESSION
///   path [evenodd] [tolerance T] M...          the data of a path of SVG; curves become lines
///   POLYGON ((...)), MULTIPOLYGON (((...)))    WKT, also GEOMETRYCOLLECTION, with Z, M and SRID=
///   {"type": ...}                              GeoJSON: Polygon, MultiPolygon, Feature, FeatureCollection,
///                                              GeometryCollection
/// Longitudes and latitudes are mapped to a plane of metres; polygons that overlap or share edges become their union;
/// both are among the notes of the region's source. Rings may go round in either direction. Throws InputError, a line
/// that names the file or begins with the text, for whatever is none or not valid, see check_region(), and for regions
/// of space.
PlaneRegion read_region(const std::string& text, const RegionReading& reading = {});

/// Throws InputError where PROJ knows no system of coordinates of this name.
void check_map_system(const std::string& name);

/// The region of a path of SVG in a text `path [evenodd|nonzero] [tolerance T] DATA`: what its closed lines go around,
/// by the rule nonzero unless the text says evenodd. Curves become lines that are off by no more than the tolerance,
/// which is a ten-thousandth of the longest side of the box around the path's ends, control points and arcs by default.
/// y is as it was typed: a drawing in which it grows downwards stands on its head. Paths must not cross themselves or
/// each other.
PlaneRegion region_of_svg_path(const std::string& text, const std::string& name);

/// Returns the lines of such a path, closed or not; they may cross.
std::vector<RegionRing> lines_of_svg_path(const std::string& text, const std::string& name);

/// The region of a file of SVG: what its shapes go around, each by its rule of filling, upright, in the units of its
/// viewBox from the lower left corner on. Throws InputError, a line with the name and the line's number, for shapes
/// that cross themselves or go around nothing, and for what is not known. Shapes may not overlap each other: see
/// check_region().
PlaneRegion region_of_svg_drawing(const std::string& content, const std::string& name);

/// Returns the lines of the shapes of a file of SVG; they may cross. Throws InputError as region_of_svg_drawing() does.
std::vector<RegionRing> lines_of_svg_drawing(const std::string& content, const std::string& name);

}
