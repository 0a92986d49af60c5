// Tilings with Ammann's 16 tiles by substitution.
//
// Stam, Aperiodic texture mapping, 1997, after Gruenbaum and Shephard, Tilings and Patterns, 1986, p. 595: every tile
// becomes one, two or four tiles, two columns where its column is wide and two rows where its row is high. The sides of
// the square that a tile becomes are Fibonacci numbers.
#pragma once

#include "tiles/aperiodic/tile_list.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <vector>

namespace poissonlab {

/// The places of tilings along both axes: what one tile becomes has 2,584 columns and rows at least.
inline constexpr std::int64_t ammann_first = -610;
inline constexpr std::int64_t ammann_end = 1974;

/// The tiles of a window: positions in ammann_tiles(), rows from north to south. The seed chooses the tile that all
/// comes of; (ammann_first, ammann_first) is the lower left tile of it. Throws InputError for windows beyond the
/// limits, and Interrupted.
std::vector<ListPlace> ammann_tiles_of(const TileWindow& window, std::uint64_t seed);

}
