// Which tile of an isohedral tiling a place is in, and where in the tile: in integers, the same everywhere.
//
// Places are along the translations T1 and T2, in units of 2^-26 of these: there every unit of the tiling is a square,
// so that a place is reduced to one by a mask. Corners of outlines are rounded to such units, those that tiles have in
// common to the same ones, so that rounded tiles still fill the plane without gaps; a place on an edge is in the tile
// to its right, and so in exactly one. kernels/tile_finder.cl does the same.
#pragma once

#include "tiles/isohedral/isohedral_tile.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

inline constexpr int lattice_bits = 26;

/// A place along the translations; column and row of a unit have 32 bits.
using LatticePoint = std::array<std::int64_t, 2>;

struct FoundTile
{
    TilePlace place;
    std::array<std::int32_t, 2> offset{}; ///< from the middle of the tile, along the translations

    bool operator==(const FoundTile&) const = default;
};

/// A tile that reaches into the unit at (0, 0); places as of its own unit.
struct LookupCandidate
{
    TilePlace place;
    std::size_t first = 0; ///< corner of its outline
    std::size_t count = 0;
    std::array<std::int32_t, 2> low{}, high{}; ///< what it reaches
    std::array<std::int32_t, 2> anchor{};      ///< its middle
};

struct TileLookup
{
    /// Throws InputError where rounding makes corners meet that are not the same.
    explicit TileLookup(const IsohedralTile& tile);

    std::vector<std::array<std::int32_t, 2>> corners; ///< of all aspects, one after the other
    std::vector<LookupCandidate> candidates;          ///< by aspect, row, column
    std::array<PlanePoint, 2> translations;

    /// The lattice point nearest to a point of the plane.
    LatticePoint lattice_point(const PlanePoint& point) const;

    /// The offset of a found tile as a vector of the plane; the inverse of the tile's motion takes it into the tile.
    PlanePoint offset_of(const FoundTile& found) const;
};

namespace reference {
/// The tiles of all places.
std::vector<FoundTile> find_tiles(const TileLookup& lookup, std::span<const LatticePoint> points);
}

}
