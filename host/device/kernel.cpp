#include "base/programs/interrupt.hpp"
#include "host/device/opencl.hpp"

namespace poissonlab {
namespace {

template <typename Call>
void checked(const KernelImpl& kernel, const char* doing, Call&& call)
{
    try {
        call();
    } catch (const cl::Error& error) {
        throw device_error(kernel.device->info.name + ": " + doing + " kernel " + kernel.name, error);
    }
}

}

void Kernel::set_buffer(unsigned index, BufferImpl& buffer)
{
    checked(*impl_, "setting arguments of", [&] { impl_->kernel.setArg(index, buffer.memory); });
}

void Kernel::set_bytes(unsigned index, std::size_t bytes, const void* value)
{
    checked(*impl_, "setting arguments of", [&] { impl_->kernel.setArg(index, bytes, value); });
}

void Kernel::enqueue(std::size_t items, std::size_t group_size)
{
    if (items == 0) return;
    stop_if_interrupted(); // methods that iterate enqueue kernels again and again
    const std::size_t groups = (items + group_size - 1) / group_size;
    checked(*impl_, "running", [&] {
        impl_->device->queue.enqueueNDRangeKernel(impl_->kernel, cl::NullRange, cl::NDRange(groups * group_size),
                                                  cl::NDRange(group_size));
    });
}

}
