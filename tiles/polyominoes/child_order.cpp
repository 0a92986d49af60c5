#include "tiles/polyominoes/child_order.hpp"

#include <algorithm>
#include <limits>

namespace poissonlab {
namespace {

/// Squared distances of the nearest copies of children i and j, [i * k^2 + j], in a unit that all have in common.
std::vector<std::int64_t> child_distances(const Neighbourhoods& all)
{
    const std::size_t count = all.rule.children.size();
    const std::int64_t parts = 2 * static_cast<std::int64_t>(cells_of(all.rule.shape).size());
    const LatticePlace centroid = centroid_sum(all.rule.shape);
    const auto middle = [&](const Pose& tile) { return turned(tile.turn, centroid) + parts * tile.shift; };
    std::vector<std::int64_t> nearest(count * count, std::numeric_limits<std::int64_t>::max());
    const auto compare = [&](const Pose& parent) {
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < count; ++j) {
                const Pose child = all.rule.child(parent, j);
                if (child == all.rule.children[i]) continue;
                const LatticePlace d = middle(child) - middle(all.rule.children[i]);
                std::int64_t& least = nearest[i * count + j];
                least = std::min(least, d.x * d.x + d.y * d.y);
            }
    };
    compare(Pose{});
    std::vector<Pose> poses;
    for (const NearTiles& pair : all.pairs) poses.push_back(pair.pose);
    std::ranges::sort(poses);
    const auto doubles = std::ranges::unique(poses);
    poses.erase(doubles.begin(), doubles.end());
    for (const Pose& pose : poses) compare(pose);
    return nearest;
}

}

std::vector<std::uint32_t> farthest_children(const Neighbourhoods& neighbourhoods)
{
    const std::size_t count = neighbourhoods.rule.children.size();
    const std::vector<std::int64_t> distances = child_distances(neighbourhoods);
    std::vector<std::int64_t> gap; // to the copies of children that are chosen, and to its own
    for (std::size_t i = 0; i < count; ++i) gap.push_back(distances[i * count + i]);
    std::vector<std::uint32_t> order;
    while (order.size() < count) {
        const auto best = static_cast<std::size_t>(std::ranges::max_element(gap) - gap.begin());
        order.push_back(static_cast<std::uint32_t>(best));
        for (std::size_t i = 0; i < count; ++i) gap[i] = std::min(gap[i], distances[best * count + i]);
        for (const std::uint32_t chosen : order) gap[chosen] = -1;
    }
    return order;
}

Neighbourhoods with_children_in_order(const Neighbourhoods& neighbourhoods, const std::vector<std::uint32_t>& order)
{
    Neighbourhoods ordered = neighbourhoods;
    for (std::size_t i = 0; i < order.size(); ++i) {
        ordered.rule.children[i] = neighbourhoods.rule.children[order[i]];
        for (std::uint32_t c = 0; c < neighbourhoods.collars.size(); ++c)
            ordered.next[c * order.size() + i] = neighbourhoods.child_class(c, order[i]);
    }
    return ordered;
}

}
