// What dart throwing keeps on the device.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/region_buffers.hpp"

#include <cstdint>

namespace poissonlab {

struct DartBuffers
{
    using Words = Buffer<std::uint32_t>;

    Words thresholds;              ///< of the batch at hand
    Words masks, positions, slots; ///< a level 0 cell each
    Words parents, open;           ///< open cells before and after a batch
    Words darts, states, next;     ///< a dart of the batch each
    Words points, counters;
    LandBuffers land;

    // Only grids of bricks need these.
    Words brick_corners, bricks_around;
    Buffer<std::uint64_t> accepted_bits, waiting_bits; ///< a brick each, where darts are settled in order

    // Only darts that are settled in order need these.
    Words accepted;             ///< a bit of a level 0 cell each
    Words buckets;              ///< an interval of time of a slab each
    Buffer<std::uint64_t> keys; ///< a dart of a slab each

    // Only darts that are settled in rounds need these.
    Words next_states, rivals; ///< a dart of the batch each
};

}
