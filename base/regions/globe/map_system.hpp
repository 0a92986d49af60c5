// Systems of coordinates as PROJ knows them, and maps between them.
//
// Longitude comes before latitude, and east before north, in whatever order a system's own definition has its axes:
// files of GeoJSON and WKT are written so. Nothing is read from the network, so that results are the same everywhere.
#pragma once

#include "base/regions/region_source.hpp"

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace poissonlab {

/// The facts about a system of coordinates.
struct MapSystem
{
    std::string text;              ///< by which PROJ finds it
    std::string title;             ///< "WGS 84"
    bool has_angles = false;       ///< longitude and latitude; else x and y are lengths
    double angle = 0;              ///< radians in a unit of longitude and latitude, as a rule those of a degree
    double semi_major_axis = 0;    ///< of its ellipsoid, in metres
    double inverse_flattening = 0; ///< 0: it is a sphere
};

/// The system of longitude and latitude that GeoJSON has by its standard.
inline constexpr const char* geojson_system = "OGC:CRS84";

/// The system of this name or definition: EPSG:31370, urn:ogc:def:crs:OGC:1.3:CRS84, "ETRS89 / UTM zone 32N", ...
/// Throws InputError that begins with `text` where PROJ knows none, or where it is none of a plane or of longitude and
/// latitude.
MapSystem map_system(const std::string& text);

/// Lambert's azimuthal equal-area plane around a place of a system's ellipsoid, in metres: areas are exact, and lengths
/// the less so the farther they are from there.
class LocalPlane : public PlaneMap
{
public:
    /// The part by which lengths at a place are longer or shorter in the plane than on the ellipsoid, in the direction
    /// where it is most.
    virtual double distortion_at(const std::array<double, 2>& place) const = 0;
};

std::shared_ptr<const LocalPlane> local_plane(const MapSystem& system, std::array<double, 2> middle);

/// A function that changes places x, y, x, y, ... of one system into those of another. Throws InputError where PROJ
/// knows no way. One thread may use it.
std::function<void(std::span<double> places)> system_change(const MapSystem& from, const MapSystem& to);

/// Returns how many units of the plane of a system of lengths are one on the ground, at one of its places: 1 where it
/// is true.
double ground_scale(const MapSystem& system, std::array<double, 2> place);

}
