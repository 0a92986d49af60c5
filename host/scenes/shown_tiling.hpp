// The settings of tables [[tile_set]] and [[tiling]] of a config, and of the command `tiling`.
#pragma once

#include "host/settings/tilings/tiling_request.hpp"

#include <cstdint>
#include <string>

namespace poissonlab {

/// The most tiles of a picture.
inline constexpr std::uint64_t max_shown_tiles = 20'000;

struct ShownTiling
{
    std::string set; ///< one of tile_set_names(), or given_tiles_word: a tile set; empty: a tiling
    TilingRequest request;
    CubeWindow window{0, 0, 0, 16, 16, 1}; ///< of a tiling
    double regions = 0;   ///< Poisson disk radius in units of the tile whose regions are drawn; 0: none
    bool is_drawn = true; ///< else it is printed, which has no end

    bool is_set() const { return !set.empty(); }
};

/// The set that is drawn, or that the tiling takes its tiles from.
TileSet tile_set_of(const ShownTiling& shown);

}
