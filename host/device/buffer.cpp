#include "device/opencl.hpp"

#include <fmt/format.h>

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

}
