// Tile sets and tilings of an experiment: their tiles as text, and how random the colours of a tiling are.
#pragma once

#include "host/scenes/shown_tiling.hpp"
#include "results/pictures/tiling_result.hpp"

#include <string>

namespace poissonlab {

inline constexpr int statistics_lags = 320; ///< beyond the 256 after which the shortest hash function repeats

/// The text of tiles.txt: indices separated by blanks, a row a line, north first; of cubes, layers from the
/// bottom, an empty line between them; of a set, all tiles in one line.
std::string tiles_text(const ShownTiling& config);

/// The statistics of the tiling as it would be without its period, after which it repeats because the config says so.
TilingStatistics tiling_statistics(const ShownTiling& config);

}
