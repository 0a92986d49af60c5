// The points of the pieces of a tile set while it is constructed.
#pragma once

#include "host/tile_construction/filling/tile_torus.hpp"
#include "tiles/poisson/tile_pieces.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// Points relative to the lowest corner of their piece's cell; negative on its lower side. Points of the plane that
/// have classes have them as their third coordinate.
using PiecePoints = std::vector<TilePosition>;

/// The number of a piece's points in each of the tiles around its cell. Bit k of the index: the tile at the upper
/// side of axis k, for axes along which the cell does not extend; others are 0.
using PartCounts = std::array<int, 8>;

PartCounts part_counts(const PiecePoints& points, std::uint8_t axes, int dimension);

class PieceStore
{
public:
    explicit PieceStore(const PoissonTileParameters& parameters);

    PiecePoints& at(std::uint8_t axes, std::uint32_t variant) { return pieces_[axes][variant]; }
    const PiecePoints& at(std::uint8_t axes, std::uint32_t variant) const { return pieces_[axes][variant]; }

    /// Appends the points of a piece where it is, on the torus.
    void place(const PlacedPiece& piece, std::vector<TilePosition>& points) const;

    /// The points of placed pieces, on the torus.
    std::vector<TilePosition> placed(std::span<const PlacedPiece> pieces) const;

private:
    std::array<std::vector<PiecePoints>, 8> pieces_;
};

/// The points of a torus that are in the region of a cell, relative to its lowest corner. `base`: the cell's,
/// 0 or 1 for each axis; on the torus of one tile, all cells with these axes are the same one.
PiecePoints cut_out(std::span<const TilePosition> points, const TileRegions& regions, std::uint8_t axes,
                    const std::array<std::int8_t, 3>& base, bool is_one_tile);

/// The number of the cell of a placed piece on the torus.
unsigned cell_number(const PlacedPiece& piece, int dimension);

// All points of a tile set with strips, piece by piece.

/// All points of a tile set with strips.
struct StripPieces
{
    PieceStore borders;
    std::vector<PiecePoints> interiors; ///< by tile
};

/// The set with these pieces: each tile's points near corners, edges, (faces), then those inside; those of each class
/// after those of the one before. Not certified.
PoissonTileSet tile_set_of(const StripPieces& pieces, const PoissonTileParameters& parameters);

/// The points of the pieces around a tile that are in it.
std::vector<UnitPosition> own_border_points(const PieceStore& borders, const PoissonTileParameters& parameters,
                                            std::uint32_t tile);

/// A position relative to a tile, of a point that is given relative to its piece's base.
TilePosition placed_at(const TilePosition& point, const std::array<std::int8_t, 3>& base);

bool is_in_tile(const TilePosition& position);

/// A position on the torus relative to the lattice point at 0.
TilePosition relative_to_base(const TilePosition& position);

/// The place on the torus of a position relative to the lattice point at 0.
TilePosition on_torus(const TilePosition& relative);

}
