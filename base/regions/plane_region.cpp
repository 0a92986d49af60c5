#include "base/regions/plane_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
RegionBox box_of(const PlaneRegion& region)
{
    constexpr double most = std::numeric_limits<double>::max();
    RegionBox box{{most, most}, {-most, -most}};
    for (const RegionPolygon& polygon : region.polygons)
        for (const auto& corner : polygon.outline)
            for (std::size_t k = 0; k < 2; ++k) {
                box.low[k] = std::min(box.low[k], corner[k]);
                box.high[k] = std::max(box.high[k], corner[k]);
            }
    return box;
}

/// Corners are counted from the first one, so that large coordinates cost no digits.
double signed_area_of(const RegionRing& ring)
{
    double twice = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
        twice += (ring[i][0] - ring[0][0]) * (ring[i + 1][1] - ring[0][1]) -
                 (ring[i + 1][0] - ring[0][0]) * (ring[i][1] - ring[0][1]);
    return twice / 2;
}

double area_of(const PlaneRegion& region)
{
    double area = 0;
    for (const RegionPolygon& polygon : region.polygons) {
        area += std::abs(signed_area_of(polygon.outline));
        for (const RegionRing& hole : polygon.holes) area -= std::abs(signed_area_of(hole));
    }
    return area;
}

std::size_t corner_count(const PlaneRegion& region)
{
    std::size_t count = 0;
    for (const RegionPolygon& polygon : region.polygons) {
        count += polygon.outline.size();
        for (const RegionRing& hole : polygon.holes) count += hole.size();
    }
    return count;
}

double distance_rounding(double distance, const RegionBox& box)
{
    double largest = 0;
    for (std::size_t k = 0; k < 2; ++k) largest = std::max({largest, std::abs(box.low[k]), std::abs(box.high[k])});
    return 4 * largest * std::numeric_limits<double>::epsilon() + distance * 0x1p-50;
}

}
