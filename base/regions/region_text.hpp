// Regions as they are typed, or as files hold them: GeoJSON, WKT, rectangles and disks.
#pragma once

#include "base/regions/plane_region.hpp"

#include <string>
#include <string_view>

namespace poissonlab {

/// Corners of the polygon that stands for a disk; its area is 6.3e-6 of the disk's less.
inline constexpr int disk_corners = 1024;

/// The region that a text describes, or the file of this name:
///   rectangle X0 Y0 X1 Y1
///   disk X Y RADIUS
///   formula X0 Y0 X1 Y1 EXPRESSION
///   path [evenodd] [tolerance T] M...          the data of a path of SVG; curves become lines
///   POLYGON ((...)), MULTIPOLYGON (((...)))    WKT
///   {"type": ...}                              GeoJSON: Polygon, MultiPolygon, Feature, FeatureCollection,
///                                              GeometryCollection
/// Rings may go round in either direction. Throws InputError, a line that names the file or begins with the text, for
/// whatever is none or not valid, see check_region(), for regions of space, and for longitudes and latitudes unless
/// `is_planar`: what lies between them has other lengths along either axis.
PlaneRegion read_region(const std::string& text, bool is_planar = false);

/// The region of a GeoJSON text; `name` is what messages call it. It is not checked beyond its form. `says_metres` is
/// set where its `crs` names a system of coordinates other than longitude and latitude.
PlaneRegion region_of_geojson(std::string_view text, const std::string& name, bool& says_metres);

/// The region of a path of SVG in a text `path [evenodd|nonzero] [tolerance T] DATA`: what its closed lines go around,
/// by the rule nonzero unless the text says evenodd. Curves become lines that are off by no more than the tolerance,
/// which is a ten-thousandth of the longest side of the box around the path's ends, control points and arcs by default.
/// y is as it was typed: a drawing in which it grows downwards stands on its head. Paths must not cross themselves or
/// each other.
PlaneRegion region_of_svg_path(const std::string& text, const std::string& name);

/// The region of a file of SVG: what its shapes go around, each by its rule of filling, upright, in the units of its
/// viewBox from the lower left corner on. Throws InputError, a line with the name and the line's number, for shapes
/// that cross themselves or go around nothing, and for what is not known. Shapes may not overlap each other: see
/// check_region().
PlaneRegion region_of_svg_drawing(const std::string& content, const std::string& name);

/// The region of a text in WKT, read as region_of_geojson() reads GeoJSON.
PlaneRegion region_of_wkt(const std::string& text, const std::string& name);

}
