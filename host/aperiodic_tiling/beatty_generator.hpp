// Tilings by Beatty sequences, made on a device: see tiles/aperiodic/beatty_tiling.hpp, which has the plain twin.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "kernels/common/tiles/beatty_tiling.h"
#include "tiles/aperiodic/beatty_tiling.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace poissonlab {

class BeattyGenerator
{
public:
    /// `work_group_size` 0: the default.
    BeattyGenerator(Device device, const BeattyTiling& tiling, std::size_t work_group_size = 0);

    /// The memory that stream() takes on any device for a window.
    static DeviceMemory memory(const TileWindow& window);

    /// Hands whole rows of a window to `sink`, from north to south: positions in the set, west to east. Throws
    /// InputError for windows beyond the limits and of 2^31 columns or more, Interrupted, and std::logic_error for a
    /// tile that the set does not have.
    void stream(const TileWindow& window, const std::function<void(std::span<const std::uint8_t> tiles)>& sink);

private:
    struct Buffers
    {
        Buffer<std::uint8_t> table;
        Buffer<contract::beatty_tiling::Row> rows;
        Buffer<std::uint8_t> tiles;

        NeededBuffers needed(std::size_t width, std::size_t piece_rows);
    };

    Device device_;
    BeattyTiling tiling_;
    std::size_t work_group_size_;
    Kernel make_tiles_;
    Buffers buffers_;
};

}
