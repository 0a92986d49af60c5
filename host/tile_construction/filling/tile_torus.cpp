#include "host/tile_construction/filling/tile_torus.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>

namespace poissonlab {
namespace {

/// A position relative to the nearest lattice point.
struct Folded
{
    std::array<std::int32_t, 3> distance{};
    std::array<std::int32_t, 3> side{}; ///< 1 or -1
};

Folded folded_at(const TilePosition& position, int dimension)
{
    Folded folded;
    for (int k = 0; k < dimension; ++k) {
        const std::int32_t in_tile = position[k] & (tile_units - 1);
        const bool is_upper = in_tile > tile_units - in_tile;
        folded.distance[k] = is_upper ? tile_units - in_tile : in_tile;
        folded.side[k] = is_upper ? -1 : 1;
    }
    return folded;
}

/// The shortest way out of a region so far, as a distance along each axis.
struct WayOut
{
    TilePosition along{};
    std::int64_t squared = std::numeric_limits<std::int64_t>::max();

    /// A way along these axes, whose distances lack `lacking` in sum.
    void consider(std::int32_t lacking, std::initializer_list<int> axes)
    {
        const auto count = static_cast<std::int32_t>(axes.size());
        const std::int32_t each = (lacking + count - 1) / count;
        const std::int64_t length = std::int64_t{count} * each * each;
        if (length >= squared) return;
        squared = length;
        along = {};
        for (const int axis : axes) along[axis] = each;
    }
};

void leave_pair(WayOut& way, const TileRegions& regions, const TilePosition& distance, int i, int j)
{
    way.consider(regions.pair_one - distance[i], {i});
    way.consider(regions.pair_one - distance[j], {j});
    way.consider(regions.pair_sum - distance[i] - distance[j], {i, j});
}

void leave_corner_3d(WayOut& way, const TileRegions& regions, const TilePosition& distance)
{
    std::array<int, 3> axes{0, 1, 2};
    std::ranges::stable_sort(axes, [&](int a, int b) { return distance[a] > distance[b]; });
    const std::int32_t two = distance[axes[0]] + distance[axes[1]];
    way.consider(regions.corner_one - distance[axes[0]], {axes[0]});
    way.consider(regions.corner_two - two, {axes[0], axes[1]});
    way.consider(regions.corner_three - two - distance[axes[2]], {axes[0], axes[1], axes[2]});
}

/// Coordinates around the middle of the tile at (0, 0), where a polygon around it does not meet itself.
TilePosition around_middle(const TilePosition& position)
{
    return {shortest(position[0] - tile_units / 2), shortest(position[1] - tile_units / 2), 0};
}

/// A position is inside where a ray to the left meets the polygon an odd number of times.
bool is_inside(std::span<const TilePosition> polygon, const TilePosition& position)
{
    const TilePosition p = around_middle(position);
    bool result = false;
    TilePosition a = around_middle(polygon.back());
    for (const TilePosition& corner : polygon) {
        const TilePosition b = around_middle(corner);
        if ((a[1] > p[1]) != (b[1] > p[1])) {
            const std::int64_t turn =
                std::int64_t{b[0] - a[0]} * (p[1] - a[1]) - std::int64_t{b[1] - a[1]} * (p[0] - a[0]);
            if ((turn > 0) == (b[1] > a[1])) result = !result;
        }
        a = b;
    }
    return result;
}

}

std::uint64_t squared_distance(const TilePosition& a, const TilePosition& b, int dimension)
{
    std::uint64_t sum = 0;
    for (int k = 0; k < dimension; ++k) {
        const std::int64_t difference = shortest(a[k] - b[k]);
        sum += static_cast<std::uint64_t>(difference * difference);
    }
    return sum;
}

unsigned cell_at(const TileRegions& regions, const TilePosition& position)
{
    const Folded folded = folded_at(position, regions.dimension);
    const unsigned axes = regions.axes_at(folded.distance);
    unsigned base = 0;
    for (int k = 0; k < regions.dimension; ++k) {
        const auto tile = static_cast<unsigned>(position[k] >> tile_bits);
        const unsigned nearest = (tile + (folded.side[k] < 0)) & 1;
        base |= (axes >> k & 1 ? tile : nearest) << k;
    }
    return cell_number(axes, base, regions.dimension);
}

bool is_allowed(const Zone& zone, const TilePosition& position)
{
    if (zone.polygon.empty()) return zone.cells >> cell_at(zone.regions, position) & 1;
    return is_inside(zone.polygon, position);
}

TilePosition pushed_out(const TileRegions& regions, const TilePosition& position)
{
    const int dimension = regions.dimension;
    const Folded folded = folded_at(position, dimension);
    const unsigned axes = regions.axes_at(folded.distance);
    if (axes == all_axes(dimension)) return position;
    WayOut way;
    const auto extent = std::popcount(axes);
    if (dimension - extent == 1) {
        const int across = std::countr_zero(all_axes(dimension) & ~axes);
        way.consider(regions.width - folded.distance[across], {across});
    } else if (dimension - extent == 2) {
        const int along = dimension == 3 ? std::countr_zero(axes) : 2;
        leave_pair(way, regions, folded.distance, (along + 1) % 3, (along + 2) % 3);
    } else {
        leave_corner_3d(way, regions, folded.distance);
    }
    TilePosition result = position;
    for (int k = 0; k < dimension; ++k) result[k] = wrapped(position[k] + folded.side[k] * way.along[k]);
    return result;
}

TilePosition limited_movement(const std::array<double, 3>& sum, double limit, int dimension)
{
    const auto axes = static_cast<std::size_t>(dimension);
    double squared = 0;
    for (std::size_t k = 0; k < axes; ++k) squared += sum[k] * sum[k];
    const double length = std::sqrt(squared);
    const double scale = length > limit ? limit / length : 1;
    TilePosition movement{};
    for (std::size_t k = 0; k < axes; ++k) movement[k] = static_cast<std::int32_t>(std::nearbyint(scale * sum[k]));
    return movement;
}

TilePosition allowed_end(const Zone& zone, const TilePosition& start, const TilePosition& movement, bool slides)
{
    const auto moved = [&](std::int32_t part) { // in 4,096ths
        TilePosition end = start;
        for (int k = 0; k < zone.regions.dimension; ++k) end[k] = wrapped(start[k] + (movement[k] * part >> 12));
        return end;
    };
    const auto is_end = [&](const TilePosition& position) {
        for (int k = 0; k < zone.regions.dimension && zone.keeps_tiles; ++k)
            if ((start[k] ^ position[k]) >> tile_bits) return false;
        return is_allowed(zone, position);
    };
    TilePosition end = moved(4096);
    if (is_end(end)) return end;
    if (slides && zone.polygon.empty()) {
        for (int i = 0; i < 3; ++i) {
            end = pushed_out(zone.regions, end);
            if (is_end(end)) return end;
        }
    }
    std::int32_t part = 0;
    for (std::int32_t step = 2048; step > 0; step >>= 1) {
        if (is_end(moved(part + step))) part += step;
    }
    return moved(part);
}

}
