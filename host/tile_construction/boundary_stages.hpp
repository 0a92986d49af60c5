// The stages of construction before the interiors of tiles: which tori are filled, around which pieces, and
// which pieces are then cut out of them.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007: corner-based tiles, corners then edges (section 4.5),
// in 3D then faces (4.6); edge-based tiles, edges then corners (4.3). A torus of two tiles a side has room
// for several pieces at once, candidates of the same piece or pieces of other colours: edges between corners
// of two colours are made on a torus whose corners have these colours by turns.
#pragma once

#include "tiles/poisson/tile_pieces.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// A torus to be filled. Bases are 0 or 1 along each axis.
struct BoundaryTorus
{
    std::vector<PlacedPiece> held;
    std::vector<PlacedPiece> made;
};

/// Tori whose held pieces have the same cells.
struct BoundaryStage
{
    std::uint32_t number = 0;
    std::string name; ///< "corners", "edges" or "faces"
    std::vector<BoundaryTorus> tori;
    bool is_last = false; ///< next are the interiors
};

/// The stages in which the pieces of a tile set are made; template tiles have none: their frame is cut out of a master
/// tile.
std::vector<BoundaryStage> boundary_stages(const PoissonTileParameters& parameters);

/// The pieces of earlier stages that a piece touches, with the piece's own base at 0. Bases are -1, 0 or 1.
std::vector<PlacedPiece> earlier_neighbours(const PoissonTileParameters& parameters, std::uint8_t axes,
                                            std::uint32_t variant);

}
