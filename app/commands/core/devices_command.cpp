// poissonlab devices: what OpenCL offers here, and which methods run there.
#include "app/commands/work_options.hpp"
#include "base/errors/errors.hpp"
#include "host/device/device.hpp"
#include "host/device/device_needs.hpp"
#include "host/settings/method_needs.hpp"
#include "host/settings/sampler_registry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <set>
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

/// Has the methods with kernels, in the order of help: those that run on a device, those of them that do not in 3D, and
/// those that do not run.
struct RunningMethods
{
    std::vector<std::string> run, only_in_plane, fail;
};

RunningMethods methods_on(const DeviceInfo& device)
{
    RunningMethods methods;
    for (const SamplerSpec& sampler : sampler_registry()) {
        if (sampler.kernels.empty()) continue;
        (can_run(needs_in(sampler, 2), device) ? methods.run : methods.fail).push_back(sampler.name);
        if (can_run(needs_in(sampler, 2), device) && !can_run(needs_in(sampler, 3), device))
            methods.only_in_plane.push_back(sampler.name);
    }
    return methods;
}

/// The commands with kernels that no method has, and that do not run on a device.
std::vector<std::string> commands_that_fail_on(const DeviceInfo& device)
{
    std::set<std::string> of_methods, commands;
    for (const SamplerSpec& sampler : sampler_registry()) {
        of_methods.insert(sampler.kernels.begin(), sampler.kernels.end());
        of_methods.insert(sampler.kernels_in_space.begin(), sampler.kernels_in_space.end());
    }
    for (const KernelFile& file : kernel_files())
        if (!of_methods.contains(file.name) && !can_run(file.needs, device)) commands.insert(file.work);
    return {commands.begin(), commands.end()};
}

/// Which of the methods with kernels run there, and why not all.
void print_methods(const DeviceInfo& device)
{
    const RunningMethods methods = methods_on(device);
    if (methods.fail.empty() && methods.only_in_plane.empty()) {
        print_line("methods", {"all"});
        return;
    }
    print_line("lacks", {lacking(all_kernel_needs(), device)});
    print_line("methods", methods.run.empty() ? std::vector<std::string>{"none"} : methods.run);
    print_line("only in 2D", methods.only_in_plane);
    print_line("not", methods.fail);
    print_line("nor", commands_that_fail_on(device));
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
    if (device.unusable.empty()) print_methods(device);
}

nlohmann::ordered_json json_of(std::size_t number, const DeviceInfo& device)
{
    return {{"number", number},
            {"name", printable(device.name)},
            {"platform", printable(device.platform)},
            {"vendor", printable(device.vendor)},
            {"type", device.type},
            {"driver_version", printable(device.driver_version)},
            {"device_version", printable(device.device_version)},
            {"compute_units", device.compute_units},
            {"global_memory_bytes", device.global_memory_bytes},
            {"max_allocation_bytes", device.max_allocation_bytes},
            {"local_memory_bytes", device.local_memory_bytes},
            {"max_work_group_size", device.max_work_group_size},
            {"double_precision", device.has_double_precision},
            {"methods", methods_on(device).run},
            {"methods_only_in_plane", methods_on(device).only_in_plane},
            {"unusable", printable(device.unusable)}};
}

constexpr auto devices_notes =
    R"(A device is chosen by its number or a part of its name: --device, or `device = ` in the config of an experiment.
  poissonlab devices
  poissonlab run configs/quick.toml --device 1)";

void print_devices(bool as_json)
{
    const std::vector<DeviceInfo> devices = list_devices();
    if (devices.empty()) choose_device(devices, ""); // says what to do
    nlohmann::ordered_json json{{"devices", nlohmann::ordered_json::array()}};
    for (std::size_t i = 0; i < devices.size(); ++i)
        if (as_json)
            json["devices"].push_back(json_of(i, devices[i]));
        else
            print_device(i, devices[i]);
    if (as_json) fmt::print("{}\n", json.dump(2));
}

}

Command devices_command()
{
    const auto as_json = std::make_shared<bool>(false);
    return {"devices", "List what OpenCL offers on this machine", {json_option(*as_json)}, devices_notes, [as_json] {
                print_devices(*as_json);
                return 0;
            }};
}

}
