// This measures points on lines of the plane, wherever they come from: along roads, shores and fences, and on outlines.
//
// Distances of nearest points are straight through the plane. Gaps are along a line, between neighbours on it: those of
// random points are independent and exponential, those of points at equal steps are all the same. K functions along
// networks of lines (Ang, Baddeley and Nair 2012) need ways through their crossings and are not measured.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/regions/plane_region.hpp"
#include "base/regions/region_reading.hpp"
#include "host/kinds/kind.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// These are the keys of kind = "line-set".
struct LineSetSettings
{
    std::filesystem::path set;
    std::string region;
    RegionReading reading;
};

struct LineSet
{
    std::size_t lines = 0;
    double length = 0;          ///< of all lines, in units of the region
    double least = 0;           ///< distance of two points
    double mean_nearest = 0;    ///< distance of points from their nearest ones
    std::vector<double> gaps{}; ///< along lines, in rising order; around closed ones as well, if they have a point
};

/// Measures two points or more, in the region's plane. They may be off their lines by a millionth of the longest side
/// of the box around these. Throws InputError, with the number of those that are farther away, and the first of them.
LineSet measure_line_set(const PlaneRegion& region, const PointSet& points);

/// Returns kind = "line-set", which measures a file of points.
Kind line_set_kind();

}
