// All points of a tile set with strips, piece by piece.
#pragma once

#include "host/tile_construction/piece_store.hpp"

#include <vector>

namespace poissonlab {

/// All points of a tile set with strips.
struct StripPieces
{
    PieceStore borders;
    std::vector<PiecePoints> interiors; ///< by tile
};

/// The set with these pieces: each tile's points near corners, edges, (faces), then those inside. Not certified.
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
