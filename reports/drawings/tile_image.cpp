#include "reports/drawings/tile_image.hpp"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace poissonlab {
namespace {

constexpr double tile_size = 32;
constexpr double tile_gap = 8;

/// The distance from one tile to the next.
double pitch(const TileGrid& grid) { return tile_size + (grid.has_gaps ? tile_gap : 0); }

void add_tile(std::vector<Shape>& shapes, const auto& tile, const DrawnSquare& square)
{
    for (const TileShape& shape : shapes_of(tile)) {
        Polygon polygon;
        for (const auto& [x, y] : shape.corners) polygon.push_back(square.at(x, y));
        shapes.push_back({std::move(polygon), tile_color(shape.color), {}});
    }
}

/// Tiles at their places, with their borders.
template <class Tile>
Drawing drawn(const TileGrid& grid, std::span<const Tile> tiles)
{
    Drawing drawing = empty_tile_drawing(grid);
    for (std::size_t i = 0; i < tiles.size(); ++i) add_tile(drawing.shapes, tiles[i], tile_square(grid, i));
    group_by_fill(drawing.shapes);
    add_tile_borders(drawing.shapes, grid, 1);
    return drawing;
}

}

Drawing empty_tile_drawing(const TileGrid& grid)
{
    if (axes_of(grid.kind) == 3) throw std::logic_error("cubes are no flat tiles");
    const auto length = [&](std::size_t tiles) {
        return 2 * tile_gap + static_cast<double>(tiles) * pitch(grid) - (pitch(grid) - tile_size);
    };
    const std::size_t columns = std::max<std::size_t>(1, grid.columns);
    const std::size_t rows = std::max<std::size_t>(1, (grid.tiles.size() + columns - 1) / columns);
    return {length(columns), length(rows), {}};
}

DrawnSquare tile_square(const TileGrid& grid, std::size_t tile)
{
    const auto column = static_cast<double>(tile % grid.columns);
    const auto row = static_cast<double>(tile / grid.columns);
    return {
        {tile_gap + column * pitch(grid), tile_gap + row * pitch(grid) + tile_size}, {tile_size, 0}, {0, -tile_size}};
}

void add_tile_borders(std::vector<Shape>& shapes, const TileGrid& grid, double width)
{
    for (std::size_t i = 0; i < grid.tiles.size(); ++i)
        shapes.push_back({tile_square(grid, i).outline(), {}, "#000000", width});
}

Drawing draw_tiles(const TileGrid& grid, std::span<const WangTile> tiles) { return drawn(grid, tiles); }

Drawing draw_tiles(const TileGrid& grid, std::span<const CornerTile> tiles) { return drawn(grid, tiles); }

Drawing draw_tiles(const TileGrid& grid)
{
    const auto drawn_as = [&](const auto& tile_of) {
        std::vector<std::decay_t<decltype(tile_of(0))>> tiles;
        for (const TileIndex tile : grid.tiles) tiles.push_back(tile_of(tile));
        return drawn<typename decltype(tiles)::value_type>(grid, tiles);
    };
    const Color colors = grid.colors.horizontal;
    if (grid.kind == TileKind::wang) return drawn_as([&](TileIndex tile) { return wang_tile(tile, grid.colors); });
    if (grid.kind == TileKind::domino) return drawn_as([&](TileIndex tile) { return domino(tile, colors); });
    return drawn_as([&](TileIndex tile) { return corner_tile(tile, colors); });
}

}
