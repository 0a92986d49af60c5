#include "host/device/device.hpp"

#include "host/device/device_needs.hpp"
#include "host/device/kernel_source.hpp"
#include "host/device/opencl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <optional>

namespace poissonlab {
namespace {

std::string type_name(cl_device_type type)
{
    if (type & CL_DEVICE_TYPE_GPU) return "GPU";
    if (type & CL_DEVICE_TYPE_CPU) return "CPU";
    return type & CL_DEVICE_TYPE_ACCELERATOR ? "accelerator" : "other";
}

/// Names the first thing that kernels need and the device lacks: a compiler for OpenCL C 1.2, 64-bit integers
/// (missing only in the embedded profile), the byte order of the host, or loops that end when they should.
std::string why_unusable(const cl::Device& device)
{
    if (!device.getInfo<CL_DEVICE_AVAILABLE>()) return "the device is not available";
    if (!device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) return "the driver has no OpenCL C compiler";
    // "OpenCL C <major>.<minor> ..."
    const std::string language = device.getInfo<CL_DEVICE_OPENCL_C_VERSION>();
    if (language.substr(0, 9) == "OpenCL C " && language.substr(9, 3) < "1.2") return language + " is older than 1.2";
    if (device.getInfo<CL_DEVICE_PROFILE>() != "FULL_PROFILE") return "the embedded profile may lack 64-bit integers";
    if (!device.getInfo<CL_DEVICE_ENDIAN_LITTLE>()) return "the device is big-endian";
    if (device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>() == 0) return "the driver reports no compute units";
    const std::size_t group_size = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
    if (group_size < default_work_group_size)
        return fmt::format("work-groups have at most {} work-items there; kernels take {}", group_size,
                           default_work_group_size);
    return why_loops_are_unreliable(device.getInfo<CL_DEVICE_NAME>());
}

/// Drivers of OpenCL 1.1 may know the question as that of an extension only, and refuse it without that.
bool has_double_precision(const cl::Device& device)
{
    cl_device_fp_config config = 0;
    return ::clGetDeviceInfo(device(), CL_DEVICE_DOUBLE_FP_CONFIG, sizeof config, &config, nullptr) == CL_SUCCESS &&
           config != 0;
}

void read_info(const cl::Device& device, DeviceInfo& info)
{
    info.platform = cl::Platform(device.getInfo<CL_DEVICE_PLATFORM>()).getInfo<CL_PLATFORM_NAME>();
    info.name = device.getInfo<CL_DEVICE_NAME>();
    info.vendor = device.getInfo<CL_DEVICE_VENDOR>();
    info.type = type_name(device.getInfo<CL_DEVICE_TYPE>());
    info.driver_version = device.getInfo<CL_DRIVER_VERSION>();
    info.device_version = device.getInfo<CL_DEVICE_VERSION>();
    info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
    info.global_memory_bytes = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
    info.max_allocation_bytes = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
    info.local_memory_bytes = device.getInfo<CL_DEVICE_LOCAL_MEM_SIZE>();
    info.max_work_group_size = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
    info.has_double_precision = has_double_precision(device);
    info.unusable = why_unusable(device);
}

/// A device that does not even say what it is stays in the list, so that others keep their numbers.
DeviceInfo describe(const cl::Device& device)
{
    DeviceInfo info;
    try {
        read_info(device, info);
    } catch (const cl::Error& error) {
        if (info.name.empty()) info.name = "unknown device";
        info.unusable = device_error("asking what it is", error).what();
    }
    return info;
}

/// A driver that fails does not keep others from being used.
std::vector<cl::Device> all_devices()
{
    static const std::string pocl_lacks = provide_pocl_needs();
    const std::string doing = "looking for OpenCL devices";
    std::vector<cl::Platform> platforms;
    try {
        cl::Platform::get(&platforms);
    } catch (const cl::Error& error) {
        // A loader without any driver says so by this code.
        if (error.err() != -1001) throw device_error(doing, error);
    }
    std::vector<cl::Device> devices;
    std::optional<DeviceError> failed;
    for (const cl::Platform& platform : platforms) {
        std::vector<cl::Device> found;
        try {
            if (!pocl_lacks.empty() && is_pocl(platform.getInfo<CL_PLATFORM_NAME>())) {
                failed = DeviceError(pocl_lacks);
                continue;
            }
            platform.getDevices(CL_DEVICE_TYPE_ALL, &found);
        } catch (const cl::Error& error) {
            if (error.err() != CL_DEVICE_NOT_FOUND) failed = device_error(doing, error);
        }
        devices.insert(devices.end(), found.begin(), found.end());
    }
    if (devices.empty() && failed) throw *failed;
    return devices;
}

/// Drivers that cannot divide a device, such as Mesa's, need not have the call that does it.
bool can_be_divided(const cl::Device& device)
{
    std::vector<cl_device_partition_property> ways;
    try {
        ways = device.getInfo<CL_DEVICE_PARTITION_PROPERTIES>();
    } catch (const cl::Error&) {
        return false;
    }
    return std::ranges::find(ways, CL_DEVICE_PARTITION_BY_COUNTS) != ways.end();
}

cl::Device restrict_threads(const cl::Device& device, unsigned threads, unsigned compute_units)
{
    const bool is_asked = threads > 0 && threads < compute_units;
    if (!is_asked || !(device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) || !can_be_divided(device)) return device;
    const cl_device_partition_property properties[] = {CL_DEVICE_PARTITION_BY_COUNTS, threads,
                                                       CL_DEVICE_PARTITION_BY_COUNTS_LIST_END, 0};
    std::vector<cl::Device> parts;
    cl::Device whole = device;
    whole.createSubDevices(properties, &parts);
    return parts.at(0);
}

/// The driver's log of a build; empty if the driver has none, or is no longer there to give it.
std::string build_log(const cl::Program& program, const cl::Device& device)
{
    try {
        return program.getBuildInfo<CL_PROGRAM_BUILD_LOG>(device);
    } catch (const cl::Error&) {
        return {};
    }
}

cl::Program build(DeviceImpl& impl, const std::string& text, const std::string& file, const std::string& options)
{
    const auto start = std::chrono::steady_clock::now();
    cl::Program program;
    try {
        program = cl::Program(impl.context, text);
        // This avoids cl::Program::build, which asks for the log and fails with that where the device is gone.
        const cl_device_id device = impl.device();
        // Drivers warn on the user's terminal: PoCL of vectors of eight numbers on processors without AVX-512.
        const cl_int code =
            ::clBuildProgram(program(), 1, &device, ("-cl-std=CL1.2 -w " + options).c_str(), nullptr, nullptr);
        if (code != CL_SUCCESS) throw cl::Error(code, "clBuildProgram");
    } catch (const cl::Error& error) {
        const std::string log = build_log(program, impl.device);
        throw DeviceError(
            device_error(impl.info.name + ": building kernels/" + file + " (" + options + ")", error).what(),
            log.empty() ? "" : "; build log:\n" + log);
    }
    impl.build_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return program;
}

std::shared_ptr<DeviceImpl> open_device(const cl::Device& device, const DeviceInfo& info, unsigned threads)
{
    auto impl = std::make_shared<DeviceImpl>();
    try {
        impl->device = restrict_threads(device, threads, info.compute_units);
        impl->info = describe(impl->device);
        impl->context = cl::Context(impl->device);
        impl->queue = cl::CommandQueue(impl->context, impl->device);
    } catch (const cl::Error& error) {
        throw device_error("opening " + info.name, error);
    }
    return impl;
}

}

std::vector<DeviceInfo> list_devices()
{
    std::vector<DeviceInfo> infos;
    for (const cl::Device& device : all_devices()) infos.push_back(describe(device));
    return infos;
}

DeviceInfo Device::find(const std::string& selector, const KernelNeeds& needs)
{
    const std::vector<DeviceInfo> infos = list_devices();
    return infos[choose_device(infos, selector, needs)];
}

Device::Device(std::shared_ptr<DeviceImpl> impl) : impl_(std::move(impl)) {}

Device Device::open(const std::string& selector, unsigned threads, const KernelNeeds& needs)
{
    const std::vector<cl::Device> devices = all_devices();
    std::vector<DeviceInfo> infos;
    for (const cl::Device& device : devices) infos.push_back(describe(device));
    const std::size_t chosen = choose_device(infos, selector, needs);
    if (!infos[chosen].unusable.empty()) {
        throw DeviceError("the OpenCL device " + infos[chosen].name + " cannot be used: " + infos[chosen].unusable);
    }

    // An opened device stays open until the process ends, and is handed out again. PoCL (3.1) may still be
    // releasing the last event of a queue in a worker thread when all commands are done, and crashes when its
    // context goes meanwhile.
    static std::mutex mutex;
    static auto& opened = *new std::map<std::pair<std::size_t, unsigned>, std::shared_ptr<DeviceImpl>>;
    const std::lock_guard lock(mutex);
    std::shared_ptr<DeviceImpl>& impl = opened[{chosen, threads}];
    if (!impl) impl = open_device(devices[chosen], infos[chosen], threads);
    return Device(impl);
}

const DeviceInfo& Device::info() const { return impl_->info; }
double Device::build_seconds() const { return impl_->build_seconds; }

KernelValue doubles_of(const Device& device) { return {"DOUBLES", device.info().has_double_precision ? 1 : 0}; }

Kernel Device::kernel(const KernelProgram& program, const std::string& name)
{
    check_needs(program.work, program.needs, impl_->info);
    return kernel_from_text(kernel_source("kernels/" + program.file), program.file, name, program.options);
}

Kernel Device::kernel_from_text(const std::string& text, const std::string& file, const std::string& name,
                                const std::string& options)
{
    auto program = impl_->programs.find({text, options});
    if (program == impl_->programs.end()) {
        program = impl_->programs.emplace(std::pair(text, options), build(*impl_, text, file, options)).first;
    }
    auto impl = std::make_shared<KernelImpl>();
    impl->device = impl_;
    impl->name = name;
    try {
        impl->kernel = cl::Kernel(program->second, name.c_str());
    } catch (const cl::Error& error) {
        throw device_error(impl_->info.name + ": kernels/" + file + ": kernel " + name, error);
    }
    return Kernel(std::move(impl));
}

std::shared_ptr<BufferImpl> Device::allocate(std::size_t bytes) { return std::make_shared<BufferImpl>(impl_, bytes); }

DeviceMemory Device::memory() const
{
    const std::lock_guard lock(impl_->memory_mutex);
    return impl_->memory;
}

DeviceMemory Device::peak_memory() const
{
    const std::lock_guard lock(impl_->memory_mutex);
    return impl_->peak_memory;
}

void Device::watch_memory()
{
    const std::lock_guard lock(impl_->memory_mutex);
    impl_->memory.largest = 0;
    impl_->peak_memory = impl_->memory;
}

void Device::finish()
{
    try {
        impl_->queue.finish();
    } catch (const cl::Error& error) {
        throw device_error(impl_->info.name + ": waiting for kernels", error);
    }
}

}
