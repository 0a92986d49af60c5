// The picture of points in a region: its outlines and holes as lines, points as disks.
#pragma once

#include "analysis/regions/framed_region.hpp"
#include "results/pictures/mark_picture.hpp"

namespace poissonlab {

/// Draws points in the frame; of more than some 100,000 the first ones.
MarkPicture region_picture_of(const FramedRegion& region, const PointSet& points);

}
