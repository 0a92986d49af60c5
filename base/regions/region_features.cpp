#include "base/regions/region_features.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

using FeaturePlace = std::array<double, 2>;

/// Counts the edges that lie right of the place.
bool is_within(const RegionRing& ring, const FeaturePlace& place)
{
    bool is_inside = false;
    for (std::size_t i = 0, before = ring.size() - 1; i < ring.size(); before = i++) {
        const FeaturePlace &a = ring[before], &b = ring[i];
        if ((a[1] > place[1]) == (b[1] > place[1])) continue;
        if (place[0] < a[0] + (place[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) is_inside = !is_inside;
    }
    return is_inside;
}

bool is_within(const RegionPolygon& polygon, const FeaturePlace& place)
{
    return is_within(polygon.outline, place) &&
           std::ranges::none_of(polygon.holes, [&](const RegionRing& hole) { return is_within(hole, place); });
}

bool is_within(const RegionBox& box, const FeaturePlace& place)
{
    return box.low[0] <= place[0] && place[0] <= box.high[0] && box.low[1] <= place[1] && place[1] <= box.high[1];
}

}

std::vector<std::string> ids_of_features(const std::vector<RegionFeature>& features, const PointSet& points)
{
    std::vector<RegionBox> boxes;
    for (const RegionFeature& feature : features) boxes.push_back(box_of({feature.polygons}));
    std::vector<std::string> ids(points.size(), "null");
    for (std::size_t i = 0; i < points.size(); ++i) {
        const FeaturePlace place{points[i][0], points[i][1]};
        for (std::size_t f = 0; f < features.size() && ids[i] == "null"; ++f)
            if (is_within(boxes[f], place) && std::ranges::any_of(features[f].polygons, [&](const auto& polygon) {
                    return is_within(polygon, place);
                }))
                ids[i] = features[f].id;
    }
    return ids;
}

}
