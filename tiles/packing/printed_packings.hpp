// The packings of four colours that were found by search, over 280 days and 23 years of CPU time, and the one that
// shows the outer product.
//
// Lagae and others, Tile-Based Methods for Interactive Applications, SIGGRAPH 2008 class notes, figures 5.10 to 5.12:
// the dissertation's figures 5.10 to 5.12 with numbers.
#pragma once

#include "tiles/packing/tile_packing.hpp"

namespace poissonlab {

/// The numbers of colours that printed_packing() has.
inline constexpr Color most_printed_colors = 4;

/// The lower left C^2 x C^2 block, C = 2, 3 or 4, of figure 5.11 (corner tiles) or 5.12 (Wang tiles): they are
/// recursive, so that each block is a packing of its own. Throws InputError for other numbers of colours.
TilePacking printed_packing(TileKind kind, Color colors);

/// Figure 5.10: Wei's packing of Wang tiles over three colours.
TilePacking printed_product_packing();

}
