// Tilings with Ammann's 16 tiles by substitution.
//
// Stam, Aperiodic texture mapping, 1997, after Gruenbaum and Shephard, Tilings and Patterns, 1986, p. 595: every tile
// becomes one, two or four tiles, two columns where its column is wide and two rows where its row is high. The sides of
// the square that a tile becomes are Fibonacci numbers.
//
// Tilings with constructed corner tiles, from tilings with the Wang tiles that they were made of.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 8.3, figures 8.7 to 8.9 and 8.12: where the lattice of
// corner tiles lies over that of Wang tiles.
#pragma once

#include "tiles/aperiodic/corner_constructions.hpp"
#include "tiles/aperiodic/tile_list.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace poissonlab {

/// The places of tilings along both axes: what one tile becomes has 2,584 columns and rows at least.
inline constexpr std::int64_t ammann_first = -610;
inline constexpr std::int64_t ammann_end = 1974;

/// The tiles of a window: positions in ammann_tiles(), rows from north to south. The seed chooses the tile that all
/// comes of; (ammann_first, ammann_first) is the lower left tile of it. Throws InputError for windows beyond the
/// limits, and Interrupted.
std::vector<ListPlace> ammann_tiles_of(const TileWindow& window, std::uint64_t seed);

/// Gives the tiles of any window of one tiling: positions in its set, rows from north to south.
using WindowMaker = std::function<std::vector<ListPlace>(const TileWindow&)>;

/// The window of the tiling with `corners`, made of `wang` by the construction, that lies over a tiling with `wang`.
/// Corner tile (0, 0) has its south-west corner in the middle of Wang tile (0, 0) (diagonal), on the middle of its
/// southern edge (horizontal) or its western edge (vertical), is its south-western quarter (subdivision), or the white
/// tile of it (rotation), of which the tile to the east lies to the north-east of the Wang tile. Throws
/// std::logic_error for a corner tile that is not in the set, and what `make_window` throws.
std::vector<ListPlace> corner_tiles_of(const WangList& wang, const CornerList& corners, CornerConstruction construction,
                                       const TileWindow& window, const WindowMaker& make_window);

}
