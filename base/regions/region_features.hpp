// Which feature of a region's file points lie in.
#pragma once

#include "base/regions/region_source.hpp"

namespace poissonlab {

/// For each point of the plane the RegionFeature::id of the first feature that it lies in; null where it lies in none.
std::vector<std::string> ids_of_features(const std::vector<RegionFeature>& features, const PointSet& points);

}
