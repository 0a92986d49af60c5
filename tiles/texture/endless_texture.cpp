#include "tiles/texture/endless_texture.hpp"

#include "runtime/texture_tiles.h"

namespace poissonlab {

std::uint32_t endless_place(std::uint32_t seed, Color colors, std::uint32_t x, std::uint32_t y)
{
    return ttiles_place(seed, colors, x, y);
}

}
