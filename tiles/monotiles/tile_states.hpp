// The tiles of an aperiodic monotile by what lies around them: a substitution of finitely many states, and all pairs of
// tiles that its tilings have near each other.
//
// A state says more than a prototile: which tiles lie around it, and which parts of which tiles its ancestors are. The
// collar of a tile has the tiles that touch it, and those that have to be known so that a tile's collar decides those
// of its parts. All states that occur follow from one of them by divisions until nothing new comes. Near tiles are
// parts of the same tile or of near ones, because each division enlarges places by more than parts lie away from their
// tile; so that all pairs follow from the parts of single tiles by divisions, until nothing new comes. What comes of it
// are all states and pairs of every tiling whose patches occur in divisions of single tiles, and no others. For the
// tilings see tiles/prototiles/substitution.hpp.
#pragma once

#include "tiles/prototiles/polygon_tiling.hpp"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace poissonlab {

/// A motion by a turn in sixths about the origin, and a translation.
struct TileFrame
{
    RingPlace at;
    int turn = 0; ///< 0 to 5

    auto operator<=>(const TileFrame&) const = default;
};

/// A tile of a state in the frame of another one.
struct StatePart
{
    std::uint32_t state = 0;
    TileFrame frame;

    auto operator<=>(const StatePart&) const = default;
};

/// Two tiles of a tiling, the second as seen from the first.
struct StatePair
{
    std::uint32_t first = 0;
    StatePart second;

    auto operator<=>(const StatePair&) const = default;
};

/// A substitution of states. A level that is mirrored is looked at in a mirror, so that frames only turn.
struct TileStates
{
    const PolygonTiling* tiling = nullptr;
    bool flips = false;                        ///< each division mirrors what it makes
    std::vector<TileMotion> own;               ///< of a prototile in its frame: a mirror, and up to a twelfth of a turn
    std::vector<std::uint32_t> prototiles;     ///< by state
    std::vector<std::vector<StatePart>> parts; ///< by state, in the order of the prototile's parts
};

/// The states are the prototiles. Keeps a reference to the tiling, which is one of 12 directions by substitution, of
/// whose parts those that are divided have turns by sixths only. Throws std::logic_error for others.
TileStates prototile_states(const PolygonTiling& tiling);

/// The states are the collars that tilings of the start have.
TileStates collared_states(const PolygonTiling& tiling, std::size_t start);

/// The states are those of the parent, and the number of the part: as many as all states have parts.
TileStates with_parents(const TileStates& states);

/// How often each state occurs among all tiles, in the limit of many divisions.
std::vector<double> frequencies_of(const TileStates& states);

struct StatePairs
{
    std::vector<StatePair> pairs;    ///< ascending; each from either side
    std::vector<double> frequencies; ///< how many there are a tile, in the limit of many divisions
};

/// All pairs of tiles whose frames' origins are at most `reach` apart, and some more.
StatePairs pairs_within(const TileStates& states, double reach);

/// The states of the tiles of a start, so that all of its tilings have the states and pairs that follow.
std::vector<std::uint32_t> start_states(const TileStates& states, std::size_t start);

/// Returns the frame of a tile of a level that is not mirrored.
TileFrame frame_of(const TileStates& states, const PlacedTile& tile);

/// The number of a start that covers the plane: the one named "plane", or the first one.
std::size_t plane_start(const PolygonTiling& tiling);

}
