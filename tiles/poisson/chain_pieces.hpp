// The pieces of corner tiles whose borders are chains: a point near each corner, and chains of points between them.
//
// docs/chain-tiles.md says what chains are for and proves what they keep apart. A piece is stored once, however many
// tiles have it. Coordinates are units, 65,536 to a tile's side.
#pragma once

#include "tiles/poisson/poisson_tile_set.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Chains go right (along axis 0) or up (along axis 1).
inline constexpr std::size_t chain_directions = 2;

/// Sets with chains store even coordinates only. Rounding two points to these takes up to so many units from their
/// distance.
inline constexpr double chain_rounding = 3;

/// The even coordinate at or above one.
constexpr std::int32_t storable(std::int32_t coordinate) { return (coordinate + 1) & ~1; }

/// The points of a chain between its corner points, from the lower corner on.
using Chain = std::vector<UnitPosition>;

struct ChainPieces
{
    std::uint32_t colors = 0;
    std::vector<UnitPosition> corners;                       ///< by colour, relative to the lattice point
    std::array<std::vector<Chain>, chain_directions> chains; ///< by chain_number(), relative to the lower corner
    std::vector<std::vector<UnitPosition>> interiors;        ///< by tile

    ChainPieces(std::uint32_t c, std::uint32_t tiles);

    bool operator==(const ChainPieces&) const = default;
};

/// The chain from a corner of the colour `lower` to one of the colour `upper`.
inline std::size_t chain_number(std::uint32_t lower, std::uint32_t upper, std::uint32_t colors)
{
    return std::size_t{lower} * colors + upper;
}

/// A chain somewhere near a tile.
struct PlacedChain
{
    std::size_t direction = 0;
    std::uint32_t lower = 0, upper = 0; ///< colours of its corners
    std::array<std::int32_t, 2> base{}; ///< the lattice point of its lower corner, relative to the tile

    std::size_t number(std::uint32_t colors) const { return chain_number(lower, upper, colors); }
};

/// The chains around a tile: the lower, the right, the upper, the left one. The first and the last are the tile's own.
std::array<PlacedChain, 4> chains_around(std::uint32_t tile, std::uint32_t colors);

/// A piece's position where it is placed.
UnitPosition moved_to(const UnitPosition& position, const std::array<std::int32_t, 2>& base);

/// The two ends of a chain: its corner points.
std::array<UnitPosition, 2> chain_ends(const ChainPieces& pieces, const PlacedChain& chain);

/// The border of a tile: its points, corners among them, counter-clockwise from the lower left corner on.
std::vector<UnitPosition> border_polygon(const ChainPieces& pieces, std::uint32_t tile);

/// The number of points inside a tile: as many as make up for its corner and its two own chains. Negative: there are
/// too many of these.
std::int64_t interior_size(const ChainPieces& pieces, std::uint32_t tile, std::uint32_t points_per_tile);

/// The pieces of a set. Throws InputError, a sentence that starts with the tile, where tiles differ in a piece that
/// they share, or where chains are longer than a tile has points.
ChainPieces chain_pieces_of(const PoissonTileSet& set);

/// The set with these pieces; every coordinate must be one that can be stored. Not certified.
PoissonTileSet tile_set_of(const ChainPieces& pieces, const PoissonTileParameters& parameters);

}
