#include "base/programs/large_pages.hpp"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace poissonlab {

void ask_for_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes)
{
#ifdef __linux__
    const std::size_t before = (large_page - reinterpret_cast<std::uintptr_t>(memory) % large_page) % large_page;
    if (bytes < before + large_page) return;
    madvise(static_cast<char*>(memory) + before, (bytes - before) / large_page * large_page, MADV_HUGEPAGE);
#endif
}

}
