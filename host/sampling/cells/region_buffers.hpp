// Regions in whole numbers on a device, as kernels/common/regions/region.clh reads them.
#pragma once

#include "base/regions/fixed_region.hpp"
#include "base/regions/fixed_space.hpp"
#include "host/device/needed_buffers.hpp"
#include "kernels/common/regions/region_grid.h"
#include "kernels/common/regions/space_grid.h"

#include <cstdint>

namespace poissonlab {

/// The buffers of a region of the plane.
struct RegionBuffers
{
    Buffer<std::uint32_t> cells, edges, filled;

    NeededBuffers needed(const FixedRegion& region);
    void write(const FixedRegion& region);
};

contract::regions::RegionGrid region_grid(const FixedRegion& region);

/// The buffers of a region of space: boxes and balls have no lattice, and buffers of one element.
struct SpaceBuffers
{
    Buffer<std::int32_t> values;
    Buffer<std::uint32_t> filled;

    NeededBuffers needed(const FixedSpace& space);
    void write(const FixedSpace& space);
};

contract::spaces::SpaceGrid space_grid(const FixedSpace& space);

/// The buffers of a request whose points lie in `region`, of the plane, or in `space`, or anywhere where it has
/// neither.
struct LandBuffers
{
    RegionBuffers region;
    SpaceBuffers space;

    template <typename Request>
    NeededBuffers needed(const Request& request)
    {
        if (request.region) return region.needed(*request.region);
        return request.space ? space.needed(*request.space) : NeededBuffers{};
    }

    template <typename Request>
    void write(const Request& request)
    {
        if (request.region) region.write(*request.region);
        if (request.space) space.write(*request.space);
    }

    /// Calls run() with the arguments that kernels take for it.
    template <typename Request, typename Run>
    void run_with(const Request& request, const Run& run) const
    {
        if (request.region)
            run(region_grid(*request.region), region.cells, region.edges, region.filled);
        else if (request.space)
            run(space_grid(*request.space), space.values, space.filled);
        else
            run();
    }
};

/// Do its points lie in either?
template <typename Request>
bool has_land(const Request& request)
{
    return request.region || request.space;
}

}
