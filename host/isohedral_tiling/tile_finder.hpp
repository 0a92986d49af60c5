// Which tile of an isohedral tiling places are in, on a device: see tiles/isohedral/tile_lookup.hpp, which has the
// plain twin.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "kernels/common/tile_finder.h"
#include "tiles/isohedral/tile_lookup.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace poissonlab {

class TileFinder
{
public:
    /// `work_group_size` 0: the default.
    TileFinder(Device device, const TileLookup& lookup, std::size_t work_group_size = 0);

    /// The memory that find() takes on any device for a number of places.
    DeviceMemory memory(std::size_t points);

    /// The tiles of all places. Throws InputError for 2^31 places or more.
    std::vector<FoundTile> find(std::span<const LatticePoint> points);

private:
    struct Buffers
    {
        Buffer<std::int64_t> points;
        Buffer<contract::tile_finder::Candidate> candidates;
        Buffer<std::int32_t> corners;
        Buffer<contract::tile_finder::FoundTile> found;

        NeededBuffers needed(std::size_t points_count, const TileLookup& lookup);
    };

    Device device_;
    TileLookup lookup_;
    std::size_t work_group_size_;
    Kernel find_tiles_;
    Buffers buffers_;
};

}
