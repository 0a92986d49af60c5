// The pieces that tiles of a Poisson tile set share: the points in the region of a corner, an edge or a face.
//
// A piece belongs to a cell of the lattice and reaches into all tiles around it. The tile set has a number of
// variants of each; a tile's colours say which are at its corners, edges and faces. The pieces of axes m (see
// TileCell) are
// - corner tiles: C^(corners of the cell). The digits are the colours of the cell's corners, the corner with
//   the lowest coordinates last, then along x, then along y, then along z.
// - edge tiles: edges C, by their colour. Corners C^4: the digits are the edges that leave it north, east,
//   south, west, most significant first.
// - template tiles: 1 each.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// Spreads the bits of `packed` over those that are set in `mask`, lowest first: numbers a cell's corners by
/// its axes.
unsigned deposit_bits(unsigned packed, unsigned mask);

/// The lattice point with these bits as coordinates, axis 0 lowest.
std::array<std::int8_t, 3> lattice_point(unsigned bits);

/// The number of variants of the piece with these axes; of the interior, the number of tiles.
std::uint32_t piece_count(const PoissonTileParameters& parameters, std::uint8_t axes);

/// A piece somewhere: its cell's lowest corner is the lattice point `base`.
struct PlacedPiece
{
    std::uint8_t axes = 0;
    std::array<std::int8_t, 3> base{}; ///< relative to the tile
    std::uint32_t variant = 0;

    bool operator==(const PlacedPiece&) const = default;
};

/// The colours of a corner tile's corners: number k has bit j set where it is at the upper side of axis j.
std::array<std::uint32_t, 8> corner_colors_of(std::uint32_t tile, int dimension, std::uint32_t colors);

/// The other way round.
std::uint32_t corner_tile_of(const std::array<std::uint32_t, 8>& corners, int dimension, std::uint32_t colors);

/// The colours of the twelve edges that a tile of an edge-based set has: its own north, east, south, west;
/// then those that stick out: at the north-east corner eastwards and northwards, at the south-east eastwards
/// and southwards, at the south-west westwards and southwards, at the north-west westwards and northwards.
/// Most significant first.
std::array<std::uint32_t, 12> edge_colors_of(std::uint32_t tile, std::uint32_t colors);
std::uint32_t edge_tile_of(const std::array<std::uint32_t, 12>& edges, std::uint32_t colors);

/// The pieces around a tile: 4 corners and 4 edges in 2D; 8 corners, 12 edges and 6 faces in 3D. Corners
/// first.
std::vector<PlacedPiece> pieces_around(const PoissonTileParameters& parameters, std::uint32_t tile);

/// The piece of a corner-based set whose cell has corners with these colours: number k has bit j set where it
/// is at the upper side of the cell's axis j (axes that the cell has not are skipped).
std::uint32_t corner_piece(std::span<const std::uint32_t> colors_of_corners, std::uint32_t colors);

}
