// The eight Wang tiles over two colours the sum of whose edges is even, one_hash_wang_set(2), by their number there.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 3.2.1 and 3.3.2.2. Beside an edge lies any of four
// tiles, at a corner any.
#pragma once

#include "tiles/tilings/tile_index.hpp"

#include <cstddef>

namespace poissonlab {

inline constexpr std::size_t even_wang_tiles = 8;

/// The colours of a tile.
WangTile wang_colors_of(std::size_t tile);

/// The number of the tile with these colours, whose sum is even.
std::size_t even_wang_tile(const WangTile& colors);

/// Tells whether a tile may have another one beside it, at an offset of -1 to 1 tiles along either axis.
bool may_lie_beside(std::size_t tile, std::size_t other, int x, int y);

}
