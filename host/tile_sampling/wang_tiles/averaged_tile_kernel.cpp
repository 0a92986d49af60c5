#include "host/tile_sampling/wang_tiles/averaged_tiles.hpp"

#include "base/random/random.hpp"
#include "kernels/common/tile_sampling/averaged_tiles.h"
#include "tiles/poisson/tile_regions.hpp"

#include <algorithm>
#include <vector>

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

using contract::averaged_tiles::CentroidShift;

static_assert(contract::averaged_tiles::TILES == wang_point_tiles &&
              contract::averaged_tiles::TILE_UNITS == tile_units);

struct AveragedTileBuffers
{
    Buffer<WangPoint> points;
    Buffer<std::uint32_t> beside, between, surrounding;
    Buffer<CentroidShift> displacements;

    NeededBuffers needed(std::size_t points_per_tile)
    {
        using namespace contract::averaged_tiles;
        return {{points, TILES * points_per_tile},
                {beside, std::size_t{TILES} * SIDES * BESIDE},
                {between, std::size_t{QUADRANTS} * TILES * TILES * BETWEEN},
                {surrounding, SURROUNDING},
                {displacements, TILES * points_per_tile}};
    }
};

namespace {

/// The tiles that fit at the sides of each.
std::vector<std::uint32_t> all_tiles_beside()
{
    std::vector<std::uint32_t> all;
    for (std::size_t tile = 0; tile < wang_point_tiles; ++tile)
        for (const bool along_x : {true, false})
            for (const int sign : {-1, 1})
                for (const std::size_t other : tiles_beside(tile, along_x, sign))
                    all.push_back(static_cast<std::uint32_t>(other));
    return all;
}

/// The tiles that fit between two others in each quadrant.
std::vector<std::uint32_t> all_tiles_between()
{
    std::vector<std::uint32_t> all;
    for (const int y : {-1, 1})
        for (const int x : {-1, 1})
            for (std::size_t at_x = 0; at_x < wang_point_tiles; ++at_x)
                for (std::size_t at_y = 0; at_y < wang_point_tiles; ++at_y)
                    for (const std::size_t other : tiles_between(at_x, at_y, x, y))
                        all.push_back(static_cast<std::uint32_t>(other));
    return all;
}

KernelProgram averaged_program() { return kernel_program("averaged_tiles.cl", {}); }

}

AveragedTiles::AveragedTiles(Device device, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<AveragedTileBuffers>())
{}

DeviceMemory AveragedTiles::memory(std::size_t points_per_tile)
{
    return memory_of(AveragedTileBuffers{}.needed(points_per_tile));
}

WangPoints AveragedTiles::average_once(const WangPoints& points, AveragedVariant variant, std::uint32_t iteration,
                                       std::uint64_t seed)
{
    reserve(device_, buffers_->needed(points.tiles[0].size()));
    for (std::size_t tile = 0; tile < wang_point_tiles; ++tile)
        buffers_->points.write(points.tiles[tile], tile * points.tiles[tile].size());
    return variant == AveragedVariant::exact ? average_over_all(points) : average_in_one(points, iteration, seed);
}

/// Points whose cells depend on more than a quadrant are left to the twin.
WangPoints AveragedTiles::average_over_all(const WangPoints& points)
{
    const std::size_t count = points.tiles[0].size();
    buffers_->beside.write(all_tiles_beside());
    buffers_->between.write(all_tiles_between());
    device_.kernel(averaged_program(), "average_over_quadrants")
        .run(wang_point_tiles * count, work_group_size_, static_cast<std::uint32_t>(count), buffers_->points,
             buffers_->beside, buffers_->between, buffers_->displacements);
    const auto displacements = buffers_->displacements.read(0, wang_point_tiles * count);
    return moved_tiles(points, [&](std::size_t tile, std::size_t i) -> WangPoint {
        const CentroidShift& found = displacements[tile * count + i];
        if (!found.is_known) return mean_displacement(points, tile, i);
        return {found.x, found.y};
    });
}

/// Tile after tile, as each sees the tiles before it where they have moved to.
WangPoints AveragedTiles::average_in_one(const WangPoints& points, std::uint32_t iteration, std::uint64_t seed)
{
    const std::size_t count = points.tiles[0].size();
    Kernel find = device_.kernel(averaged_program(), "find_in_surrounding");
    WangPoints result = points;
    for (std::size_t tile = 0; tile < wang_point_tiles; ++tile) {
        const auto around = random_surrounding(tile, iteration, seed);
        buffers_->surrounding.write(std::vector<std::uint32_t>(around.begin(), around.end()));
        find.run(count, work_group_size_, static_cast<std::uint32_t>(count), buffers_->points, buffers_->surrounding,
                 buffers_->displacements);
        const auto displacements = buffers_->displacements.read(0, count);
        const WangPoints before = result;
        for (std::size_t i = 0; i < count; ++i) {
            const CentroidShift& found = displacements[i];
            result.tiles[tile][i] =
                moved_in_tile(before.tiles[tile][i],
                              found.is_known ? WangPoint{found.x, found.y} : centroid_displacement(before, around, i));
        }
        buffers_->points.write(result.tiles[tile], tile * count);
    }
    return result;
}

}
