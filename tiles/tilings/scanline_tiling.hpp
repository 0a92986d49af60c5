// Scanline stochastic tilings: tiles are placed row by row, each chosen at random among those that fit.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.2: from west to east and from north to
// south, after Cohen et al. for Wang tiles. Any tile set will do that has, for all colours on the sides that
// are placed already, tiles that fit; complete and compact sets have at least two.
//
// A compact set of Wang cubes, and scanlines in space.
//
// Cohen, Shade, Hiller and Deussen, Wang Tiles for Image and Texture Generation, 2003, section 5.
#pragma once

#include "base/random/random.hpp"
#include "tiles/tilings/cube_tiling.hpp"
#include "tiles/tilings/tile_set.hpp"
#include "tiles/tilings/tiling.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// The most colours: with more, the tiles for each pattern of colours take too much memory.
constexpr Color max_scanline_colors = 32;

/// The widest tiling: a row is kept in memory.
constexpr std::uint64_t max_scanline_width = std::uint64_t{1} << 32;

/// The tiles of a set of Wang or corner tiles that fit where their neighbours to the north and west are
/// placed.
class FittingTiles
{
public:
    /// Throws InputError for more than max_scanline_colors.
    explicit FittingTiles(const TileSet& tiles);

    /// The tiles that fit below one tile and to the right of another; either may be missing (nullptr), as at the
    /// borders.
    std::span<const TileIndex> choices(const TileIndex* north, const TileIndex* west) const;

    /// The fewest tiles that fit anywhere in any tiling, borders included.
    std::size_t fewest_choices() const;

private:
    std::size_t pattern(const TileIndex* north, const TileIndex* west) const;

    TileKind kind_;
    WangColors colors_;
    std::vector<TileIndex> tiles_;      ///< pattern after pattern
    std::vector<std::uint32_t> begins_; ///< of each pattern's tiles, and the end
};

/// A tiling of some width, and any height. Unlike direct tilings it is known only as far as it was placed.
class ScanlineTiling
{
public:
    /// Set and seed decide the tiling; a narrower one is the west of a wider one. Throws InputError if the set leaves
    /// no choice of two tiles somewhere: then tilings would repeat, or end.
    ScanlineTiling(const TileSet& tiles, std::uint64_t width, std::uint64_t seed);

    /// The indices of the tiles of the next row; the first call gives the northernmost. Valid until the next
    /// call.
    std::span<const TileIndex> next_row();

    /// Hands a tiling of `height` rows, of which the southernmost has y = 0, to `sink`, which is given whole
    /// rows from north to south.
    void stream(std::uint64_t height, const TileSink& sink);

private:
    FittingTiles fitting_;
    StreamKey key_;
    std::uint64_t rows_ = 0; ///< placed so far
    std::vector<TileIndex> row_;
};

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
