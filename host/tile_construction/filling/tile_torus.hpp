// The torus of two tiles a side on which tiles are filled with points: its cells, and movement among them.
//
// Two tiles a side are enough that the points of a piece do not see themselves around the torus. Coordinates
// are whole units, 65,536 to a tile's side. kernels/common/tiles/tile_torus.clh makes the same decisions.
#pragma once

#include "tiles/poisson/tile_regions.hpp"

#include <array>
#include <cstdint>
#include <span>

namespace poissonlab {

inline constexpr std::int32_t torus_units = 2 * tile_units;

/// Coordinates on the torus, 0 to torus_units - 1.
constexpr std::int32_t wrapped(std::int32_t coordinate) { return coordinate & (torus_units - 1); }

/// The shortest difference that is a multiple of the torus away, -tile_units to tile_units - 1.
constexpr std::int32_t shortest(std::int32_t difference) { return wrapped(difference + tile_units) - tile_units; }

/// Exact.
std::uint64_t squared_distance(const TilePosition& a, const TilePosition& b, int dimension);

/// The number of a cell of the torus' lattice: its axes, and above them the coordinates of its lowest corner,
/// a bit an axis.
constexpr unsigned cell_number(unsigned axes, unsigned base, int dimension) { return base << dimension | axes; }

/// Cells as bits by their numbers.
using CellSet = std::uint64_t;

/// All cells: 16 or 64.
constexpr CellSet all_cells(int dimension) { return dimension == 2 ? 0xffff : ~CellSet{0}; }

/// The number of the cell whose region a position is in.
unsigned cell_at(const TileRegions& regions, const TilePosition& position);

/// The places where points may lie: some cells or, in 2D, the inside of a polygon around the tile at (0, 0), if that
/// has corners.
struct Zone
{
    TileRegions regions;
    CellSet cells = 0;
    std::span<const TilePosition> polygon = {};
    bool keeps_tiles = false; ///< a movement does not leave the tile that it starts in
};

bool is_allowed(const Zone& zone, const TilePosition& position);

/// A position out of the region of its corner, edge or face, by the shortest way; in an interior, the same
/// position.
TilePosition pushed_out(const TileRegions& regions, const TilePosition& position);

/// Shortens a movement to `limit` at most, and rounds it to whole units.
TilePosition limited_movement(const std::array<double, 3>& sum, double limit, int dimension);

/// The end of a movement from an allowed position; in the plane the third coordinate, which may be a class, stays. A
/// movement that would end elsewhere slides out of regions by the shortest way, three times at most, or is shortened to
/// the last position that is allowed.
TilePosition allowed_end(const Zone& zone, const TilePosition& start, const TilePosition& movement, bool slides);

}
