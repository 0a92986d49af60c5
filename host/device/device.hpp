// OpenCL devices: what is there, and one that is open for work.
//
// host/device is the only place that knows the OpenCL API. What can fail throws DeviceError with the call,
// the name of the error code, the kernel and, where there is one, the build log.
#pragma once

#include "host/device/buffer.hpp"
#include "host/device/device_memory.hpp"
#include "host/device/kernel.hpp"
#include "host/device/kernel_program.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace poissonlab {

struct DeviceInfo
{
    std::string platform;
    std::string name;
    std::string vendor;
    std::string type; ///< "CPU", "GPU", "accelerator" or "other"
    std::string driver_version;
    std::string device_version;
    unsigned compute_units = 0;
    std::uint64_t global_memory_bytes = 0;
    std::uint64_t max_allocation_bytes = 0; ///< of one buffer
    std::uint64_t local_memory_bytes = 0;
    std::size_t max_work_group_size = 0;
    bool has_double_precision = false;
    std::string unusable; ///< why the laboratory's kernels cannot run there; empty: they can

    /// The kind of device, on which the last bits of results may depend. Stored results of one model of graphics card
    /// are never taken for those of another; all processors count as one kind, so that the machines of a cluster may
    /// differ.
    std::string identity() const { return platform + ", " + (type == "CPU" ? type : name); }
};

/// Every OpenCL device of this machine, in the order of platforms. Empty where there is none.
std::vector<DeviceInfo> list_devices();

/// The device that Device::open() opens, by its number in the list. `selector`: such a number; a name, or a part of
/// one device's or platform's name (letter case does not matter); or empty for the default: PoCL where it is there and
/// meets the needs of what is asked, else the first that meets them, else the first usable one. Throws DeviceError when
/// none matches, or several that differ in their names.
std::size_t choose_device(const std::vector<DeviceInfo>& devices, const std::string& selector,
                          const KernelNeeds& needs = all_kernel_needs());

struct DeviceImpl;

/// An open device with one in-order command queue. Copies share the device.
class Device
{
public:
    /// Opens the device that choose_device() chooses. `threads` > 0 restricts a CPU device to that many compute
    /// units, if its driver can divide it; 0 takes all, and other devices have no threads of this machine. Throws
    /// DeviceError when there is no such device. A device that is open already is handed out again.
    static Device open(const std::string& selector = {}, unsigned threads = 0,
                       const KernelNeeds& needs = all_kernel_needs());

    /// The device that open() would open; it stays closed. Throws DeviceError as open() does.
    static DeviceInfo find(const std::string& selector = {}, const KernelNeeds& needs = all_kernel_needs());

    const DeviceInfo& info() const;

    /// A kernel of an embedded file. The program is built at its first use, and kept. Throws DeviceError, before that,
    /// where the device lacks what it needs.
    Kernel kernel(const KernelProgram& program, const std::string& name);

    /// Builds a source text that is not embedded; `file` is its name in messages.
    Kernel kernel_from_text(const std::string& text, const std::string& file, const std::string& name,
                            const std::string& options = {});

    /// Seconds spent on building programs so far.
    double build_seconds() const;

    /// The memory of buffers: what there is of them now, and the most that there was since watch_memory().
    /// `largest` is that of all buffers since then in both.
    DeviceMemory memory() const;
    DeviceMemory peak_memory() const;
    void watch_memory();

    /// An uninitialised buffer of `count` values.
    template <typename T>
    Buffer<T> buffer(std::size_t count)
    {
        return Buffer<T>(allocate(count * sizeof(T)), count);
    }

    /// Waits until everything that was enqueued is done.
    void finish();

private:
    explicit Device(std::shared_ptr<DeviceImpl> impl);
    std::shared_ptr<BufferImpl> allocate(std::size_t bytes);

    std::shared_ptr<DeviceImpl> impl_;
};

/// Returns the constant of kernel files that do with or without double precision, see kernels/common/reals.clh.
KernelValue doubles_of(const Device& device);

/// Replaces a buffer by a larger one when it holds fewer than `count` values; its content is not kept. It is allocated
/// for a count of 0 as well: empty problems go to the same kernels.
template <typename T>
void reserve(Device& device, Buffer<T>& buffer, std::size_t count)
{
    if (buffer.is_allocated() && buffer.size() >= count) return;
    buffer = {}; // before the new one: there may be no room for both
    buffer = device.buffer<T>(count);
}

}
