#include "host/device/device_needs.hpp"

#include "host/device/device.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

std::string lacking(const KernelNeeds& needs, const DeviceInfo& device)
{
    if (needs.double_precision && !device.has_double_precision) return "double precision";
    if (needs.local_bytes > device.local_memory_bytes) return bytes_text(needs.local_bytes) + " of local memory";
    return {};
}

bool can_run(const KernelNeeds& needs, const DeviceInfo& device)
{
    return device.unusable.empty() && lacking(needs, device).empty();
}

DeviceError lack_error(const std::string& what, const KernelNeeds& needs, const DeviceInfo& device,
                       const std::vector<DeviceInfo>& devices)
{
    const auto other = std::ranges::find_if(devices, [&](const DeviceInfo& d) { return can_run(needs, d); });
    const std::string advice = other == devices.end()
                                   ? "no OpenCL device here has it, and the reference engine needs none"
                                   : fmt::format("--device {} ({}) has it", other - devices.begin(), other->name);
    return DeviceError(
        fmt::format("{} needs {}, which {} has not; {}", what, lacking(needs, device), device.name, advice));
}

void check_needs(const std::string& what, const KernelNeeds& needs, const DeviceInfo& device)
{
    if (!lacking(needs, device).empty()) throw lack_error(what, needs, device, list_devices());
}

}
