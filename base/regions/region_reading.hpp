// Options for reading a region, beyond what its text or file says itself.
#pragma once

#include "base/word_table.hpp"

#include <string>

namespace poissonlab {

/// Polygons of a layer that overlap or share edges become one, or are refused.
enum class PolygonOverlap
{
    unite,
    refuse
};

inline constexpr WordTable<PolygonOverlap, 2> polygon_overlap_names{
    {{{PolygonOverlap::unite, "union"}, {PolygonOverlap::refuse, "refuse"}}}};

struct RegionReading
{
    bool is_planar = false; ///< coordinates are lengths, whatever they look like and whatever the file says
    std::string crs{};      ///< the system of its coordinates as PROJ knows it, EPSG:31370; empty: what the file says
    PolygonOverlap overlap = PolygonOverlap::unite;
    bool is_along = false; ///< the region is its lines and outlines, instead of what these go around
    double buffer = 0;     ///< by which lines, points and polygons are grown, in units of the plane; 0: not at all
};

}
