// Hash functions as kernels/common/tiles/tiling.clh takes them: an array of words, of which the first is a tag.
#pragma once

#include <cstdint>

namespace poissonlab {

constexpr std::uint32_t permutation_hash_tag = 0; ///< then: colors, size, entries
constexpr std::uint32_t long_period_hash_tag = 1; ///< then: colors, number of tables, sizes, entries
constexpr std::uint32_t xxh64_hash_tag = 2;       ///< then: colors, seed (low word, high word)

}
