#include "tiles/tilings/even_wang_tiles.hpp"

#include "tiles/tilings/tile_set.hpp"

namespace poissonlab {
namespace {

constexpr WangColors even_tile_colors{2, 2};

const TileSet& even_wang_set()
{
    static const TileSet set = one_hash_wang_set(2);
    return set;
}

}

WangTile wang_colors_of(std::size_t tile) { return wang_tile(even_wang_set().index(tile), even_tile_colors); }

std::size_t even_wang_tile(const WangTile& colors)
{
    return static_cast<std::size_t>(even_wang_set().position(wang_index(colors, even_tile_colors)).value());
}

bool may_lie_beside(std::size_t tile, std::size_t other, int x, int y)
{
    const WangTile a = wang_colors_of(tile), b = wang_colors_of(other);
    if (x != 0 && y != 0) return true;
    if (x != 0) return x > 0 ? a.east == b.west : a.west == b.east;
    return y > 0 ? a.north == b.south : a.south == b.north;
}

}
