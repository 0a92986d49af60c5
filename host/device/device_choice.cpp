// Which device is meant: by number, by name, or none in particular.
#include "base/errors/errors.hpp"
#include "host/device/device.hpp"
#include "host/device/device_needs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>

namespace poissonlab {
namespace {

constexpr const char* no_device = "no OpenCL device found: install the package pocl-opencl-icd (runs on the "
                                  "CPU) or the OpenCL driver of your GPU";

std::string lower_case(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool has_name(const DeviceInfo& info, const std::string& name) { return lower_case(info.name) == lower_case(name); }

bool has_in_name(const DeviceInfo& info, const std::string& part)
{
    return lower_case(info.name + "\n" + info.platform).find(lower_case(part)) != std::string::npos;
}

bool is_number(const std::string& text)
{
    return std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<std::size_t> all_of(const std::vector<DeviceInfo>& devices)
{
    std::vector<std::size_t> numbers(devices.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
    return numbers;
}

std::string list_of_names(const std::vector<DeviceInfo>& devices, const std::vector<std::size_t>& numbers)
{
    std::vector<std::string> names;
    for (const std::size_t i : numbers) names.push_back(fmt::format("{}: {}", i, devices[i].name));
    return fmt::format("{}", fmt::join(names, ", "));
}

std::size_t default_device(const std::vector<DeviceInfo>& devices, const KernelNeeds& needs)
{
    std::vector<std::size_t> preferred = all_of(devices);
    std::ranges::stable_partition(preferred, [&](std::size_t i) { return is_pocl(devices[i].platform); });
    auto found = std::ranges::find_if(preferred, [&](std::size_t i) { return can_run(needs, devices[i]); });
    if (found == preferred.end()) // parts of the work may be done there
        found = std::ranges::find_if(preferred, [&](std::size_t i) { return devices[i].unusable.empty(); });
    return found == preferred.end() ? 0 : *found; // who opens it says why it is not usable
}

std::size_t device_of_number(const std::vector<DeviceInfo>& devices, const std::string& selector)
{
    std::size_t number = 0;
    const auto parsed = std::from_chars(selector.data(), selector.data() + selector.size(), number);
    if (parsed.ec == std::errc{} && number < devices.size()) return number;
    throw DeviceError(fmt::format("there is no OpenCL device {}; there are: {}", shortened(selector),
                                  list_of_names(devices, all_of(devices))));
}

}

std::size_t choose_device(const std::vector<DeviceInfo>& devices, const std::string& selector, const KernelNeeds& needs)
{
    if (devices.empty()) throw DeviceError(no_device);
    if (selector.empty()) {
        const char* named = std::getenv("POISSONLAB_DEVICE");
        return named && *named ? choose_device(devices, named, needs) : default_device(devices, needs);
    }
    if (is_number(selector)) return device_of_number(devices, selector);

    std::vector<std::size_t> found = all_of(devices);
    std::erase_if(found, [&](std::size_t i) { return !has_name(devices[i], selector); });
    if (found.empty()) { // no whole name
        found = all_of(devices);
        std::erase_if(found, [&](std::size_t i) { return !has_in_name(devices[i], selector); });
    }
    if (found.empty())
        throw DeviceError(fmt::format("no OpenCL device matches \"{}\"; there are: {}", shortened(selector),
                                      list_of_names(devices, all_of(devices))));
    // If all devices found are of one model, any will do.
    const bool are_alike =
        std::ranges::all_of(found, [&](std::size_t i) { return has_name(devices[i], devices[found.front()].name); });
    if (!are_alike)
        throw DeviceError(fmt::format("\"{}\" matches several OpenCL devices, of which a number chooses one: {}",
                                      shortened(selector), list_of_names(devices, found)));
    return found.front();
}

}
