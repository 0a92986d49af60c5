// Packings by search.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.5.3: backtracking that places a tile at a time.
// Recursive packings of corner tiles are found by changing colours of corners one at a time instead, which takes
// seconds where backtracking takes days: of more than three colours none is known but the printed one.
#pragma once

#include "tiles/packing/tile_packing.hpp"

#include <cstdint>
#include <functional>

namespace poissonlab {

/// Is given a packing; false ends the search.
using PackingSink = std::function<bool(const TilePacking& packing)>;

/// The largest number of colours for which packings are searched tile by tile.
inline constexpr Color most_searched_colors = 4;

/// Hands on all packings of a kind, in lexicographic order of tiles from the south-west where `order` is empty. `order`
/// is a permutation of the tiles: the order in which they are tried. Two colours have 32 packings of corner tiles and
/// 203,520 of Wang tiles; with more, only the first ones can be waited for. Throws InputError for fewer than 2 colours
/// and more than 4, Interrupted.
void search_packings(TileKind kind, Color colors, const std::vector<TileIndex>& order, const PackingSink& sink);

/// The first packing with tiles tried in a random order. Throws as above.
TilePacking random_packing(TileKind kind, Color colors, std::uint64_t seed);

/// A packing of corner tiles over three colours that grows from one over two: the lower left 4 x 4 tiles are `block`.
/// Found by annealing the other colours, seconds. Throws Interrupted.
TilePacking grown_packing(const TilePacking& block, std::uint64_t seed);

}
