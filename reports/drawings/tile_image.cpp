#include "reports/drawings/tile_image.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

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

namespace {

const std::string shared_corner_color = "#d0d0d0";

void add_wang_regions(std::vector<Shape>& shapes, const WangTile& tile, const DrawnSquare& square, RegionSizes sizes)
{
    const auto colors = edge_colors(tile);
    for (std::size_t i = 0; i < 4; ++i) {
        shapes.push_back(corner_region(square, sizes, i, shared_corner_color));
        shapes.push_back(edge_region(square, sizes, i, tile_color(colors[i])));
    }
}

void add_corner_regions(std::vector<Shape>& shapes, const CornerTile& tile, const DrawnSquare& square,
                        RegionSizes sizes)
{
    const auto colors = corner_colors(tile);
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string color = tile_color(colors[i]);
        shapes.push_back(corner_region(square, sizes, i, color));
        shapes.push_back(half_edge_region(square, sizes, i, false, edge_tint(color)));
        shapes.push_back(half_edge_region(square, sizes, (i + 3) % 4, true, edge_tint(color)));
    }
}

}

Drawing draw_tile_regions(const TileGrid& grid, double radius)
{
    if (!(radius > 0 && radius <= max_disk_region_radius))
        throw InputError(fmt::format("tile regions for the Poisson disk radius {}: must be above 0 and at "
                                     "most {:.4f} of the tile's side",
                                     radius, max_disk_region_radius));
    const RegionSizes sizes{std::min(0.5, radius * (1 + std::numbers::sqrt2)), radius};
    Drawing drawing = empty_tile_drawing(grid);
    for (std::size_t i = 0; i < grid.tiles.size(); ++i) {
        if (grid.kind == TileKind::wang)
            add_wang_regions(drawing.shapes, wang_tile(grid.tiles[i], grid.colors), tile_square(grid, i), sizes);
        else
            add_corner_regions(drawing.shapes, corner_tile(grid.tiles[i], grid.colors.horizontal), tile_square(grid, i),
                               sizes);
    }
    group_by_fill(drawing.shapes);
    for (std::size_t i = 0; i < grid.tiles.size(); ++i)
        add_region_outlines(drawing.shapes, tile_square(grid, i), sizes);
    add_tile_borders(drawing.shapes, grid, 0.6);
    return drawing;
}

}
