#include "host/tile_construction/moments/ways_to_move.hpp"

#include <span>

namespace poissonlab {
namespace {

std::vector<std::uint64_t> all_sums(std::span<const std::vector<std::uint64_t>> terms)
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

Sums::Sums(const std::vector<std::vector<std::uint64_t>>& terms)
    : low_(all_sums(std::span(terms).first(terms.size() / 2))),
      high_(all_sums(std::span(terms).subspan(terms.size() / 2)))
{}

}
