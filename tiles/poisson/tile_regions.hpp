// The regions that a Poisson disk (sphere) radius divides tiles into.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 4.3, 4.5 and 4.6, figures 4.3 and 4.31. The
// lattice of tiles has cells of every dimension: corners (lattice points), edges, in 3D faces, and the tiles
// themselves. Each cell has a region: strips (slabs) of the radius' width on each side of edges (faces),
// enlarged regions around cells of lower dimension such that regions of different cells of the same dimension
// are at least two radii apart, and the interior, which is the rest of a tile. In 2D the region of a corner
// is a regular octagon with sides of two radii, in 3D a great rhombicuboctahedron with such edges.
//
// Coordinates are integers, 65,536 units to the side of a tile, so that every decision is exact. Boundaries
// belong to the cell of higher dimension. Folded coordinates are the distances from the nearest lattice point
// along each axis; a position is in the region of
// - a corner, if in 2D both are below `pair_one` and their sum is below `pair_sum`; in 3D if all are below
//   `corner_one`, the sums of two below `corner_two`, and the sum of all below `corner_three`;
// - a 3D edge, if the two across it are below `pair_one` and their sum is below `pair_sum`;
// - a 2D edge, or a face, if the one across it is below `width`.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace poissonlab {

// Positions near a Poisson disk tile, in whole units of which a tile's side has 65,536.

/// A position on a torus of tiles, or a movement. In 2D the last coordinate is 0.
using TilePosition = std::array<std::int32_t, 3>;

inline constexpr int tile_bits = 16;
inline constexpr std::int32_t tile_units = 1 << tile_bits;

/// A cell of the lattice as seen from a tile: that tile's corner, edge, face or interior.
struct TileCell
{
    std::uint8_t axes = 0;  ///< bit k: the cell extends along axis k; 0: a corner
    std::uint8_t upper = 0; ///< bit k, for the other axes: the cell is at the tile's upper side

    bool operator==(const TileCell&) const = default;
};

/// The axes of the interior.
constexpr std::uint8_t all_axes(int dimension) { return static_cast<std::uint8_t>((1 << dimension) - 1); }

struct TileRegions
{
    int dimension = 2;
    std::int32_t width = 0; ///< of strips and slabs on each side: the radius, rounded up
    std::int32_t pair_one = 0;
    std::int32_t pair_sum = 0;
    std::int32_t corner_one = 0;
    std::int32_t corner_two = 0;
    std::int32_t corner_three = 0;

    /// The axes of the cell whose region these folded coordinates are in.
    std::uint8_t axes_at(const std::array<std::int32_t, 3>& folded) const;

    /// The cell whose region a position of a tile is in. Coordinates from 0 to tile_units - 1.
    TileCell cell_of(std::span<const std::uint16_t> position) const;

    /// The volume (area) of the whole region of a cell with these axes, on all sides of it; of the interior,
    /// that in one tile. Unit: that of a tile.
    double volume(std::uint8_t axes) const;

    bool operator==(const TileRegions&) const = default;
};

/// The modified regions, with enlarged corners. `width` in units.
TileRegions modified_regions(int dimension, std::int32_t width);

/// The regions without enlarged corners and edges: squares (cubes) of the radius' width at corners, bars of
/// that width at 3D edges (figures 4.3(a) and 4.30). For pictures: in 3D volume() does not hold.
TileRegions unmodified_regions(int dimension, std::int32_t width);

/// Strips of this width along the border of a square, without enlarged corners: the frame that the tiles of a
/// template have in common (section 4.4).
TileRegions frame_regions(std::int32_t width);

}
