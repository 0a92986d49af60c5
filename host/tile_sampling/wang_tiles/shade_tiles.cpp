#include "host/tile_sampling/wang_tiles/shade_tiles.hpp"

#include "base/random/random.hpp"
#include "tiles/poisson/tile_regions.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

/// The nearer points of a tile are looked at only: those that are less than the distance away along both axes.
bool is_too_near(const std::vector<WangPoint>& points, const WangPoint& dart, int x, int y,
                 std::int64_t squared_distance)
{
    return std::ranges::any_of(points, [&](const WangPoint& point) {
        const std::int64_t dx = point[0] + x * tile_units - dart[0], dy = point[1] + y * tile_units - dart[1];
        return dx * dx + dy * dy < squared_distance;
    });
}

bool fits(const WangPoints& points, std::size_t tile, const WangPoint& dart, std::int64_t squared_distance)
{
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            for (std::size_t other = 0; other < wang_point_tiles; ++other) {
                const bool meets = x == 0 && y == 0 ? other == tile : may_lie_beside(tile, other, x, y);
                if (meets && is_too_near(points.tiles[other], dart, x, y, squared_distance)) return false;
            }
    return true;
}

/// A dart's own tile lies beside itself as well, where its colours allow that.
bool meets_itself(std::size_t tile, std::int64_t squared_distance)
{
    constexpr std::int64_t side = tile_units;
    const bool beside = may_lie_beside(tile, tile, 1, 0) || may_lie_beside(tile, tile, 0, 1);
    return squared_distance > (beside ? side * side : 2 * side * side);
}

}

WangPoints throw_shade_tiles(std::uint64_t squared_distance, std::uint32_t attempts, std::uint64_t seed)
{
    const StreamKey stream = stream_key(seed, Purpose::wang_darts, 0);
    const auto squared = static_cast<std::int64_t>(squared_distance);
    WangPoints points;
    std::uint32_t failures = 0;
    for (std::uint64_t i = 0; failures < attempts; ++i) {
        const auto words = philox({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i >> 32), 0, 0}, stream);
        const std::size_t tile = words[0] % wang_point_tiles;
        const WangPoint dart{static_cast<std::int32_t>(words[1] >> 16), static_cast<std::int32_t>(words[2] >> 16)};
        if (meets_itself(tile, squared) || !fits(points, tile, dart, squared)) {
            ++failures;
            continue;
        }
        failures = 0;
        points.tiles[tile].push_back(dart);
    }
    return points;
}

}
