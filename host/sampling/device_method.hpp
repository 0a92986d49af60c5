// The base of methods that run on a device.
#pragma once

#include "host/device/device.hpp"
#include "host/device/kernel.hpp"

#include <cstddef>
#include <memory>
#include <utility>

namespace poissonlab {

/// A device, the size of work-groups there, and buffers that are kept from call to call: first touch of memory is slow.
/// `Buffers` may be incomplete where a method is declared.
template <typename Buffers>
class DeviceMethod
{
public:
    DeviceMethod(DeviceMethod&&) noexcept = default;

protected:
    /// `work_group_size` 0: the default.
    DeviceMethod(Device device, std::size_t work_group_size, std::shared_ptr<Buffers> buffers)
        : device_(std::move(device)), work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size),
          buffers_(std::move(buffers))
    {}

    Device device_;
    std::size_t work_group_size_;
    std::shared_ptr<Buffers> buffers_;
};

}
