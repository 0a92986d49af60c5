#include "tiles/polyominoes/point_pairs.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <unordered_set>

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

namespace {

/// A tile with those that touch it, by cells.
class CollaredTile
{
public:
    CollaredTile(const Neighbourhoods& all, std::uint32_t tile_class) : all_(all)
    {
        owners_.fill(-1);
        tiles_.push_back(Pose{});
        tiles_.insert(tiles_.end(), all.collars[tile_class].begin(), all.collars[tile_class].end());
        for (std::size_t i = 0; i < tiles_.size(); ++i)
            for (const LatticePlace& cell : cells_of(all.rule.shape))
                if (const auto index = index_of(moved_cell(tiles_[i], cell)); index < owners_.size())
                    owners_[index] = static_cast<int>(i);
    }

    /// True if a tile of a class, and all that touch it, can be in this pose: where they have cells of the patch, they
    /// are the tiles of the patch.
    bool can_have(std::uint32_t tile_class, const Pose& pose) const
    {
        if (!can_have(pose)) return false;
        return std::ranges::all_of(all_.collars[tile_class],
                                   [&](const Pose& other) { return can_have(composed(pose, other)); });
    }

private:
    /// Cells of tiles that touch one lie within this many of its origin.
    static constexpr std::int64_t extent = 12;
    static constexpr std::int64_t side = 2 * extent;

    static std::size_t index_of(const LatticePlace& cell)
    {
        const LatticePlace at = cell + LatticePlace{extent, extent};
        const bool is_inside = at.x >= 0 && at.y >= 0 && at.x < side && at.y < side;
        return is_inside ? static_cast<std::size_t>(at.y * side + at.x) : static_cast<std::size_t>(side * side);
    }

    bool can_have(const Pose& tile) const
    {
        return std::ranges::all_of(cells_of(all_.rule.shape), [&](const LatticePlace& cell) {
            const std::size_t index = index_of(moved_cell(tile, cell));
            return index == owners_.size() || owners_[index] < 0 ||
                   tiles_[static_cast<std::size_t>(owners_[index])] == tile;
        });
    }

    const Neighbourhoods& all_;
    std::vector<Pose> tiles_;
    std::array<int, static_cast<std::size_t>(side* side)> owners_{}; ///< tiles of cells; -1: none
};

/// The squared distance of the middles of a tile and another one, in parts of a cell: over twice the number of cells.
double squared_step(Polyomino shape, const Pose& other)
{
    const auto parts = static_cast<std::int64_t>(2 * cells_of(shape).size());
    const LatticePlace sum = centroid_sum(shape);
    const LatticePlace step = turned(other.turn, sum) - sum + parts * other.shift;
    const auto x = static_cast<double>(step.x) / static_cast<double>(parts);
    const auto y = static_cast<double>(step.y) / static_cast<double>(parts);
    return x * x + y * y;
}

/// The tiles that can be seen from one of a class.
class View
{
public:
    View(const Neighbourhoods& all, std::uint32_t first) : all_(all), first_(first), patch_(all, first) {}

    std::vector<NearTiles> within(double reach)
    {
        // A tile on the way meets the line, and so its middle is not farther from it than its radius.
        if (reach + tile_radius > farthest_way) throw std::logic_error("tiles are looked for too far away");
        const double way = (reach + tile_radius) * (reach + tile_radius);
        std::vector<NearTiles> open{{first_, first_, Pose{}}}, found;
        std::unordered_set<std::uint64_t> known{key_of(open.back())};
        while (!open.empty()) {
            const NearTiles from = open.back();
            open.pop_back();
            const auto begin = std::ranges::lower_bound(all_.pairs, from.second, {}, &NearTiles::first);
            for (auto pair = begin; pair != all_.pairs.end() && pair->first == from.second; ++pair) {
                const NearTiles next{first_, pair->second, composed(from.pose, pair->pose)};
                const double squared = squared_step(all_.rule.shape, next.pose);
                if (squared > way || !known.insert(key_of(next)).second || !is_possible(next)) continue;
                open.push_back(next);
                if (squared <= reach * reach) found.push_back(next);
            }
        }
        std::ranges::sort(found);
        return found;
    }

private:
    static constexpr double farthest_way = 2000; ///< cells

    /// Different numbers for different tiles of views that are less than 4,096 cells wide.
    static std::uint64_t key_of(const NearTiles& pair)
    {
        const auto low_bits = [](std::int64_t x) { return static_cast<std::uint64_t>(x) & 0xfff; };
        const std::uint64_t place = low_bits(pair.pose.shift.x) << 12 | low_bits(pair.pose.shift.y);
        return std::uint64_t{pair.second} << 32 | place << 8 | static_cast<std::uint64_t>(pair.pose.turn);
    }

    bool is_possible(const NearTiles& pair) const
    {
        if (pair.pose == Pose{}) return false;
        if (is_near(all_.rule.shape, pair.pose)) return std::ranges::binary_search(all_.pairs, pair);
        return patch_.can_have(pair.second, pair.pose);
    }

    const Neighbourhoods& all_;
    std::uint32_t first_;
    CollaredTile patch_;
};

}

std::vector<NearTiles> pairs_within(const Neighbourhoods& all, double reach)
{
    std::vector<std::vector<NearTiles>> views(all.collars.size());
    tbb::parallel_for(std::size_t{0}, views.size(),
                      [&](std::size_t i) { views[i] = View(all, static_cast<std::uint32_t>(i)).within(reach); });
    std::vector<NearTiles> pairs;
    for (const auto& view : views) pairs.insert(pairs.end(), view.begin(), view.end());
    return pairs;
}

}
