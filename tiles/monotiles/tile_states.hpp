// States of the tiles of an aperiodic monotile by the tiles around them: a substitution of finitely many states, and
// all pairs of tiles that are near each other in its tilings.
//
// A state refines a prototile by the tiles around it, and by the parts that its ancestors are of their tiles. The
// collar of a tile has the tiles that touch it, and the tiles that must be known so that a tile's collar decides the
// collars of its parts. Divisions of one state give all states, until no new one occurs. Near tiles are parts of the
// same tile or of near tiles, because each division enlarges distances by more than parts reach beyond their tile;
// therefore divisions of single tiles give all pairs, until no new one occurs. The result has all states and pairs of
// every tiling whose patches occur in divisions of single tiles, and no others. For the tilings see
// tiles/prototiles/substitution.hpp.
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

/// A substitution of states. A mirrored level is described by its mirror image, so that frames only turn.
struct TileStates
{
    const PolygonTiling* tiling = nullptr;
    bool flips = false;          ///< each division mirrors what it makes
    std::vector<TileMotion> own; ///< motions of prototiles in their frames: a mirror, and up to a twelfth of a turn
    std::vector<std::uint32_t> prototiles;     ///< the prototile of each state
    std::vector<std::vector<StatePart>> parts; ///< the parts of each state, in the order of the prototile's parts
};

/// Returns the prototiles as states. Keeps a reference to the tiling, which must be a substitution with 12 directions
/// whose divided parts are turned by sixths only. Throws std::logic_error for others.
TileStates prototile_states(const PolygonTiling& tiling);

/// Returns the collars that tilings of the start have as states.
TileStates collared_states(const PolygonTiling& tiling, std::size_t start);

/// Returns a state for each part of each state: the parent's state and the number of the part.
TileStates with_parents(const TileStates& states);

/// Returns the frequency of each state among all tiles, in the limit of many divisions.
std::vector<double> frequencies_of(const TileStates& states);

struct StatePairs
{
    std::vector<StatePair> pairs;    ///< ascending; each pair comes twice, seen from either tile
    std::vector<double> frequencies; ///< the number of such pairs per tile, in the limit of many divisions
};

/// Returns all pairs of tiles whose frames' origins are at most `reach` apart, and some more.
StatePairs pairs_within(const TileStates& states, double reach);

/// Returns states for the tiles of a start, so that all of its tilings have only states and pairs of this substitution.
std::vector<std::uint32_t> start_states(const TileStates& states, std::size_t start);

/// Returns the frame of a tile of a level that is not mirrored.
TileFrame frame_of(const TileStates& states, const PlacedTile& tile);

/// Returns the frame of a part of a tile after the division, from the part's frame in its tile.
TileFrame frame_of_part(const TileStates& states, const TileFrame& whole, const TileFrame& part);

/// Returns the number of a start that covers the plane: the one named "plane", or the first one.
std::size_t plane_start(const PolygonTiling& tiling);

}
