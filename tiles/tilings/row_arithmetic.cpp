#include "tiles/tilings/row_arithmetic.hpp"

// Two versions, of which the processor at hand gets the right one. Integers: the results are the same. Sanitizers are
// not ready yet when the loader chooses.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&               \
    !defined(__SANITIZE_THREAD__)
#define FOR_WIDE_VECTORS_TOO __attribute__((target_clones("avx2", "default")))
#else
#define FOR_WIDE_VECTORS_TOO
#endif

namespace poissonlab {

FOR_WIDE_VECTORS_TOO
void index_corner_tiles(const std::uint8_t* south, const std::uint8_t* north, Color colors, std::span<TileIndex> tiles)
{
    TileIndex* const out = tiles.data();
    const std::size_t count = tiles.size();
    for (std::size_t i = 0; i < count; ++i)
        out[i] = ((north[i + 1] * colors + south[i + 1]) * colors + south[i]) * colors + north[i];
}

FOR_WIDE_VECTORS_TOO
void index_wang_tiles(const std::uint8_t* north, const std::uint8_t* south, const std::uint8_t* vertical,
                      WangColors colors, std::span<TileIndex> tiles)
{
    TileIndex* const out = tiles.data();
    const std::size_t count = tiles.size();
    for (std::size_t i = 0; i < count; ++i)
        out[i] = ((north[i] * colors.vertical + vertical[i + 1]) * colors.horizontal + south[i]) * colors.vertical +
                 vertical[i];
}

FOR_WIDE_VECTORS_TOO
void add_colors(const std::uint8_t* a, const std::uint8_t* b, Color colors, std::span<std::uint8_t> sums)
{
    std::uint8_t* const out = sums.data();
    const std::size_t count = sums.size();
    for (std::size_t i = 0; i < count; ++i) {
        const auto sum = static_cast<std::uint16_t>(a[i] + b[i]);
        out[i] = static_cast<std::uint8_t>(sum < colors ? sum : sum - colors);
    }
}

}
