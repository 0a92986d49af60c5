// All neighbourhoods that tiles have after divisions, whatever they started from: an automaton, and a proof's cases.
//
// The collar of a tile is the set of tiles that touch it, at edges or corners, as seen from it. The collar of a child
// follows from its parent's collar and its own number. Around a corner of the lattice there are 2 x 2 cells, which
// belong to at most four tiles: finitely many such figures are possible, and every group of tiles that fits into k^m +
// 1 cells along both axes lies, m divisions before, within one of them. So all collars and all pairs of touching tiles
// after m divisions are found in the divisions of these figures, and those of all later ones by the automaton: for
// every tiling that a division can start from, of the plane or of a torus. m is 3 for P and 1 for G.
#pragma once

#include "tiles/polyominoes/polyomino.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

/// Divisions after which neighbourhoods are those of the automaton: m.
constexpr std::uint32_t first_level_of(Polyomino shape) { return shape == Polyomino::P ? 3 : 1; }

/// Tiles that touch a tile, as seen from it, ascending.
using Collar = std::vector<Pose>;

/// A tile and another one that is at most one cell away from it, as seen from it. Each pair is there once from either
/// side. The parents of such tiles are the same tile, or touch.
struct NearTiles
{
    std::uint32_t first = 0;  ///< class
    std::uint32_t second = 0; ///< class
    Pose pose;                ///< of the second

    auto operator<=>(const NearTiles&) const = default;
};

struct Neighbourhoods
{
    PolyominoRule rule;
    std::uint32_t first_level = 0;   ///< m, divisions after which nothing else occurs
    std::vector<Collar> collars;     ///< by class
    std::vector<std::uint32_t> next; ///< class of a child: [class * k^2 + child]
    std::vector<NearTiles> pairs;    ///< ascending

    std::uint32_t child_class(std::uint32_t parent, std::size_t child) const
    {
        return next[parent * rule.children.size() + child];
    }
};

/// The classes of tiles are numbered by the order of their collars' first occurrence.
Neighbourhoods neighbourhoods_of(const PolyominoRule& rule);

/// The class of a collar, or the number of classes if no tile has it.
std::uint32_t class_of(const Neighbourhoods& neighbourhoods, const Collar& collar);

/// True for tiles with at most one cell between them, one in the pose without turn and shift, the other in this one;
/// false for a tile and itself.
bool is_near(Polyomino shape, const Pose& other);

/// Calls `action` with each pair of near children, one of the first tile and one of the second, which are the same
/// tile for two children of one. Classes of children are known.
void for_near_children(const Neighbourhoods& neighbourhoods, const NearTiles& parents,
                       const std::function<void(const NearTiles&)>& action);

/// The collars of tiles all of whose neighbours are among `tiles`: an empty one for others. Tiles do not overlap.
std::vector<Collar> collars_within(Polyomino shape, const std::vector<Pose>& tiles);

/// The collars of the tiles of a torus of `period` x `period` cells. Tiles may meet their own copies.
std::vector<Collar> collars_on_torus(Polyomino shape, const std::vector<Pose>& tiles, std::int64_t period);

/// All ways in which tiles can share the four cells around the origin, but for turns about it: each ascending.
std::vector<std::vector<Pose>> corner_figures(Polyomino shape);

/// The tiles after some divisions, those of a parent one after the other.
std::vector<Pose> divided(const PolyominoRule& rule, std::vector<Pose> tiles, std::uint32_t divisions);

}
