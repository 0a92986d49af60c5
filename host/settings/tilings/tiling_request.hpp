// A stochastic tiling or a tile set as users ask for it, by names: what the command `tiling` and the tables
// [[tiling]] and [[tile_set]] of a config have in common.
#pragma once

#include "tiles/tilings/cube_tiling.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// The tiling algorithms of a kind, the default first; also the words of aperiodic sets that there are tilings of.
const std::vector<std::string>& tiling_algorithms(TileKind kind);

/// The tile sets of a kind, the default first: "complete"; "compact" (for scanlines); of Wang tiles also
/// "one-hash", the compact set of that algorithm, and "corner", the set that is equivalent to the complete
/// corner tile set; and the words of aperiodic sets.
const std::vector<std::string>& tile_set_names(TileKind kind);

/// The word for tilings whose tiles are given one by one.
inline constexpr auto given_tiles_word = "indices";

struct TilingRequest
{
    TileKind kind = TileKind::corner;
    Color colors = 2;
    Color vertical_colors = 0;        ///< of the vertical edges of Wang tiles; 0: as many as `colors`
    std::string algorithm = "direct"; ///< one of tiling_algorithms(kind), or given_tiles_word
    HashKind hash = HashKind::long_period;
    std::vector<std::uint32_t> entries{}; ///< of the hash function's tables, its range first; none: the default ones
    std::uint64_t seed = 1;
    Period period;
    std::vector<TileIndex> given{}; ///< rows of tiles from north to south, from (0, 0) on; or those of a set
    std::uint64_t given_width = 0;

    HashChoice hash_choice() const { return {hash, entries}; }

    WangColors all_colors() const { return {colors, vertical_colors > 0 ? vertical_colors : colors}; }

    bool is_given() const { return algorithm == given_tiles_word; }

    bool is_scanline() const { return algorithm.starts_with("scanline"); }

    /// True for tilings with an aperiodic set, which have no hash function and never close.
    bool is_aperiodic() const;

    /// True for tilings by hash functions.
    bool is_direct() const { return !is_scanline() && !is_aperiodic() && !is_given(); }
};

/// The only number of colours that a set or a tiling with this word can have; 0: there are several.
Color own_colors(TileKind kind, const std::string& word);

/// A set of tile_set_names(kind). Throws InputError for numbers of colours that it cannot have.
TileSet make_tile_set(TileKind kind, WangColors colors, const std::string& name);

/// Checks the tiles that a request gives: whole rows of tiles of the complete set whose neighbours fit. Throws
/// InputError for the first that does not.
void check_given_tiles(const TilingRequest& request);

/// After how many lattice points the hash functions of a direct tiling repeat, both of them where there are two; 0:
/// they never do, or after more than 2^64 - 1.
HashPeriod hash_period_of(const TilingRequest& request);

/// The set that the tiling takes its tiles from.
TileSet tile_set_of(const TilingRequest& request);

/// Wang and corner tiles. Throws InputError for what the tiling cannot have.
Tiling make_direct_tiling(const TilingRequest& request);

/// Hands the tiles of a window to `sink`, rows from north to south, west to east, long rows in pieces; of
/// cubes, layers from the bottom to the top; of dominoes, one row. Of a scanline tiling the window must be at (0, 0),
/// of given tiles it must be inside of them. Depth and z are those of cubes only. Throws InputError.
void stream_tiles(const TilingRequest& request, const CubeWindow& window, const CubeSink& sink);

}
