// Memory on a device.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace poissonlab {

struct BufferImpl;

/// Byte-wise transfers; throw DeviceError. Both wait for their completion.
void read_buffer(BufferImpl& buffer, std::size_t offset, std::size_t bytes, void* target);
void write_buffer(BufferImpl& buffer, std::size_t offset, std::size_t bytes, const void* source);

/// Asks for large pages, where a processor is the device, for what a kernel looks into anywhere: it waits less for
/// them. Before anything is in the buffer. Throws DeviceError.
void ask_for_large_pages(BufferImpl& buffer);

/// `size` values of type T on the device. Copies share the memory.
template <typename T>
class Buffer
{
    static_assert(std::is_trivially_copyable_v<T>);

public:
    Buffer() = default;
    Buffer(std::shared_ptr<BufferImpl> impl, std::size_t size) : impl_(std::move(impl)), size_(size) {}

    std::size_t size() const { return size_; }

    /// Is it on a device? One that is can be of size 0; kernels take it all the same.
    bool is_allocated() const { return impl_ != nullptr; }

    /// The values from `offset`, as many as `target` holds.
    void read(std::span<T> target, std::size_t offset = 0) const
    {
        if (!target.empty()) read_buffer(impl(), offset * sizeof(T), target.size_bytes(), target.data());
    }

    std::vector<T> read(std::size_t offset, std::size_t count) const
    {
        std::vector<T> values(count);
        read(std::span<T>(values), offset);
        return values;
    }

    void write(std::span<const T> source, std::size_t offset = 0)
    {
        if (!source.empty()) write_buffer(impl(), offset * sizeof(T), source.size_bytes(), source.data());
    }

    /// Throws std::logic_error where nothing is allocated.
    BufferImpl& impl() const
    {
        if (!impl_) throw std::logic_error("a buffer is used that was never allocated");
        return *impl_;
    }

private:
    std::shared_ptr<BufferImpl> impl_;
    std::size_t size_ = 0;
};

}
