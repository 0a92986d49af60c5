// Measures points on lines of the plane, made here or elsewhere: along roads, shores, fences and outlines.
//
// Nearest-neighbour distances are straight through the plane. Gaps are between neighbours along a line: those of random
// points are independent and exponential, those of points at equal steps are all equal. K functions along networks of
// lines (Ang, Baddeley and Nair 2012) need distances through crossings and are not measured.
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
    double length = 0;       ///< of all lines, in units of the region
    double least = 0;        ///< the least distance of two points
    double mean_nearest = 0; ///< the mean nearest-neighbour distance
    /// along lines, in rising order; closed lines that have a point add the gap around their end
    std::vector<double> gaps{};
};

/// Measures at least two points, in the region's plane. They may be off the lines by a millionth of the longest side of
/// the lines' box. Throws InputError that says how many points are farther away, and which is the first.
LineSet measure_line_set(const PlaneRegion& region, const PointSet& points);

/// Returns kind = "line-set", which measures a file of points.
Kind line_set_kind();

}
