// Random permutations: the tables that hash functions look up.
#pragma once

#include "base/random/random.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// A permutation of 0, 1, ..., size - 1, all of them equally likely (Fisher and Yates). Tables with different
/// numbers are independent. `size` below 2^31.
std::vector<std::uint32_t> random_permutation(std::uint32_t size, const StreamKey& key, std::uint32_t table);

}
