// The tables [[tile_set]] and [[tiling]] of a config: tiles that are drawn and, of tilings, tested.
#pragma once

#include "host/config/config_tree.hpp"
#include "host/config/tiling_request.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The most tiles of a picture.
inline constexpr std::uint64_t max_shown_tiles = 20'000;

struct TilingConfig
{
    std::string set; ///< one of tile_set_names(), or given_tiles_word: a tile set; empty: a tiling
    TilingRequest request;
    CubeWindow window;  ///< of a tiling: what is drawn
    double regions = 0; ///< Poisson disk radius in units of the tile whose regions are drawn; 0: tiles are
    std::string label;  ///< never empty
    SourceLocation where;

    bool is_set() const { return !set.empty(); }
};

/// The set that is drawn, or that the tiling takes its tiles from.
TileSet tile_set_of(const TilingConfig& config);

/// Reads both kinds of tables of a config, sets first. Throws InputError with the place of what is wrong.
std::vector<TilingConfig> read_tilings(const ConfigTable& config, std::uint64_t seed);

}
