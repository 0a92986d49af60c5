// Points, lines and polygons of one plane in another one, where straight edges need not be straight.
#pragma once

#include "base/regions/formats/typed_region.hpp"
#include "base/regions/globe/map_system.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/region_reading.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>

namespace poissonlab {

using PlaceMap = std::function<void(std::span<double> places)>;

/// An edge becomes as many as it takes to lie within this part of the longest side of a region; farther from the region
/// than that side, within an eighth of the distance.
inline constexpr double bent_edge_tolerance = 0x1p-20;

/// Returns the shapes behind a map. Edges get corners where they bend; edges of rings that go to a place and back again
/// are left out.
/// `near` is the region's box there, which lies around all of it if it is the region that is mapped.
Obstacles mapped_shapes(const Obstacles& shapes, const PlaceMap& map, const RegionBox& near);

/// The box around the places of the corners behind the map.
RegionBox mapped_box(const Obstacles& shapes, const PlaceMap& map);

/// The plane of lengths around shapes on the globe: its middle is that of their box there, rounded to a ten-thousandth
/// of a degree.
std::shared_ptr<const LocalPlane> plane_around(const Obstacles& shapes, const MapSystem& system);

/// The largest distortion of lengths at any of their corners.
double largest_distortion(const Obstacles& shapes, const LocalPlane& plane);

// Which system of coordinates a region's text or file has.

/// The system that the reading or the text says, or that GeoJSON has by its standard, where its coordinates could be
/// degrees; none where they are lengths of nobody knows which plane. Throws InputError where PROJ knows none of this
/// name, and for WKT without SRID that looks like degrees.
std::optional<MapSystem> source_system(const TypedRegion& typed, const RegionReading& reading);

/// The coordinate system of obstacles. WKT and files of points do not name one: they have the region's.
std::optional<MapSystem> obstacle_system(const TypedRegion& typed, const RegionReading& reading);

/// The member `crs` of GeoJSON for points in this system; empty for that of the standard.
std::string crs_member(const TypedRegion& typed, const MapSystem& system);

/// Throws InputError: coordinates are degrees, and nothing says how they lie in the plane of the region.
[[noreturn]] void refuse_degrees(const RegionBox& box, const std::string& name, const std::string& why);

}
