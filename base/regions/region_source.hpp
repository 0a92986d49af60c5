// The coordinate system that a region's file has, so that points can be read and written as its file has them.
//
// Whoever reads longitudes and latitudes maps them to a plane of lengths (see map_system.hpp, which only programs with
// the module of regions have); the core reads and writes points by the functions below.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/regions/plane_region.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// A map between places of a file and those of a plane, which any thread may use.
class PlaneMap
{
public:
    virtual ~PlaneMap() = default;

    /// Maps x, y, x, y, ... of the file. Places that have none in the plane become infinite.
    virtual void to_plane(std::span<double> places) const = 0;

    /// Maps them back.
    virtual void to_file(std::span<double> places) const = 0;

    /// The middle of the plane: longitude and latitude.
    virtual std::array<double, 2> middle() const = 0;
};

/// A part of a region that its file has a name for.
struct RegionFeature
{
    std::string id; ///< JSON: the id of a Feature, or else its number from 0 on; then its properties as further members
    std::string properties = "{}";         ///< all of them, a JSON object
    std::vector<RegionPolygon> polygons{}; ///< in the plane
};

struct RegionSource
{
    std::shared_ptr<const PlaneMap> map{};      ///< null: the plane has the file's coordinates
    double distortion = 0;                      ///< the part by which the map changes lengths, at most
    std::string system{};                       ///< the file's system of coordinates as PROJ knows it; empty: not said
    std::vector<std::string> notes{};           ///< what was made of the file, a sentence each
    std::vector<RegionFeature> features{};      ///< empty: the file has none
    std::vector<RegionRing> lines{};            ///< open ones, of a region of points on lines, which has no polygons
    std::vector<std::size_t> feature_of_line{}; ///< of each of them, where there are features
};

/// Returns the lines of a region of points on lines; other regions have none.
const std::vector<RegionRing>& lines_of(const PlaneRegion& region);

/// These return the length of lines, and the box around them.
double length_of(const std::vector<RegionRing>& lines);
RegionBox box_around(const std::vector<RegionRing>& lines);

/// Are the coordinates of its files longitudes and latitudes?
bool is_mapped(const PlaneRegion& region);

/// Points of the region's plane as files have them.
PointSet as_in_files(const PlaneRegion& region, PointSet points);

/// Points of files in the region's plane.
PointSet as_in_plane(const PlaneRegion& region, PointSet points);

/// The member `crs` of GeoJSON in coordinates of its files; empty: degrees, as the standard has it.
std::string crs_in_files(const PlaneRegion& region);

/// The sentence about points in columns of longitude and latitude, which are lengths in this region; empty where they
/// are mapped to its plane.
std::string degrees_sentence(const PlaneRegion& region);

/// The words for coordinates of its files: "units of the region", or longitude and latitude.
std::string file_units(const PlaneRegion& region);

/// The sentences on what was made of its file.
const std::vector<std::string>& notes_of(const PlaneRegion& region);

}
