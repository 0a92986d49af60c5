// Which tiles endless textures have where, and where those lie in their atlas, as runtime/texture_tiles.h has it for
// other programs.
#pragma once

#include "tiles/tilings/tile_set.hpp"

#include <cstdint>

namespace poissonlab {

/// The place in the atlas, y C^2 + x from the lower left, of the tile whose lower left corner is the lattice point (x,
/// y), modulo 2^32. Tiles are corner or Wang tiles.
std::uint32_t endless_place(TileKind kind, std::uint32_t seed, Color colors, std::uint32_t x, std::uint32_t y);

/// The index of that tile; Wang tiles may have other numbers of colours of horizontal and of vertical edges.
TileIndex endless_index(TileKind kind, std::uint32_t seed, WangColors colors, std::uint32_t x, std::uint32_t y);

/// The texel in the atlas, by its number in rows from the north, so far from the lower left of that tile of `size`
/// texels.
std::uint32_t endless_texel(TileKind kind, std::uint32_t seed, Color colors, std::uint32_t size, std::uint32_t x,
                            std::uint32_t y, std::uint32_t column, std::uint32_t row);

/// The word of a lattice point, of which its colour is the remainder.
std::uint32_t endless_word(std::uint32_t seed, std::uint32_t x, std::uint32_t y);

/// The number below 256 of the angle by which the piece of a lattice point with this word turns.
std::uint32_t endless_turn(std::uint32_t word);

}
