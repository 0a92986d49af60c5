// Pictures of points in regions.
#pragma once

#include "host/distribution/regions/region_darts.hpp"
#include "results/pictures/curve_chart.hpp"
#include "results/pictures/mark_picture.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The region's outlines and holes as lines, obstacles beside them, and points as disks of a third of their distance.
/// Where the distance varies, disks of half of it in colours, the darker the smaller, with dots in the middle and a bar
/// of the colours.
MarkPicture dart_picture(const RegionDarts& darts);

/// Points of one colour in a region, in its units.
struct LandDots
{
    std::string color;
    PointSet points;
    double radius = 0;
};

/// Draws the region in a box: its outlines, its dots, the first group lowest, and its obstacles, whose points are as
/// large as the first dots.
MarkPicture land_picture(const RegionLand& land, const RegionBox& box, const std::vector<LandDots>& dots);

/// The distance of nearest points over what they are to keep: the share of points, as a density.
CurveChart nearest_chart(const VariedSet& set);

}
