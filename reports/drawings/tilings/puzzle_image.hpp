// Jigsaw puzzles of tile packings, for a laser cutter.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, figure 5.13.
#pragma once

#include "reports/drawings/drawing.hpp"
#include "tiles/packing/tile_packing.hpp"

namespace poissonlab {

/// The manner of cutting pieces.
struct PuzzleCut
{
    double piece = 30; ///< the side of a tile in millimetres
    double kerf = 0;   ///< the width of the cut in millimetres; 0: pieces share their cuts, each of which is there once
};

/// The lines to cut in red, a millimetre a unit, and a short blue line towards the north side of each piece, to be
/// engraved: pieces are not turned. With a kerf, pieces lie apart and their cuts around them, so that they keep their
/// size. The writer of SVG gives the document its size in millimetres.
Drawing draw_puzzle(const TilePacking& packing, const PuzzleCut& cut);

}
