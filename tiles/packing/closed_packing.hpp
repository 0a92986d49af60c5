// Packings in closed form for every number of colours: the tile at a place and the place of a tile, both in constant
// time and without tables.
//
// Wang tiles: Wei, Tile-Based Texture Mapping on Graphics Hardware, 2004; D. sections 5.5.1 and 5.5.2: a row of
// dominoes in the order of an Eulerian circuit, and its outer product with itself.
// Corner tiles: D. 5.5.3 leaves a closed form open. Here neighbouring columns are one de Bruijn cycle of pairs,
// shifted by each shift once (odd numbers of colours; the shifts then sum to 0), or a packing of two colours says where
// the digits of four columns and rows go (even numbers).
#pragma once

#include "tiles/packing/tile_packing.hpp"

namespace poissonlab {

/// The colour at place n of a circle of C^2 colours in which every pair of neighbours occurs once: 0 0 1 0 2 1 1 2 2.
Color euler_color(Color n, Color colors);

/// The place of a pair in that circle: euler_color(n) = first and euler_color(n + 1) = second, circularly.
Color euler_place(Color first, Color second, Color colors);

/// The place of a domino in Wei's order, in which colours below k fill the first k^2 places for every k.
Color wei_place(Color west, Color east);

/// The domino's western colour at a place of Wei's order; its eastern one is that of the next place.
Color wei_color(Color place);

/// The colour of the lower left corner at a place of the torus; x and y below C^2.
Color packed_corner_color(PackingPlace place, Color colors);

/// The tile at a place of the closed packing, and the place of a tile. Wang tiles have Wei's packing.
TileIndex packed_tile(TileKind kind, PackingPlace place, Color colors);
PackingPlace place_of_tile(TileKind kind, TileIndex tile, Color colors);

/// All tiles of the closed packing. Throws InputError for fewer than 2 colours and more than 32, whose million of tiles
/// are as many as are held at a time.
TilePacking closed_packing(TileKind kind, Color colors);

}
