// poissonlab devices: what OpenCL offers here.
#include "app/commands/command.hpp"
#include "host/device/device.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace poissonlab {
namespace {

/// A line, without what a driver leaves empty.
void print_line(const std::string& name, std::vector<std::string> fields)
{
    std::erase(fields, "");
    if (!fields.empty()) fmt::print("     {:<12}{}\n", name, fmt::join(fields, ", "));
}

std::string version_of_driver(const DeviceInfo& device)
{
    return device.driver_version.empty() ? "" : "driver " + device.driver_version;
}

void print_device(std::size_t number, const DeviceInfo& device)
{
    fmt::print("{}  {}\n", number, device.name);
    print_line("platform", {device.platform, version_of_driver(device)});
    print_line("device", {device.type, device.vendor, device.device_version});
    if (device.compute_units > 0) // of one that did not say what it is, nothing is known
        print_line("resources", {fmt::format("{} compute units", device.compute_units),
                                 fmt::format("{} memory, {} in one piece", bytes_text(device.global_memory_bytes),
                                             bytes_text(device.max_allocation_bytes)),
                                 fmt::format("work-groups of up to {}", device.max_work_group_size)});
    print_line("unusable", {device.unusable});
}

void print_devices()
{
    const std::vector<DeviceInfo> devices = list_devices();
    choose_device(devices, ""); // says what to do where there is none
    for (std::size_t i = 0; i < devices.size(); ++i) print_device(i, devices[i]);
}

}

Command devices_command()
{
    return {"devices", "List what OpenCL offers on this machine", {}, "", [] {
                print_devices();
                return 0;
            }};
}

}
