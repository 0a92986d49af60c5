// Averaged tiles on a device, by kernels/averaged_tiles.cl: those of average_once(), bit for bit.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "host/sampling/device_method.hpp"
#include "host/tile_sampling/wang_tiles/averaged_tiles.hpp"
#include "host/tile_sampling/wang_tiles/wang_points.hpp"

#include <cstddef>
#include <cstdint>

namespace poissonlab {

// Wang tiles by dart throwing against every tile that may lie beside.
//
// Shade, Cohen and Mitchell, Tiling layered depth images, 2000; Lagae, Tile-Based Methods in Computer Graphics, 2007,
// section 6.6: near an edge a dart meets the points of four tiles, near a corner those of all, so that few fit there.

/// Darts into random tiles until so many in a row have failed. `squared_distance` in units; shorter than half a tile.
WangPoints throw_shade_tiles(std::uint64_t squared_distance, std::uint32_t attempts, std::uint64_t seed);

class AveragedTiles : DeviceMethod<struct AveragedTileBuffers>
{
public:
    /// `work_group_size` 0: the default.
    explicit AveragedTiles(Device device, std::size_t work_group_size = 0);

    /// One iteration, as average_once(). All tiles have equally many points.
    WangPoints average_once(const WangPoints& points, AveragedVariant variant, std::uint32_t iteration,
                            std::uint64_t seed);

    /// The memory that tiles of so many points take.
    static DeviceMemory memory(std::size_t points_per_tile);

private:
    WangPoints average_over_all(const WangPoints& points);
    WangPoints average_in_one(const WangPoints& points, std::uint32_t iteration, std::uint64_t seed);
};

}
