// poissonlab devices: what OpenCL offers here.
#include "device/device.hpp"
#include "errors/errors.hpp"
#include "experiment/commands/commands.hpp"

#include <fmt/format.h>

namespace poissonlab {

void devices_command()
{
    const std::vector<DeviceInfo> devices = list_devices();
    if (devices.empty())
        throw DeviceError(
            "no OpenCL device found; PoCL makes one of any processor (Debian: pocl-opencl-icd)");
    for (std::size_t i = 0; i < devices.size(); ++i) {
        const DeviceInfo& device = devices[i];
        constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
        fmt::print("{}  {}\n", i, device.name);
        fmt::print("     platform    {}, driver {}\n", device.platform, device.driver_version);
        fmt::print("     device      {}, {}, {}\n", device.type, device.vendor, device.device_version);
        fmt::print("     resources   {} compute units, {:.1f} GiB memory, work-groups of up to {}\n",
                   device.compute_units, static_cast<double>(device.global_memory_bytes) / gibibyte,
                   device.max_work_group_size);
        if (!device.unusable.empty()) fmt::print("     unusable    {}\n", device.unusable);
    }
}

}
