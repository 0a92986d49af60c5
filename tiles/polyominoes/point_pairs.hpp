// Pairs of points that tilings with polyominoes can have near each other: all of them, by the automaton of
// neighbourhoods.
#pragma once

#include "tiles/polyominoes/neighbourhoods.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// The tiles that keep their points, and the entries of the table that say where these are: a tile's number among the
/// divisions of its `depth`-th ancestor, and that ancestor's class.
///
/// Children are in the order in which they get points. The number's digits in base k^2 are those of the children on the
/// way from the ancestor, the last one being the most significant: tiles with numbers below `kept` have points.
struct KeptTiles
{
    const Neighbourhoods& neighbourhoods;
    std::uint32_t depth = 1;
    std::uint32_t kept = 1;

    std::uint64_t numbers() const ///< k^2 to the power of depth
    {
        std::uint64_t count = 1;
        for (std::uint32_t i = 0; i < depth; ++i) count *= neighbourhoods.rule.children.size();
        return count;
    }
};

/// A tile with a point; `entry` is class * numbers + number.
struct TableTile
{
    Pose pose;
    std::uint32_t entry = 0;
};

/// Visits pairs of different tiles with points, each once from either side for each group of ancestors that has it.
class PairSearch
{
public:
    /// Tiles have an ancestor `levels` divisions ago that is the same one, or these ancestors are near; `levels` is at
    /// least the depth. `reach`: the distance of their middles up to which pairs are surely visited, in cells.
    PairSearch(const KeptTiles& tiles, std::uint32_t levels, double reach);

    /// Calls `action(TableTile, TableTile, origin)` with where they come from: the ancestors' class if they are the
    /// same tile, else the number of classes plus that of the pair.
    template <class Action>
    void run(const Action& action) const
    {
        run(tiles_.neighbourhoods.pairs, action);
    }

    /// Calls `action` for pairs of tiles whose ancestors are the same tile or one of the pairs `pairs`, which need not
    /// be near.
    template <class Action>
    void run(const std::vector<NearTiles>& pairs, const Action& action) const
    {
        const std::size_t classes = tiles_.neighbourhoods.collars.size();
        for (std::uint32_t i = 0; i < classes; ++i) descend(start(i, Pose{}), start(i, Pose{}), levels_, i, action);
        for (std::size_t i = 0; i < pairs.size(); ++i)
            descend(start(pairs[i].first, Pose{}), start(pairs[i].second, pairs[i].pose), levels_, classes + i, action);
    }

    /// The distance of two ancestors' middles up to which their points are surely visited, in cells of theirs.
    double reach_of_ancestors() const { return reach_.back(); }

private:
    /// A tile on the way to its descendants.
    struct Ancestor
    {
        Pose pose;
        std::uint32_t tile_class = 0;
        std::uint32_t entry_class = 0; ///< of the ancestor that the table is about, once it was passed
        std::uint64_t number = 0;      ///< below that one
    };

    Ancestor start(std::uint32_t tile_class, const Pose& pose) const { return {pose, tile_class, tile_class, 0}; }

    /// Children of which some descendants have points; `left`: divisions from the parent on.
    std::vector<Ancestor> children(const Ancestor& parent, std::uint32_t left) const;

    bool are_far(const Ancestor& a, const Ancestor& b, std::uint32_t left) const;

    TableTile table_tile(const Ancestor& tile) const
    {
        return {tile.pose, static_cast<std::uint32_t>(tile.entry_class * numbers_ + tile.number)};
    }

    template <class Action>
    void descend(const Ancestor& a, const Ancestor& b, std::uint32_t left, std::size_t origin,
                 const Action& action) const
    {
        if (are_far(a, b, left)) return;
        if (left == 0) {
            if (a.pose != b.pose) action(table_tile(a), table_tile(b), origin);
            return;
        }
        const std::vector<Ancestor> firsts = children(a, left), seconds = children(b, left);
        for (const Ancestor& first : firsts)
            for (const Ancestor& second : seconds) descend(first, second, left - 1, origin, action);
    }

    KeptTiles tiles_;
    std::uint64_t numbers_;
    std::uint32_t levels_;
    LatticePlace centroid_; ///< in parts of a cell: over `parts_`
    double parts_;
    std::vector<double> reach_;         ///< of tiles with so many divisions to come, in their own cells
    std::vector<std::uint64_t> weight_; ///< of the digit of a child with so many divisions to come
};

// Pairs of tiles farther apart than near ones, which tilings with polyominoes can have.
//
// Along the line between two tiles of a tiling one tile follows another, each touching the next. So all pairs are found
// by going from near tile to near tile; what comes of it are all pairs that a tiling can have, and perhaps some more,
// of tiles whose neighbourhoods fit each other although no tiling has both.

/// The distance of a tile's middle from its farthest corner is 2.23 cells at most.
inline constexpr double tile_radius = 2.25;

/// All pairs of tiles of tilings, near ones among them, whose middles are at most `reach` cells apart; each pair from
/// either side, ascending.
std::vector<NearTiles> pairs_within(const Neighbourhoods& neighbourhoods, double reach);

}
