#include "host/device/device_memory.hpp"

#include "base/errors/errors.hpp"
#include "host/device/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace poissonlab {

DeviceMemory& DeviceMemory::add(std::uint64_t bytes)
{
    largest = std::max(largest, bytes);
    total += bytes;
    return *this;
}

DeviceMemory operator+(const DeviceMemory& a, const DeviceMemory& b)
{
    return {std::max(a.largest, b.largest), a.total + b.total};
}

DeviceMemory either(const DeviceMemory& a, const DeviceMemory& b)
{
    return {std::max(a.largest, b.largest), std::max(a.total, b.total)};
}

bool fits(const DeviceMemory& memory, const DeviceInfo& device)
{
    return memory.largest <= device.max_allocation_bytes && memory.total <= device.global_memory_bytes;
}

std::string comparison(const DeviceMemory& memory, const DeviceInfo& device)
{
    return fmt::format("needs {} of device memory, {} of it in one piece; {} has {}, {} in one piece",
                       bytes_text(memory.total), bytes_text(memory.largest), device.name,
                       bytes_text(device.global_memory_bytes), bytes_text(device.max_allocation_bytes));
}

void check_fits(const std::string& what, const DeviceMemory& memory, const DeviceInfo& device)
{
    if (!fits(memory, device)) throw InputError(what + ": " + comparison(memory, device));
}

std::string bytes_text(std::uint64_t bytes)
{
    constexpr std::array units{"KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
    if (bytes < 1024) return fmt::format("{} bytes", bytes);
    double value = static_cast<double>(bytes) / 1024;
    std::size_t unit = 0;
    for (; value >= 1023.95; ++unit) value /= 1024; // which would be shown as 1024.0
    return fmt::format("{:.1f} {}", value, units[unit]);
}

DeviceInfo share_of(DeviceInfo device, int processes)
{
    if (processes < 2) return device;
    device.name += fmt::format(", shared by {} processes,", processes);
    device.global_memory_bytes /= static_cast<std::uint64_t>(processes);
    device.max_allocation_bytes = std::min(device.max_allocation_bytes, device.global_memory_bytes);
    return device;
}

}
