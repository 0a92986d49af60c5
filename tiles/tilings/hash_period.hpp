// The exact period of a hash function that looks up permutation tables.
#pragma once

#include "tiles/tilings/tile_index.hpp"

#include <cstdint>
#include <span>

namespace poissonlab {

// Hash functions as kernels/common/tiles/tiling.clh takes them: an array of words, of which the first is a tag.

constexpr std::uint32_t permutation_hash_tag = 0; ///< then: colors, size, entries
constexpr std::uint32_t long_period_hash_tag = 1; ///< then: colors, number of tables, sizes, entries
constexpr std::uint32_t xxh64_hash_tag = 2;       ///< then: colors, seed (low word, high word)
constexpr std::uint32_t two_table_hash_tag = 3;   ///< then: colors, size, entries of the tables of x, y and z

/// h(x + i x', y + j y') = h(x, y) for all integers i and j, with the least numbers x' and y' of which that
/// is true. 0: no period that fits in 64 bits.
struct HashPeriod
{
    std::uint64_t x = 0;
    std::uint64_t y = 0;

    bool operator==(const HashPeriod&) const = default;
};

/// The least divisor d of the number of values such that, cyclically, each value and the d-th after it are
/// the same modulo `modulus`.
std::uint64_t cyclic_period(std::span<const std::uint32_t> values, std::uint64_t modulus);

/// The periods of the colours P[(P[x % N] + y) % N] % C. Both divide N, and are N but for permutations that
/// chance hardly makes unless N is small. The search takes O(N) for each divisor of N.
HashPeriod permutation_period(std::span<const std::uint32_t> permutation, Color colors);

}
