// Points in the tiles of an aperiodic monotile: a table of places in a tile's own frame has one row for each state of a
// tile. All rows are relaxed together for all tilings, and all pairs of tiles prove their minimum distance.
//
// The method is that of polyominoes (tiles/polyominoes, after Ostromoukhov 2007) with tiles by Smith, Myers, Kaplan and
// Goodman-Strauss (arXiv 2303.10798, 2305.17743).
#pragma once

#include "tiles/monotiles/tile_states.hpp"
#include "tiles/prototiles/substitution.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// The place x + y i of the ring, in parts of an edge, over place_units: x counts in the first of the tiling's lengths,
/// y in the second.
struct MonotilePlace
{
    std::int32_t x = 0;
    std::int32_t y = 0;

    bool operator==(const MonotilePlace&) const = default;
};
inline constexpr std::int64_t place_units = 1 << 16;

/// The squared length whole + root * sqrt(3), in squares of the unit of lengths over place_units.
struct SquaredLength
{
    std::int64_t whole = 0;
    std::int64_t root = 0;

    bool operator==(const SquaredLength&) const = default;
    std::strong_ordering operator<=>(const SquaredLength& other) const; ///< exact
    double length() const;                                              ///< in units of lengths
};

/// Returns the squared length of a difference of places over place_units. The squares of the tiling's lengths must be 1
/// or 3.
SquaredLength squared_length(const PolygonTiling& tiling, const RingPlace& difference);

struct MonotileTable
{
    TileStates states;
    std::uint32_t points = 1;          ///< the number of points of a tile
    std::vector<MonotilePlace> places; ///< [state * points + number]

    /// [k - 1]: the least squared distance of points with numbers below k; some pair of points in every tiling has it.
    std::vector<SquaredLength> distances;
};

/// Builds places at equal parts of each tile, moved by the state of the tile, in an order whose prefixes have large
/// distances: again and again, the last one of the points left is the one without which the others have the largest
/// distance. `levels` is the number of ancestors whose parts distinguish states, beside the collars. `on_step` is told
/// of the steps; what it throws ends the work.
MonotileTable build_monotile_table(const PolygonTiling& tiling, std::uint32_t points, std::uint32_t levels,
                                   const std::function<void(const std::string& what)>& on_step = {});

/// Returns the states of a table: collars, and the parts of `levels` ancestors.
TileStates monotile_states(const PolygonTiling& tiling, std::uint32_t levels);

/// Returns [i * points + j]: the least squared distance of points with numbers i and j in any tiling. Where `promised`
/// has what `distances` of the table are said to be, the search ends at the first pair that is nearer.
std::vector<SquaredLength> least_distances(const MonotileTable& table, const std::vector<SquaredLength>& promised = {});

/// Returns what `distances` of the table must be, from its least_distances().
std::vector<SquaredLength> distances_of_prefixes(const std::vector<SquaredLength>& least, std::uint32_t points);

/// Says whether all points lie where build_monotile_table() may put them: farther away, they would be near the points
/// of so many tiles that a proof takes long.
bool are_near_their_tiles(const MonotileTable& table);

/// Returns the distance of the densest packing with so many points in each tile.
double densest_distance(const MonotileTable& table, std::uint32_t kept);

/// Returns the number of points per unit of area.
double monotile_density(const MonotileTable& table, std::uint32_t kept);

/// Points of a tiling by its table. Keeps a reference to both of them.
class MonotilePoints
{
public:
    explicit MonotilePoints(const MonotileTable& table);

    /// Returns the place of the tile around a point, which is at most `farthest` away from the origin. Differences of
    /// places of tiles are small integers, and so exact as doubles; those of other places of the ring need not be.
    RingPlace tile_at(const std::array<double, 2>& point) const;

    /// Returns the points with numbers below `kept` in a square whose middle is `shift` away from the place of a tile,
    /// from -1/2 to 1/2 of its side, in the order of the addresses of their tiles. Shift and side are in units of
    /// lengths.
    std::vector<std::array<double, 2>> square(const RingPlace& middle, double side, std::uint32_t kept,
                                              const std::array<double, 2>& shift = {}) const;

    static constexpr double farthest = 0x1p31;

private:
    const MonotileTable& table_;
    Substitution substitution_;
    std::vector<std::uint32_t> start_;
    double overhang_ = 0; ///< the largest distance of a point from its tile's origin
};

}
