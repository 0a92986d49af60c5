// Rows of tiles of a direct tiling, made from rows of lattice colours.
//
// Gives the tiles that direct_tiling.hpp gives, faster: neighbours in a row, and rows below each other, share
// lattice points, which are evaluated once.
#pragma once

#include "tiles/tilings/lattice_rows.hpp"
#include "tiles/tilings/tiling.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

class TileRows
{
public:
    /// Rows that are evaluated in one piece stay in the processor's cache.
    static constexpr std::size_t longest = 8192;

    /// Refers to the tiling, which must stay.
    explicit TileRows(const Tiling& tiling);

    /// The indices of the tiles from (x, y) eastwards, at most `longest` of them.
    void fill(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles);

private:
    void fill_corner(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles);
    void fill_corner_sums(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles);
    void fill_edges(std::int64_t x, std::int64_t y, std::span<TileIndex> tiles);

    const Tiling& tiling_;
    LatticeRows rows_;
    std::vector<std::uint8_t> north_; ///< edge colours, where these are sums
    std::vector<std::uint8_t> south_;
    std::vector<std::uint8_t> vertical_;
};

}
