// The picture of points in a region of space.
#pragma once

#include "host/distribution/regions/region_darts.hpp"
#include "results/pictures/mark_picture.hpp"

namespace poissonlab {

/// Seen from in front and above, z up, without perspective, in the box around the region: balls of a third of the
/// distance, those behind first and lighter.
MarkPicture space_picture(const RegionDarts& darts);

}
