// Numbers of points that the features of a region's file ask for, by their properties.
#pragma once

#include "base/regions/region_source.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// The properties of features that say how many points they have.
struct FeatureNumbers
{
    std::vector<std::string> points;    ///< of each class, the property with a number of points
    std::vector<std::string> densities; ///< or with points in a unit of area

    bool is_empty() const { return points.empty() && densities.empty(); }
    const std::vector<std::string>& names() const { return points.empty() ? densities : points; }
};

/// A feature in which points lie.
struct FeaturePart
{
    std::size_t number = 0; ///< among the features
    PlaneRegion region;     ///< the feature without obstacles
    std::vector<std::size_t> points;
};

/// Returns the features of a region that have points. Densities are multiplied by the area that obstacles leave, and
/// products rounded. Throws InputError, a line that begins with `file`, where the file has no features, a property is
/// missing or no such number, a feature with points has no polygon, features overlap, and where there are no points.
std::vector<FeaturePart> feature_parts(const FeatureNumbers& asked, const PlaneRegion& whole,
                                       const std::vector<RegionPolygon>& obstacles, const std::string& file);

}
