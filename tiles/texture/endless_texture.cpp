#include "tiles/texture/endless_texture.hpp"

#include "runtime/texture_tiles.h"

namespace poissonlab {

std::uint32_t endless_place(TileKind kind, std::uint32_t seed, Color colors, std::uint32_t x, std::uint32_t y)
{
    return kind == TileKind::wang ? ttiles_wang_place(seed, colors, x, y) : ttiles_place(seed, colors, x, y);
}

TileIndex endless_index(TileKind kind, std::uint32_t seed, WangColors colors, std::uint32_t x, std::uint32_t y)
{
    if (kind == TileKind::wang) {
        const auto going_east = [&](std::uint32_t row) {
            return ttiles_edge_color(seed, colors.horizontal, x, row, 0);
        };
        const auto going_north = [&](std::uint32_t column) {
            return ttiles_edge_color(seed, colors.vertical, column, y, 1);
        };
        return wang_index({going_east(y + 1), going_north(x + 1), going_east(y), going_north(x)}, colors);
    }
    const auto corner = [&](std::uint32_t east, std::uint32_t north) {
        return ttiles_color(seed, colors.horizontal, x + east, y + north);
    };
    return corner_index({corner(1, 1), corner(1, 0), corner(0, 0), corner(0, 1)}, colors.horizontal);
}

std::uint32_t endless_texel(TileKind kind, std::uint32_t seed, Color colors, std::uint32_t size, std::uint32_t x,
                            std::uint32_t y, std::uint32_t column, std::uint32_t row)
{
    return kind == TileKind::wang ? ttiles_wang_texel(seed, colors, size, x, y, column, row)
                                  : ttiles_texel(seed, colors, size, x, y, column, row);
}

std::uint32_t endless_word(std::uint32_t seed, std::uint32_t x, std::uint32_t y)
{
    return ttiles_mix(ttiles_mix(ttiles_mix(seed) + x) + y);
}

std::uint32_t endless_turn(std::uint32_t word) { return ttiles_mix(word) >> 24; }

}
