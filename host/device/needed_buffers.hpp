// The buffers that a piece of work needs, in one list: what is allocated and what is foretold both come from it.
#pragma once

#include "host/device/device.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

/// A buffer, and how many values it must hold.
struct NeededBuffer
{
    template <typename T>
    NeededBuffer(Buffer<T>& buffer, std::size_t count)
        : bytes(count * sizeof(T)), allocate([&buffer, count](Device& device) { reserve(device, buffer, count); })
    {}

    std::uint64_t bytes;
    std::function<void(Device&)> allocate; ///< unless the buffer is large enough
};

using NeededBuffers = std::vector<NeededBuffer>;

/// Replaces those that are too small; their content is not kept.
inline void reserve(Device& device, const NeededBuffers& buffers)
{
    for (const NeededBuffer& buffer : buffers) buffer.allocate(device);
}

inline DeviceMemory memory_of(const NeededBuffers& buffers)
{
    DeviceMemory memory;
    for (const NeededBuffer& buffer : buffers) memory.add(buffer.bytes);
    return memory;
}

}
