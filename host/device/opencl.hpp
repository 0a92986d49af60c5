// The OpenCL headers as host/device uses them, and the objects behind its handles. Not for other folders.
#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#include <CL/opencl.hpp>

#include "base/errors/errors.hpp"
#include "host/device/device.hpp"

#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace poissonlab {

/// "CL_OUT_OF_RESOURCES" for -5, and so on; "OpenCL error -n" for codes without a name here.
std::string opencl_error_name(cl_int code);

/// The DeviceError for a failed call: what was being done, the call, the code's name.
DeviceError device_error(const std::string& doing, const cl::Error& error);

struct DeviceImpl
{
    cl::Device device;
    cl::Context context;
    cl::CommandQueue queue;
    DeviceInfo info;
    std::map<std::pair<std::string, std::string>, cl::Program> programs; // by source text and options
    double build_seconds = 0;
    std::mutex memory_mutex;
    DeviceMemory memory, peak_memory;
};

struct BufferImpl
{
    BufferImpl(std::shared_ptr<DeviceImpl> owner, std::size_t size);
    BufferImpl(const BufferImpl&) = delete;
    BufferImpl& operator=(const BufferImpl&) = delete;
    ~BufferImpl();

    std::shared_ptr<DeviceImpl> device;
    std::size_t bytes;
    cl::Buffer memory;
};

struct KernelImpl
{
    std::shared_ptr<DeviceImpl> device;
    cl::Kernel kernel;
    std::string name;
};

}
