#include "tiles/polyominoes/point_pairs.hpp"

#include "tiles/polyominoes/farther_pairs.hpp"

namespace poissonlab {
PairSearch::PairSearch(const KeptTiles& tiles, std::uint32_t levels, double reach)
    : tiles_(tiles), numbers_(tiles.numbers()), levels_(levels),
      centroid_(centroid_sum(tiles.neighbourhoods.rule.shape)),
      parts_(2 * static_cast<double>(cells_of(tiles.neighbourhoods.rule.shape).size()))
{
    double scale = 1;
    std::uint64_t weight = numbers_;
    for (std::uint32_t left = 0; left <= levels; ++left) {
        reach_.push_back(reach / scale + (left == 0 ? 0 : 2 * tile_radius));
        scale *= static_cast<double>(tiles.neighbourhoods.rule.factor);
        weight = left < tiles.depth ? weight / tiles.neighbourhoods.rule.children.size() : 0;
        weight_.push_back(weight);
    }
}

std::vector<PairSearch::Ancestor> PairSearch::children(const Ancestor& parent, std::uint32_t left) const
{
    const Neighbourhoods& all = tiles_.neighbourhoods;
    std::vector<Ancestor> found;
    for (std::uint32_t i = 0; i < all.rule.children.size(); ++i) {
        Ancestor child{all.rule.child(parent.pose, i), all.child_class(parent.tile_class, i), parent.entry_class,
                       parent.number + i * weight_[left - 1]};
        if (left > tiles_.depth) child.entry_class = child.tile_class;
        if (left == 1 && child.number >= tiles_.kept) break;
        found.push_back(child);
    }
    return found;
}

bool PairSearch::are_far(const Ancestor& a, const Ancestor& b, std::uint32_t left) const
{
    const auto parts = static_cast<std::int64_t>(parts_);
    const LatticePlace difference =
        turned(b.pose.turn, centroid_) - turned(a.pose.turn, centroid_) + parts * (b.pose.shift - a.pose.shift);
    const auto x = static_cast<double>(difference.x), y = static_cast<double>(difference.y);
    const double reach = reach_[left] * parts_;
    return x * x + y * y > reach * reach;
}

}
