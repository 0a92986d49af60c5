#include "host/tile_sampling/wang_tiles/wang_points.hpp"

#include "tiles/poisson/tile_regions.hpp"
#include "tiles/tilings/tiling.hpp"

#include <algorithm>
#include <limits>

namespace poissonlab {
namespace {

constexpr WangColors two_colors{2, 2};

/// The smallest squared distance of points of a tile from those of another one, so many tiles away.
std::int64_t squared_between(const std::vector<WangPoint>& points, const std::vector<WangPoint>& others, int x, int y)
{
    std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
    for (const WangPoint& p : points)
        for (const WangPoint& q : others) {
            if (&p == &q && x == 0 && y == 0) continue;
            const std::int64_t dx = q[0] + x * tile_units - p[0], dy = q[1] + y * tile_units - p[1];
            smallest = std::min(smallest, dx * dx + dy * dy);
        }
    return smallest;
}

}

std::int64_t squared_distance_within(const WangPoints& points)
{
    std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
    for (const auto& tile : points.tiles) smallest = std::min(smallest, squared_between(tile, tile, 0, 0));
    return smallest;
}

std::int64_t squared_distance_across(const WangPoints& points)
{
    std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
    for (std::size_t tile = 0; tile < wang_point_tiles; ++tile)
        for (std::size_t other = 0; other < wang_point_tiles; ++other)
            for (const auto& [x, y] : {std::pair{1, 0}, std::pair{0, 1}, std::pair{1, 1}, std::pair{1, -1}})
                if (may_lie_beside(tile, other, x, y))
                    smallest = std::min(smallest, squared_between(points.tiles[tile], points.tiles[other], x, y));
    return smallest;
}

PointSet wang_torus(const WangPoints& points, std::uint64_t seed, std::uint32_t side)
{
    const Tiling tiling(DirectAlgorithm::wang_one_hash, two_colors, HashKind::xxh64, seed, {side, side, 0});
    PointSet set{2, {}};
    const double size = static_cast<double>(side) * tile_units;
    for (std::int64_t y = 0; y < side; ++y)
        for (std::int64_t x = 0; x < side; ++x)
            for (const WangPoint& point : points.tiles[even_wang_tile(wang_tile(tiling.tile(x, y), two_colors))])
                for (std::size_t k = 0; k < 2; ++k)
                    set.coordinates.push_back(static_cast<double>((k == 0 ? x : y) * tile_units + point[k]) / size);
    return set;
}

}
