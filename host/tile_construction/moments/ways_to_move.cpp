#include "host/tile_construction/moments/ways_to_move.hpp"

namespace poissonlab {

std::vector<std::uint64_t> all_sums(const std::vector<std::vector<std::uint64_t>>& terms)
{
    std::vector<std::uint64_t> sums{0};
    for (const auto& list : terms) {
        std::vector<std::uint64_t> longer;
        longer.reserve(sums.size() * list.size());
        for (const std::uint64_t term : list)
            for (const std::uint64_t sum : sums) longer.push_back(sum + term);
        sums = std::move(longer);
    }
    return sums;
}

}
