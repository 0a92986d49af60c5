#include "tiles/tilings/hash_period.hpp"

#include <cstddef>

namespace poissonlab {

std::uint64_t cyclic_period(std::span<const std::uint32_t> values, std::uint64_t modulus)
{
    const std::size_t n = values.size();
    for (std::size_t d = 1; d < n; ++d) {
        if (n % d != 0) continue;
        bool repeats = true;
        for (std::size_t i = 0; i < n && repeats; ++i) repeats = values[i] % modulus == values[(i + d) % n] % modulus;
        if (repeats) return d;
    }
    return n;
}

HashPeriod permutation_period(std::span<const std::uint32_t> permutation, Color colors)
{
    // Each column is the same cycle of colours, shifted by P[x]; shifts by the cycle's period do not count.
    const std::uint64_t y = cyclic_period(permutation, colors);
    return {cyclic_period(permutation, y), y};
}

}
