// A compact set of Wang cubes, and scanlines in space.
//
// Cohen, Shade, Hiller and Deussen, Wang Tiles for Image and Texture Generation, 2003, section 5.
#pragma once

#include "tiles/tilings/cube_tiling.hpp"

namespace poissonlab {

/// The C^5 Wang cubes whose six colours sum to 0 modulo C: 32 for two colours, as many as the article
/// wants and does not name. Each triple of colours of faces that meet at a
/// corner leaves C^2 choices, in which any two of the other three faces are free: all cubes are as frequent in a tiling
/// by scanlines. In the plane this rule gives Cohen's eight tiles.
TileSet compact_wang_cube_set(Color colors);

/// Hands a box of Wang cubes by scanlines in space, from (0, 0, 0) on, to `sink`: layers from the bottom to the top,
/// rows from north to south, cubes from west to east. Each is chosen at random among those of the complete set, or of
/// compact_wang_cube_set(), that fit to the cubes to the west, to the north and below. `colors` are ones that the set
/// can have. Throws InputError for layers of more than 2^26 cubes, one of which is kept in memory.
void stream_scanline_cubes(Color colors, bool is_compact, std::uint64_t seed, std::uint64_t width, std::uint64_t height,
                           std::uint64_t depth, const CubeSink& sink);

}
