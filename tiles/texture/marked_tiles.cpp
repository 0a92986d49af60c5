#include "tiles/texture/marked_tiles.hpp"

namespace poissonlab {
namespace {

/// The mark of an edge's western or southern end, and that of the other one.
constexpr Color first_mark(Color edge) { return edge / 2 % 2; }
constexpr Color last_mark(Color edge) { return edge % 2; }

WangTile without_marks(const WangTile& t)
{
    return {unmarked_edge(t.north), unmarked_edge(t.east), unmarked_edge(t.south), unmarked_edge(t.west)};
}

/// The colours within their classes.
CornerTile without_marks(const CornerTile& t, Color in_class)
{
    return {t.north_east % in_class, t.south_east % in_class, t.south_west % in_class, t.north_west % in_class};
}

}

WangTile marked_wang_tile(const WangTile& edges, const CornerTile& marks)
{
    return {marked_edge(edges.north, marks.north_west, marks.north_east),
            marked_edge(edges.east, marks.south_east, marks.north_east),
            marked_edge(edges.south, marks.south_west, marks.south_east),
            marked_edge(edges.west, marks.south_west, marks.north_west)};
}

std::vector<TextureTile> marked_wang_tiles(const std::vector<TextureTile>& edges, WangColors colors)
{
    std::vector<TextureTile> tiles;
    for (const TextureTile& tile : edges)
        for (TileIndex marks = 0; marks < 16; ++marks)
            tiles.push_back({wang_index(marked_wang_tile(wang_tile(tile.index, colors), corner_tile(marks, 2)),
                                        marked_colors(colors)),
                             tile.variant});
    return tiles;
}

std::vector<TextureTile> randomly_marked_wang_tiles(const std::vector<TextureTile>& edges, WangColors colors)
{
    std::vector<TextureTile> tiles = marked_wang_tiles(edges, colors);
    std::erase_if(tiles, [&](const TextureTile& tile) {
        const WangTile t = wang_tile(tile.index, marked_colors(colors));
        const bool is_first = unmarked_edge(t.east) == unmarked_edge(t.north) % colors.vertical;
        return is_first == (last_mark(t.south) == 1);
    });
    return tiles;
}

CornerTile marks_of(const TextureSet& set, TileIndex index)
{
    if (!set.has_corners()) {
        const WangTile t = wang_tile(index, set.colors);
        return {last_mark(t.north), last_mark(t.south), first_mark(t.south), first_mark(t.north)};
    }
    const CornerTile t = corner_tile(index, set.colors.horizontal);
    const Color in_class = set.colors.horizontal / 2;
    return {t.north_east / in_class, t.south_east / in_class, t.south_west / in_class, t.north_west / in_class};
}

bool differ_in_marks_alone(const TextureSet& set, TileIndex a, TileIndex b)
{
    const Color colors = set.colors.horizontal;
    if (set.has_corners())
        return without_marks(corner_tile(a, colors), colors / 2) == without_marks(corner_tile(b, colors), colors / 2);
    return without_marks(wang_tile(a, set.colors)) == without_marks(wang_tile(b, set.colors));
}

bool agrees_on_marks(const WangTile& tile)
{
    return last_mark(tile.north) == last_mark(tile.east) && first_mark(tile.north) == last_mark(tile.west) &&
           last_mark(tile.south) == first_mark(tile.east) && first_mark(tile.south) == first_mark(tile.west);
}

}
