// Packings: as they are printed, from Eulerian circuits, and grown around others.
//
// Recursive packings of corner tiles are found by changing colours of corners one at a time, which takes seconds where
// backtracking takes days: of more than three colours none is known but the printed one.
#pragma once

#include "tiles/packing/tile_packing.hpp"

#include <cstdint>

namespace poissonlab {

/// A packing of corner tiles over three colours that grows from one over two: the lower left 4 x 4 tiles are `block`.
/// Found by annealing the other colours, seconds. Throws Interrupted.
TilePacking grown_packing(const TilePacking& block, std::uint64_t seed);

// The packings of four colours that were found by search, over 280 days and 23 years of CPU time, and the one that
// shows the outer product.
//
// Lagae and others, Tile-Based Methods for Interactive Applications, SIGGRAPH 2008 class notes, figures 5.10 to 5.12:
// the dissertation's figures 5.10 to 5.12 with numbers.

/// The numbers of colours that printed_packing() has.
inline constexpr Color most_printed_colors = 4;

/// The lower left C^2 x C^2 block, C = 2, 3 or 4, of figure 5.11 (corner tiles) or 5.12 (Wang tiles): they are
/// recursive, so that each block is a packing of its own. Throws InputError for other numbers of colours.
TilePacking printed_packing(TileKind kind, Color colors);

/// Figure 5.10: Wei's packing of Wang tiles over three colours.
TilePacking printed_product_packing();

// Packings of Wang tiles from random Eulerian circuits.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 5.5.1 and 5.5.2: dominoes are the edges of a
// directed graph whose vertices are colours. D. takes any circuit; these are equally likely, by the bijection behind
// the BEST theorem (van Aardenne-Ehrenfest and de Bruijn 1951): a random tree of last exits, and any order of the
// others.

/// A circle of C^2 colours in which every pair of neighbours occurs once, beginning with 0 0: each such circle is
/// equally likely. Circles with different numbers are independent.
std::vector<Color> random_euler_circle(Color colors, std::uint64_t seed, std::uint32_t number);

/// The outer product of two random circles, the first from west to east. Throws InputError for fewer than 2 colours and
/// more than 32.
TilePacking euler_packing(Color colors, std::uint64_t seed);

}
