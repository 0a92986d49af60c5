#include "tiles/tilings/random_permutation.hpp"

#include "base/random/random_words.hpp"

#include <numeric>
#include <utility>

namespace poissonlab {
std::vector<std::uint32_t> random_permutation(std::uint32_t size, const StreamKey& key, std::uint32_t table)
{
    std::vector<std::uint32_t> permutation(size);
    std::iota(permutation.begin(), permutation.end(), 0u);
    RandomWords words(key, table);
    for (std::uint32_t remaining = size; remaining > 1; --remaining)
        std::swap(permutation[remaining - 1], permutation[words.below(remaining)]);
    return permutation;
}

}
