#include "tiles/polyominoes/frequencies.hpp"

#include <algorithm>
#include <cstdint>

namespace poissonlab {
namespace {

constexpr int divisions = 4;

/// A share that keeps its place among the others while it dies out.
constexpr double least_frequency = 1e-6;

/// A class or pair, and one that follows from it by a division.
struct Descent
{
    std::size_t parent;
    std::size_t child;
};

std::vector<Descent> all_descents(const Neighbourhoods& all)
{
    std::vector<Descent> descents;
    const std::size_t classes = all.collars.size();
    const auto add_pairs = [&](std::size_t parent, const NearTiles& tiles) {
        for_near_children(all, tiles, [&](const NearTiles& pair) {
            const auto found = std::ranges::lower_bound(all.pairs, pair);
            descents.push_back({parent, classes + static_cast<std::size_t>(found - all.pairs.begin())});
        });
    };
    for (std::uint32_t c = 0; c < classes; ++c) {
        for (std::size_t i = 0; i < all.rule.children.size(); ++i) descents.push_back({c, all.child_class(c, i)});
        add_pairs(c, {c, c, Pose{}});
    }
    for (std::size_t i = 0; i < all.pairs.size(); ++i) add_pairs(classes + i, all.pairs[i]);
    return descents;
}

}

std::vector<double> frequencies_of(const Neighbourhoods& neighbourhoods)
{
    const std::vector<Descent> descents = all_descents(neighbourhoods);
    const std::size_t classes = neighbourhoods.collars.size();
    const double part = 1 / static_cast<double>(neighbourhoods.rule.children.size());
    std::vector<double> frequencies(classes + neighbourhoods.pairs.size(), 1 / static_cast<double>(classes));
    for (int i = 0; i < divisions; ++i) {
        std::vector<double> next(frequencies.size(), least_frequency);
        for (const auto& [parent, child] : descents) next[child] += part * frequencies[parent];
        frequencies = std::move(next);
    }
    return frequencies;
}

}
