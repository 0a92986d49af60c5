#include "host/distribution/surfaces/surface_neighbours.hpp"

#include "base/geometry/torus.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
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
    // A point beyond the reach may have a nearer rival outside these cells.
    return least > static_cast<std::uint64_t>(reach_) * static_cast<std::uint64_t>(reach_) ? no_distance : least;
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

namespace {

/// Fewer points than these look at all others where they see none.
constexpr std::size_t few_points = 10'000;

/// The squared distance of each point to the nearest one that it sees. Those that see none in reach look four times as
/// far, twice; few points look at all others then, of many they are said to see none.
std::vector<std::uint64_t> squared_nearest_of_all(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                                  std::int32_t least_cosine, double area)
{
    constexpr std::uint64_t all = std::uint64_t{1} << (contract::surface::COORDINATE_BITS + 1);
    const double spacing = std::sqrt(2 / std::numbers::sqrt3 * area / static_cast<double>(points.size()));
    std::vector<std::uint64_t> squared(points.size(), no_distance);
    std::vector<std::uint32_t> lonely(points.size());
    std::iota(lonely.begin(), lonely.end(), 0u);
    const auto first = std::min(static_cast<std::uint64_t>(1.1 * surface.units_of(spacing)) + 1, all);
    for (const std::uint64_t reach : {first, std::min(4 * first, all), std::min(16 * first, all), all}) {
        if (lonely.empty() || (reach == all && points.size() > few_points)) break;
        const SurfaceNeighbours near(surface, points, reach);
        const std::vector<std::uint32_t>& asked = reach == first ? near.order() : lonely;
        tbb::parallel_for(std::size_t{0}, asked.size(),
                          [&](std::size_t i) { squared[asked[i]] = near.squared_nearest(asked[i], least_cosine); });
        std::erase_if(lonely, [&](std::uint32_t i) { return squared[i] != no_distance; });
    }
    return squared;
}

}

SurfaceDistances surface_distances(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                   std::int32_t least_cosine, double area)
{
    const auto seen = squared_nearest_of_all(surface, points, least_cosine, area);
    const auto any = squared_nearest_of_all(surface, points, std::numeric_limits<std::int32_t>::min(), area);
    return {length_of(std::ranges::min(seen), surface), length_of(std::ranges::min(any), surface),
            mean_of_finite(seen, surface)};
}

std::vector<bool> kept_in_order(const FixedSurface& surface, const std::vector<SurfacePoint>& points,
                                const std::vector<std::uint32_t>& order, double distance, std::int32_t least_cosine)
{
    const double units = surface.units_of(distance);
    const std::uint64_t squared = squared_threshold(units * 0x1p-32);
    const auto side = static_cast<std::int64_t>(units) + 1;
    // Cells have points that stay, which are few, however many there are.
    std::map<std::array<std::int64_t, 3>, std::vector<std::uint32_t>> cells;
    const auto is_near = [&](std::uint32_t i, std::uint32_t j) {
        return squared_distance(place_of(points[i]), place_of(points[j])) < squared &&
               cosine_between(surface.triangles[points[i].triangle], surface.triangles[points[j].triangle]) >=
                   least_cosine;
    };
    const auto is_free = [&](std::uint32_t i, const std::array<std::int64_t, 3>& cell) {
        for (std::int64_t x = cell[0] - 1; x <= cell[0] + 1; ++x)
            for (std::int64_t y = cell[1] - 1; y <= cell[1] + 1; ++y) {
                const auto end = cells.upper_bound({x, y, cell[2] + 1});
                for (auto near = cells.lower_bound({x, y, cell[2] - 1}); near != end; ++near)
                    if (std::ranges::any_of(near->second, [&](std::uint32_t j) { return is_near(i, j); })) return false;
            }
        return true;
    };
    std::vector<bool> kept(points.size(), false);
    for (const std::uint32_t i : order) {
        const MeshPlace place = place_of(points[i]);
        const std::array<std::int64_t, 3> cell{place[0] / side, place[1] / side, place[2] / side};
        kept[i] = is_free(i, cell);
        if (kept[i]) cells[cell].push_back(i);
    }
    return kept;
}

bool keep_distance(const FixedSurface& surface, const std::vector<SurfacePoint>& points, double distance,
                   std::int32_t least_cosine, std::size_t first)
{
    const double units = surface.units_of(distance) * (1 - 0x1p-50);
    const SurfaceNeighbours near(surface, points, static_cast<std::uint64_t>(units) + 1);
    std::vector<char> is_kept(points.size(), 1);
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t place) {
        const std::uint32_t i = near.order()[place];
        if (i < first) return;
        const std::uint64_t squared = near.squared_nearest(i, least_cosine);
        is_kept[i] = squared == no_distance || std::sqrt(static_cast<double>(squared)) >= units;
    });
    return std::ranges::all_of(is_kept, [](char kept) { return kept != 0; });
}

}
