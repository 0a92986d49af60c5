// Regions of the plane in units of their own: polygons with holes.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace poissonlab {

/// The corners of a closed line, in either direction; the first one does not come again at the end.
using RegionRing = std::vector<std::array<double, 2>>;

/// A polygon: the places within its outline and in none of its holes.
struct RegionPolygon
{
    RegionRing outline;
    std::vector<RegionRing> holes{};
};

/// See base/regions/region_source.hpp.
struct RegionSource;

struct PlaneRegion
{
    std::vector<RegionPolygon> polygons; ///< that touch each other in single points at most
    std::string crs{};                   ///< the member of GeoJSON that names the system of points' files; empty: none
    std::shared_ptr<const RegionSource> source{}; ///< what was made of a file's coordinates; null: nothing
};

/// The least rectangle around it.
struct RegionBox
{
    std::array<double, 2> low{};
    std::array<double, 2> high{};

    double width() const { return high[0] - low[0]; }
    double height() const { return high[1] - low[1]; }
    double longest() const { return width() > height() ? width() : height(); }
};

RegionBox box_of(const PlaneRegion& region);

/// The area that a ring encloses: positive where it goes round to the left.
double signed_area_of(const RegionRing& ring);

/// The area of a region, in squares of its units.
double area_of(const PlaneRegion& region);

std::size_t corner_count(const PlaneRegion& region);

/// A minimum distance is enlarged by this, so that points in the box that are so far apart have coordinates whose
/// computed distance is not below it: each coordinate is rounded twice, by half a unit in the last place of the largest
/// one at most, and so are differences, squares and root.
double distance_rounding(double distance, const RegionBox& box);

/// Throws InputError, a line that begins with `name`, where there is no region: no polygon, fewer than three corners,
/// coordinates that are no numbers, rings that cross or touch themselves, cross each other or share a piece of a line,
/// holes outside their outline or inside another hole, polygons inside each other, and areas of nothing. By exact
/// predicates.
void check_region(const PlaneRegion& region, const std::string& name);

/// Throws InputError as check_region() does where rings cross or touch themselves, cross each other or share a piece of
/// a line, wherever they lie to each other.
void check_rings(const std::vector<RegionRing>& rings, const std::string& name);

}
