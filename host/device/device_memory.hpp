// The device memory that a piece of work takes, and the check that a device has it.
//
// Samplers say what they will take before they start (SamplerSpec::device_memory), from the sizes of the buffers that
// they allocate; Device counts what they really take.
#pragma once

#include <cstdint>
#include <string>

namespace poissonlab {

struct DeviceInfo;

/// Bytes of buffers that are there at the same time.
struct DeviceMemory
{
    std::uint64_t largest = 0; ///< buffer
    std::uint64_t total = 0;

    bool operator==(const DeviceMemory&) const = default;

    /// One more buffer.
    DeviceMemory& add(std::uint64_t bytes);
};

/// The memory of two works that go on at the same time.
DeviceMemory operator+(const DeviceMemory& a, const DeviceMemory& b);

/// The memory of two works, one after the other: the larger of each number.
DeviceMemory either(const DeviceMemory& a, const DeviceMemory& b);

bool fits(const DeviceMemory& memory, const DeviceInfo& device);

/// "needs 3.2 GiB of device memory, 1.1 GiB of it in one piece; GPU has 2.0 GiB, 0.5 GiB in one piece"
std::string comparison(const DeviceMemory& memory, const DeviceInfo& device);

/// Throws InputError where `what`, a file or a series, does not fit: both as comparison() says it.
void check_fits(const std::string& what, const DeviceMemory& memory, const DeviceInfo& device);

/// "512 bytes", "1.5 MiB", "12.0 GiB".
std::string bytes_text(std::uint64_t bytes);

/// The share of a device's memory that each of several processes on a machine may take, if all take the same.
DeviceInfo share_of(DeviceInfo device, int processes);

}
