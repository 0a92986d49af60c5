// A region in whole numbers on a device, as kernels/common/regions/inside_region.clh reads it.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "host/device/needed_buffers.hpp"
#include "kernels/common/regions/region_grid.h"

#include <cstdint>

namespace poissonlab {

struct RegionBuffers
{
    Buffer<std::uint32_t> cells, edges, filled;

    NeededBuffers needed(const FixedRegion& region);
    void write(const FixedRegion& region);
};

contract::regions::RegionGrid region_grid(const FixedRegion& region);

}
