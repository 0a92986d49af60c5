// The tiles of a tiling as its result stores them.
#pragma once

#include "results/pictures/tiling_result.hpp"

#include <filesystem>
#include <vector>

namespace poissonlab {

/// The tile indices that a tiling's file holds, as many as shown(), row after row as they are stored. Throws
/// InputError for another number of them, and for indices that no tile has.
std::vector<TileIndex> read_tiles(const std::filesystem::path& folder, const TilingResult& tiling);

}
