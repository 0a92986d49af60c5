// Pictures of packings: tiles, the corners of Wang tiles, puzzles, rows of dominoes and their graph.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.5, figures 5.7 to 5.13.
#pragma once

#include "results/pictures/mark_picture.hpp"
#include "tiles/packing/tile_packing.hpp"

namespace poissonlab {

/// Wei's second packing (D. section 5.4): what may meet at a corner of Wang tiles is two vertical and two horizontal
/// edges, four colours as a tile has them, and those beside each other share an edge as tiles do.
MarkPicture drawn_corner_packing(const TilePacking& packing);

/// All tiles with their numbers and colours.
MarkPicture drawn_packing(const TilePacking& packing);

/// Pieces with lines between them, each tile's number where a picture would be.
MarkPicture drawn_puzzle(const TilePacking& packing);

/// All dominoes, apart from each other, or in the order of Wei's circle.
MarkPicture drawn_dominoes(Color colors, bool is_packed);

/// A vertex a colour and an edge a domino: an Eulerian circuit is a packing (D. figure 5.8).
MarkPicture drawn_graph(Color colors);

}
