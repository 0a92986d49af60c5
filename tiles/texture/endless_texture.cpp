#include "tiles/texture/endless_texture.hpp"

#include "runtime/texture_tiles.h"

namespace poissonlab {

std::uint32_t endless_place(TileKind kind, std::uint32_t seed, Color colors, std::uint32_t x, std::uint32_t y)
{
    return kind == TileKind::wang ? ttiles_wang_place(seed, colors, x, y) : ttiles_place(seed, colors, x, y);
}

}
