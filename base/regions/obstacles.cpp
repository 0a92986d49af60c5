#include "base/regions/obstacles.hpp"

#include <algorithm>
#include <optional>

namespace poissonlab {
namespace {

using Line = std::array<double, 4>;

/// The part of a line that lies in the box. Liang and Barsky 1984.
std::optional<Line> clipped(const Line& line, const RegionBox& box)
{
    double first = 0, last = 1;
    for (std::size_t k = 0; k < 2; ++k) {
        const double along = line[k + 2] - line[k], low = box.low[k] - line[k], high = box.high[k] - line[k];
        if (along == 0) {
            if (low > 0 || high < 0) return {};
            continue;
        }
        first = std::max(first, std::min(low / along, high / along));
        last = std::min(last, std::max(low / along, high / along));
    }
    if (first > last) return {};
    Line part = line;
    for (std::size_t k = 0; k < 2; ++k) {
        const double along = line[k + 2] - line[k];
        if (first > 0) part[k] = std::clamp(line[k] + first * along, box.low[k], box.high[k]);
        if (last < 1) part[k + 2] = std::clamp(line[k] + last * along, box.low[k], box.high[k]);
    }
    return part;
}

}

std::vector<Line> lines_within(const Obstacles& obstacles, const RegionBox& box)
{
    std::vector<Line> lines;
    const auto add = [&](const std::array<double, 2>& from, const std::array<double, 2>& to) {
        if (const auto part = clipped({from[0], from[1], to[0], to[1]}, box)) lines.push_back(*part);
    };
    const auto add_ring = [&](const RegionRing& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
    };
    for (const RegionRing& line : obstacles.lines)
        for (std::size_t i = 0; i + 1 < line.size(); ++i) add(line[i], line[i + 1]);
    for (const RegionPolygon& polygon : obstacles.polygons) {
        add_ring(polygon.outline);
        for (const RegionRing& hole : polygon.holes) add_ring(hole);
    }
    return lines;
}

std::vector<std::array<double, 2>> points_within(const Obstacles& obstacles, const RegionBox& box)
{
    std::vector<std::array<double, 2>> points;
    for (const auto& point : obstacles.points)
        if (box.low[0] <= point[0] && point[0] <= box.high[0] && box.low[1] <= point[1] && point[1] <= box.high[1])
            points.push_back(point);
    return points;
}

}
