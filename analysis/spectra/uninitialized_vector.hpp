// A vector of numbers without values until they are given some, for arrays of many megabytes.
#pragma once

#include "base/programs/large_pages.hpp"

#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace poissonlab {

/// std::vector sets new elements to zero, on one thread, which fetches fresh memory page by page: for spectra
/// that takes as long as work that all threads share. For elements that are all written before they are read.
template <typename T>
class UninitializedAllocator
{
    static_assert(std::is_trivially_default_constructible_v<T>);

public:
    using value_type = T;

    UninitializedAllocator() = default;
    template <typename U>
    UninitializedAllocator(const UninitializedAllocator<U>&)
    {}
    bool operator==(const UninitializedAllocator&) const = default;

    T* allocate(std::size_t size)
    {
        void* const memory = ::operator new(size * sizeof(T), alignment(size));
        ask_for_large_pages(memory, size * sizeof(T));
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t size) { ::operator delete(memory, alignment(size)); }

    template <typename U, typename... Values>
    void construct(U* place, Values&&... values)
    {
        if constexpr (sizeof...(Values) == 0)
            ::new (static_cast<void*>(place)) U;
        else
            ::new (static_cast<void*>(place)) U(std::forward<Values>(values)...);
    }

private:
    /// Whole pages, or else cache lines.
    static std::align_val_t alignment(std::size_t size)
    {
        return std::align_val_t{size * sizeof(T) >= large_page ? large_page : 64};
    }
};

template <typename T>
using UninitializedVector = std::vector<T, UninitializedAllocator<T>>;

}
