// A stochastic tiling as a value: it knows its tile set, and gives the tile at any place in constant time.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 3.3. Regions are streamed, never stored.
#pragma once

#include "tiles/tilings/tile_lattice.hpp"
#include "tiles/tilings/tile_set.hpp"

#include <cstdint>
#include <functional>
#include <span>

namespace poissonlab {

/// A rectangle of tiles: those with x <= tile x < x + width, and the same for y.
struct TileWindow
{
    std::int64_t x = 0;
    std::int64_t y = 0;
    std::uint64_t width = 0;
    std::uint64_t height = 0;
};

/// Is given tile indices from (x, y) eastwards.
using TileSink = std::function<void(std::int64_t x, std::int64_t y, std::span<const TileIndex> tiles)>;

enum class DirectAlgorithm
{
    corner,          ///< corner tiles
    wang_two_hashes, ///< complete Wang tile set
    wang_one_hash,   ///< compact Wang tile set of C^3 tiles
    wang_edge_hash,  ///< complete Wang tile set
};

class Tiling
{
public:
    /// Throws InputError for numbers of colours that the tile set or hash function cannot have, for a period
    /// that is negative or 2^62 or more, and for horizontal and vertical colours that differ where the
    /// algorithm needs them to be the same.
    Tiling(DirectAlgorithm algorithm, WangColors colors, const HashChoice& hash, std::uint64_t seed,
           Period period = {});

    DirectAlgorithm algorithm() const { return algorithm_; }
    const TileSet& tile_set() const { return tile_set_; }
    Period period() const { return period_; }

    /// The hash function at corners or horizontal edges, and the one for vertical edges.
    const ColorHash& hash() const { return horizontal_; }
    const ColorHash& vertical_hash() const { return vertical_; }

    /// The index of the tile whose lower left corner is (x, y).
    TileIndex tile(std::int64_t x, std::int64_t y) const;

    /// The indices of the tiles from (x, y) eastwards.
    void fill_row(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles) const;

    /// Hands a window's tiles to `sink`, rows from north to south, each from west to east; rows longer than
    /// 8192 tiles in pieces of that length. Memory does not depend on the window.
    void stream(const TileWindow& window, const TileSink& sink) const;

private:
    DirectAlgorithm algorithm_;
    WangColors colors_;
    TileSet tile_set_;
    Period period_;
    ColorHash horizontal_;
    ColorHash vertical_;
};

}
