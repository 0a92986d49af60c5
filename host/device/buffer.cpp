#include "base/programs/large_pages.hpp"
#include "host/device/opencl.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

template <typename Transfer>
void checked(const BufferImpl& buffer, const char* doing, std::size_t bytes, Transfer&& transfer)
{
    try {
        transfer();
    } catch (const cl::Error& error) {
        throw device_error(fmt::format("{}: {} {} bytes", buffer.device->info.name, doing, bytes), error);
    }
}

}

BufferImpl::BufferImpl(std::shared_ptr<DeviceImpl> owner, std::size_t size) : device(std::move(owner)), bytes(size)
{
    try {
        memory = cl::Buffer(device->context, CL_MEM_READ_WRITE, std::max<std::size_t>(bytes, 1));
    } catch (const cl::Error& error) {
        throw device_error(
            fmt::format("{}: allocating {} bytes of {}", device->info.name, bytes, device->info.global_memory_bytes),
            error);
    }
    const std::lock_guard lock(device->memory_mutex);
    device->memory.add(bytes);
    device->peak_memory = either(device->peak_memory, device->memory);
}

BufferImpl::~BufferImpl()
{
    const std::lock_guard lock(device->memory_mutex);
    device->memory.total -= bytes;
}

void read_buffer(BufferImpl& buffer, std::size_t offset, std::size_t bytes, void* target)
{
    checked(buffer, "reading", bytes,
            [&] { buffer.device->queue.enqueueReadBuffer(buffer.memory, CL_TRUE, offset, bytes, target); });
}

void write_buffer(BufferImpl& buffer, std::size_t offset, std::size_t bytes, const void* source)
{
    checked(buffer, "writing", bytes,
            [&] { buffer.device->queue.enqueueWriteBuffer(buffer.memory, CL_TRUE, offset, bytes, source); });
}

void ask_for_large_pages(BufferImpl& buffer)
{
    if (buffer.device->info.type != "CPU" || buffer.bytes < 2 * large_page) return;
    checked(buffer, "mapping", buffer.bytes, [&] {
        const cl::CommandQueue& queue = buffer.device->queue;
        void* memory = queue.enqueueMapBuffer(buffer.memory, CL_TRUE, CL_MAP_WRITE_INVALIDATE_REGION, 0, buffer.bytes);
        ask_for_large_pages(memory, buffer.bytes);
        queue.enqueueUnmapMemObject(buffer.memory, memory);
    });
}

}
