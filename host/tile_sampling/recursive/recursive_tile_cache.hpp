// Recursive Wang tiles that were built before.
#pragma once

#include "host/sampling/sampler.hpp"
#include "tiles/recursive/recursive_tile_set.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace poissonlab {

struct CachedRecursiveTiles
{
    RecursiveTileSet tiles;
    TileSetRecord record;
    double waiting_seconds = 0; ///< for another process that was building them
};

/// The tiles from `folder`, or built and put there: see cached_tile_set(), which does the same for other tiles.
CachedRecursiveTiles cached_recursive_tiles(std::uint32_t points_per_tile, std::uint64_t seed,
                                            const std::filesystem::path& folder,
                                            const std::function<void(const std::string& what)>& on_step = {});

}
