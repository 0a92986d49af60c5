// A kernel that can be enqueued with typed arguments.
#pragma once

#include "host/device/buffer.hpp"

#include <cstddef>
#include <memory>
#include <type_traits>

namespace poissonlab {

struct KernelImpl;

/// Work-items of a group where a kernel has no reason for another number.
inline constexpr std::size_t default_work_group_size = 64;

/// A kernel argument in local memory: so many bytes for each work-group.
struct LocalMemory
{
    std::size_t bytes;
};

class Kernel
{
public:
    Kernel() = default;
    explicit Kernel(std::shared_ptr<KernelImpl> impl) : impl_(std::move(impl)) {}

    /// Enqueues at least `items` work-items in work-groups of `group_size`: the range is padded to whole
    /// groups, so kernels compare their id with the number of items. Arguments: buffers, LocalMemory, and
    /// plain values or structs that have the kernel's parameter types. Nothing is enqueued for zero items.
    template <typename... Arguments>
    void run(std::size_t items, std::size_t group_size, const Arguments&... arguments)
    {
        unsigned index = 0;
        (set(index++, arguments), ...);
        enqueue(items, group_size);
    }

private:
    template <typename T>
    void set(unsigned index, const Buffer<T>& buffer)
    {
        set_buffer(index, buffer.impl());
    }
    void set(unsigned index, const LocalMemory& memory) { set_bytes(index, memory.bytes, nullptr); }
    template <typename T>
    void set(unsigned index, const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        set_bytes(index, sizeof(T), &value);
    }

    void set_buffer(unsigned index, BufferImpl& buffer);
    void set_bytes(unsigned index, std::size_t bytes, const void* value);
    void enqueue(std::size_t items, std::size_t group_size);

    std::shared_ptr<KernelImpl> impl_;
};

}
