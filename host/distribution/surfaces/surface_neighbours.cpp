#include "host/distribution/surfaces/surface_neighbours.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

constexpr std::uint64_t no_distance = std::numeric_limits<std::uint64_t>::max();

/// Bits of a cell's number along an axis.
constexpr int cell_bits = 21;

double length_of(std::uint64_t squared, const FixedSurface& surface)
{
    return squared == no_distance ? INFINITY : std::sqrt(static_cast<double>(squared)) * surface.unit;
}

double mean_of_finite(const std::vector<std::uint64_t>& squared, const FixedSurface& surface)
{
    double sum = 0;
    std::size_t count = 0;
    for (const std::uint64_t s : squared)
        if (s != no_distance) {
            sum += length_of(s, surface);
            ++count;
        }
    return count == 0 ? INFINITY : sum / static_cast<double>(count);
}

}

SurfaceNeighbours::SurfaceNeighbours(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                     std::uint64_t reach)
    : surface_(surface), points_(points),
      reach_(std::max<std::int64_t>(static_cast<std::int64_t>(reach),
                                    std::int64_t{1} << (contract::surface::COORDINATE_BITS + 2 - cell_bits)))
{
    std::vector<std::uint64_t> keys;
    for (const SurfacePoint& p : points)
        keys.push_back(key_of(p.place[0] / reach_, p.place[1] / reach_, p.place[2] / reach_));
    order_.resize(points.size());
    std::iota(order_.begin(), order_.end(), 0u);
    std::ranges::sort(order_,
                      [&](std::uint32_t a, std::uint32_t b) { return keys[a] != keys[b] ? keys[a] < keys[b] : a < b; });
    for (const std::uint32_t i : order_) keys_.push_back(keys[i]);
}

/// Cells count from 1, so that there is one below each.
std::uint64_t SurfaceNeighbours::key_of(std::int64_t x, std::int64_t y, std::int64_t z) const
{
    return (static_cast<std::uint64_t>(z + 1) << 2 * cell_bits) | (static_cast<std::uint64_t>(y + 1) << cell_bits) |
           static_cast<std::uint64_t>(x + 1);
}

/// Calls visit(number of a point) for all points in the 27 cells around a place.
template <typename Visit>
void SurfaceNeighbours::for_each_around(const MeshPlace& place, const Visit& visit) const
{
    const std::int64_t x = place[0] / reach_;
    for (std::int64_t z = place[2] / reach_ - 1; z <= place[2] / reach_ + 1; ++z)
        for (std::int64_t y = place[1] / reach_ - 1; y <= place[1] / reach_ + 1; ++y) {
            const std::uint64_t last = key_of(x + 1, y, z);
            auto i = static_cast<std::size_t>(std::ranges::lower_bound(keys_, key_of(x - 1, y, z)) - keys_.begin());
            for (; i < keys_.size() && keys_[i] <= last; ++i) visit(order_[i]);
        }
}

std::uint64_t SurfaceNeighbours::squared_nearest(std::size_t own, std::int32_t least_cosine) const
{
    const SurfacePoint& point = points_[own];
    const SurfaceTriangle& triangle = surface_.triangles[point.triangle];
    std::uint64_t least = no_distance;
    const auto look_at = [&](std::size_t other) {
        if (other == own || cosine_between(triangle, surface_.triangles[points_[other].triangle]) < least_cosine)
            return;
        least = std::min(least, squared_distance(place_of(point), place_of(points_[other])));
    };
    for_each_around(place_of(point), look_at);
    // A nearest point beyond the reach may have a nearer rival outside these cells; few points are so lonely.
    if (least > static_cast<std::uint64_t>(reach_) * static_cast<std::uint64_t>(reach_))
        for (std::size_t other = 0; other < points_.size(); ++other) look_at(other);
    return least;
}

bool SurfaceNeighbours::is_near(const SurfacePoint& place, std::uint64_t squared, std::int32_t least_cosine) const
{
    const SurfaceTriangle& triangle = surface_.triangles[place.triangle];
    bool is_found = false;
    for_each_around(place_of(place), [&](std::size_t i) {
        is_found = is_found || (squared_distance(place_of(place), place_of(points_[i])) < squared &&
                                cosine_between(triangle, surface_.triangles[points_[i].triangle]) >= least_cosine);
    });
    return is_found;
}

SurfaceDistances surface_distances(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                   std::int32_t least_cosine)
{
    const double spacing = std::sqrt(2 / std::numbers::sqrt3 * surface.area / static_cast<double>(points.size()));
    const SurfaceNeighbours near(surface, points, static_cast<std::uint64_t>(1.1 * surface.units_of(spacing)) + 1);
    std::vector<std::uint64_t> seen(points.size()), any(points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, points.size()), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            seen[i] = near.squared_nearest(i, least_cosine);
            any[i] = near.squared_nearest(i, std::numeric_limits<std::int32_t>::min());
        }
    });
    return {length_of(std::ranges::min(seen), surface), length_of(std::ranges::min(any), surface),
            mean_of_finite(seen, surface)};
}

}
