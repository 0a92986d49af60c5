// Packings of Wang tiles from random Eulerian circuits.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 5.5.1 and 5.5.2: dominoes are the edges of a
// directed graph whose vertices are colours. D. takes any circuit; these are equally likely, by the bijection behind
// the BEST theorem (van Aardenne-Ehrenfest and de Bruijn 1951): a random tree of last exits, and any order of the
// others.
#pragma once

#include "tiles/packing/tile_packing.hpp"

#include <cstdint>

namespace poissonlab {

/// A circle of C^2 colours in which every pair of neighbours occurs once, beginning with 0 0: each such circle is
/// equally likely. Circles with different numbers are independent.
std::vector<Color> random_euler_circle(Color colors, std::uint64_t seed, std::uint32_t number);

/// The outer product of two random circles, the first from west to east. Throws InputError for fewer than 2 colours and
/// more than 32.
TilePacking euler_packing(Color colors, std::uint64_t seed);

}
