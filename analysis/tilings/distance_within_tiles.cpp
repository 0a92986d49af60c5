#include "analysis/tilings/distance_within_tiles.hpp"

#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace poissonlab {
namespace {

/// Rounding may have moved a point at a tile's lower border out of it.
constexpr double rounding_of_borders = 0x1p-17; // in tiles

/// A coordinate between those of a tile's borders: what was rounded to the torus' end belongs to its beginning.
double unrounded(double coordinate, int tiles)
{
    return coordinate * tiles + rounding_of_borders < tiles ? coordinate : coordinate - 1;
}

/// A point on its way along the first axis of its tile.
struct SweptPoint
{
    std::uint64_t tile = 0;
    std::array<double, 3> place{};

    auto operator<=>(const SweptPoint&) const = default;
};

SweptPoint swept_point(std::span<const double> point, int tiles)
{
    SweptPoint swept;
    for (std::size_t k = 0; k < point.size(); ++k) {
        swept.place[k] = unrounded(point[k], tiles);
        const auto along = static_cast<std::uint64_t>(swept.place[k] * tiles + rounding_of_borders);
        swept.tile = swept.tile * static_cast<std::uint64_t>(tiles) + along;
    }
    return swept;
}

double squared_offset(const SweptPoint& a, const SweptPoint& b)
{
    double squared = 0;
    for (std::size_t k = 0; k < a.place.size(); ++k) squared += (b.place[k] - a.place[k]) * (b.place[k] - a.place[k]);
    return squared;
}

}

double min_distance_within_tiles(const PointSet& points, int tiles)
{
    std::vector<SweptPoint> swept;
    swept.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) swept.push_back(swept_point(points[i], tiles));
    std::ranges::sort(swept);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < swept.size(); ++i)
        for (std::size_t j = i + 1; j < swept.size() && swept[j].tile == swept[i].tile; ++j) {
            const double ahead = swept[j].place[0] - swept[i].place[0];
            if (ahead * ahead >= least) break;
            least = std::min(least, squared_offset(swept[i], swept[j]));
        }
    return std::sqrt(least);
}

double min_distance_within_tiles(const PointStrips& points, int tiles)
{
    double least = std::numeric_limits<double>::infinity();
    for (int row = 0; row < tiles; ++row) {
        stop_if_interrupted();
        const double low = row / static_cast<double>(tiles) - rounding_of_borders;
        const double high = (row + 1) / static_cast<double>(tiles) + rounding_of_borders;
        PointSet part{points.dimension(), {}};
        for (std::size_t strip = 0; strip < points.count(); ++strip) {
            const double begin = points.begin_of(strip), end = points.begin_of(strip + 1);
            const bool is_rounded = end > 1 + low; // of the last strip, some points belong to the first row
            if ((end < low || begin > high) && !is_rounded) continue;
            const PointSet more = points.strip(strip);
            part.coordinates.insert(part.coordinates.end(), more.coordinates.begin(), more.coordinates.end());
        }
        least = std::min(least, min_distance_within_tiles(part, tiles));
    }
    return least;
}

}
