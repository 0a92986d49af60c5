// Which system of coordinates a region's text or file has.
#pragma once

#include "base/regions/formats/typed_region.hpp"
#include "base/regions/globe/map_system.hpp"
#include "base/regions/region_reading.hpp"

#include <optional>

namespace poissonlab {

/// The system that the reading or the text says, or that GeoJSON has by its standard, where its coordinates could be
/// degrees; none where they are lengths of nobody knows which plane. Throws InputError where PROJ knows none of this
/// name, and for WKT without SRID that looks like degrees.
std::optional<MapSystem> source_system(const TypedRegion& typed, const RegionReading& reading);

/// That of obstacles, which WKT and files of points do not say: they have the region's.
std::optional<MapSystem> obstacle_system(const TypedRegion& typed, const RegionReading& reading);

/// The member `crs` of GeoJSON for points in this system; empty for that of the standard.
std::string crs_member(const TypedRegion& typed, const MapSystem& system);

/// Throws InputError: coordinates are degrees, and nothing says how they lie in the plane of the region.
[[noreturn]] void refuse_degrees(const RegionBox& box, const std::string& name, const std::string& why);

}
