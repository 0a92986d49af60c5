// Instances made on a device.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "host/distribution/instances/instances.hpp"

#include "kernels/common/fields/instances.h"

namespace poissonlab {

/// Places instances by kernels/instances.cl, bit for bit as the reference does. The tile set is copied to the device
/// once.
class InstancePlacer
{
public:
    /// `work_group_size` 0: the default. The tile set must outlive this.
    InstancePlacer(Device device, const ObjectTileSet& tiles, std::size_t work_group_size = 0);

    static DeviceMemory memory(const ObjectTileSet& tiles);

    /// The instances in the window and the ring, by rows of tiles; on the plane, z is 0. Throws Interrupted.
    std::vector<Instance> place(const PoissonTiling& tiling, const InstanceSettings& settings);

private:
    struct Buffers
    {
        Buffer<std::uint32_t> words;
        Buffer<contract::instances::PlacedInstance> instances;

        NeededBuffers needed(const PoissonTileSet& tiles);
    };

    Device device_;
    const ObjectTileSet& tiles_;
    std::size_t work_group_size_;
    Buffers buffers_;
    Kernel place_;
};

}
