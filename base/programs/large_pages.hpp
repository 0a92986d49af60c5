// Memory in large pages: its first touch, page by page, costs a tenth of that of small ones.
#pragma once

#include <cstddef>

namespace poissonlab {

inline constexpr std::size_t large_page = std::size_t{2} << 20; ///< bytes; of x86 and ARM processors

/// Asks the operating system for large pages where they fit into memory that has not been touched yet. It
/// need not listen.
void ask_for_large_pages(void* memory, std::size_t bytes);

}
