// Arithmetic on rows of colours, compiled for the processor's vectors.
#pragma once

#include "tiles/tilings/tile_index.hpp"

#include <cstdint>
#include <span>

namespace poissonlab {

/// tiles[i]: the index of the corner tile between lattice points i and i + 1 of a row (`south`) and the row
/// above it (`north`), each of one point more than there are tiles.
void index_corner_tiles(const std::uint8_t* south, const std::uint8_t* north, Color colors, std::span<TileIndex> tiles);

/// tiles[i]: the index of the Wang tile with these horizontal edges i, and vertical edges i and i + 1.
void index_wang_tiles(const std::uint8_t* north, const std::uint8_t* south, const std::uint8_t* vertical,
                      WangColors colors, std::span<TileIndex> tiles);

/// sums[i] = (a[i] + b[i]) % colors.
void add_colors(const std::uint8_t* a, const std::uint8_t* b, Color colors, std::span<std::uint8_t> sums);

}
