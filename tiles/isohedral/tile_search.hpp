// The search for isohedral tiles that look like a goal: Kaplan and Salesin, Escherization, 2000.
//
// The places of a tile's corners on the goal's outline are searched; tile_fit.hpp finds the rest in closed form. All
// ways to cut an outline of 36 equal steps into the edges of a type are tried, as Nagata and Imahori, An efficient
// exhaustive search algorithm for the Escherization problem, 2020, do. Of the best cut at each of the 36 starts, the 16
// best of each type go on, if they are near enough to the best of all: their corners move along the outline until no
// move brings the tile nearer. Of the tiles whose outline does not cross itself, the one whose
// directions differ least from the goal's is the best: Kaplan and Salesin measure this as well. Tiles with slivers come
// after all others.
#pragma once

#include "tiles/isohedral/goal_outline.hpp"
#include "tiles/isohedral/isohedral_tile.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

struct GoalTile
{
    int type = 0;
    bool is_mirrored = false; ///< it is a tile of mirrored_type(), of which its parameters are
    IsohedralParameters parameters;
    /// The root of the sum of squared differences of steps over that of the goal's steps: 0 for a goal that is a tile,
    /// and at most 1.
    double distance = 0;
    double turning = 0;     ///< turning_distance() of 72 places on both outlines
    bool is_narrow = false; ///< some part of it is less than a third as wide as in the goal
    /// The map of the goal, whose perimeter is 1, to the tile of IsohedralTile: times `scale`, a complex number, and
    /// then moved.
    PlanePoint scale{1, 0}, shift{};
};

/// The type that a found tile's parameters are of.
const IsohedralType& type_of(const GoalTile& tile);

struct GoalSearch
{
    std::vector<GoalTile> tiles;  ///< the best of each type that has one near enough, the best first
    std::uint64_t candidates = 0; ///< tiles that were compared
};

/// Searches these types, numbers of isohedral_types(), and their mirror images where these are others: some seconds for
/// all of them. Types whose tiles differ from the goal twice as much as the best have none. Throws Interrupted.
GoalSearch tiles_like(const GoalOutline& goal, const std::vector<int>& types);

}
